#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/grammar.h>

int main() {
  const auto whitted = heckbert::taxonomy::builtin_grammars().find("whitted");
  const bool found = whitted->language.contains(heckbert::taxonomy::parse_word("LDSE"));
  return found && heckbert::taxonomy::compile("L D* E").contains(heckbert::taxonomy::parse_word("LDDE")) ? 0 : 1;
}
