#pragma once
// Recursive descent over the tokens of an expression, one function per level of precedence.

#include <heckbert/taxonomy/expression_source.h>
#include <heckbert/taxonomy/expression_tree.h>

namespace heckbert::taxonomy {

/// The tree of the source. Errors are reported in the source; the tree then has Bad nodes in their place.
Node parse_expression(ExpressionSource& source);

}  // namespace heckbert::taxonomy
