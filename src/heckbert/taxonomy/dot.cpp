#include <heckbert/taxonomy/dot.h>

#include <heckbert/taxonomy/live.h>

namespace heckbert::taxonomy {

std::string dot_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string dot(const Language& language, std::string_view title) {
  const std::vector<State>& states = language.states();
  std::string text = "digraph {\n  label=" + dot_string(title) +
                     ";\n  rankdir=LR;\n  node [shape=circle];\n  start [shape=point];\n  start -> 0;\n";
  for (StateId q = 0; q < states.size(); ++q) {
    if (is_dead(language, q) && q != 0) continue;
    text += "  " + std::to_string(q) + (states[q].accepting ? " [shape=doublecircle];\n" : ";\n");
    for (const auto& [to, set] : moves(language, q))
      text += "  " + std::to_string(q) + " -> " + std::to_string(to) + " [label=" + dot_string(write(set)) + "];\n";
  }
  return text + "}\n";
}

}  // namespace heckbert::taxonomy
