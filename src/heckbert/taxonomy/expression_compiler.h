#pragma once
// From the text of an expression, which may be a part of a document, to its language. compile() is the public face;
// grammar files use this directly so that errors are placed in the file.

#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/expression_source.h>

namespace heckbert::taxonomy {

/// The language of the source's expression; nothing when it has errors, which are then in source.errors.
/// Errors: LimitError naming the sub-expression that is too large or takes too much work.
std::optional<Language> compile(ExpressionSource& source, const Names& names);

}  // namespace heckbert::taxonomy
