#pragma once
// Expressions of other renderers to trees over our symbols, by the rules of their dialect. Every error that has an
// obvious remedy carries it as an edit; when the edits together make the text readable, the repaired text is proposed.

#include <string>
#include <vector>

#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/expression_source.h>
#include <heckbert/taxonomy/expression_tree.h>

namespace heckbert::taxonomy {

/// Replace [offset, offset + length) of the text.
struct Edit {
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string replacement;
};

struct DialectTree {
  Node root;
  std::vector<std::string> prefixes;
  std::vector<Diagnostic> warnings;
  std::vector<Edit> edits;
  bool is_repairable = true;  ///< every error found has its edit
};

/// Errors are left in the source; the tree is then not to be used.
DialectTree parse_dialect(ExpressionSource& source, const DialectFacts& dialect);

}  // namespace heckbert::taxonomy
