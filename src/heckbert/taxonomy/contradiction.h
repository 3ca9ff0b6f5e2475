#pragma once
// Why an expression has no path at all. Only '&', '-' and '!' can take every path away, so the reason is a smallest set
// of their operands that leaves nothing, and, of two operands, what each demands: "every path of 'LD*E' has no event
// but D, and every path of 'L.*S.*E' has S". Demands are looked for among those that people think in: the ends, which
// events occur, which must, how many, and what stands next to an end.

#include <optional>
#include <string>
#include <string_view>

#include <heckbert/taxonomy/dialect.h>

namespace heckbert::taxonomy {

/// The end of "it can never match, because ..."; nothing when some path matches, or when the text has no operator on
/// whole paths that could be blamed. Errors: as read_expression().
std::optional<std::string> why_empty(std::string_view text, Dialect dialect = Dialect::Heckbert,
                                     const Names& names = {});

}  // namespace heckbert::taxonomy
