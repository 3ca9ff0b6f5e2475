#pragma once
// What --memory comes to: how many words a record may keep apart, and which expressions it stays exact for.

#include <cstdint>
#include <vector>

#include <heckbert/cli/settings.h>
#include <heckbert/record/folding.h>
#include <heckbert/record/record.h>
#include <heckbert/taxonomy/grammar.h>

namespace heckbert::cli {

/// For a render with these expressions besides the built-in grammars, and perhaps a Cryptomatte. Errors: UsageError
/// when not even the pixels find room in `bytes`, and for an expression that is too long to be written into a record.
record::FoldRule fold_rule(std::uint64_t bytes, const record::RenderInfo& info,
                           const std::vector<taxonomy::Grammar>& declared, bool with_cryptomatte);

}  // namespace heckbert::cli
