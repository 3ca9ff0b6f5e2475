#include <heckbert/taxonomy/error_codes.h>

#include <cassert>
#include <charconv>
#include <tuple>
#include <utility>

namespace heckbert::taxonomy {

namespace {
constexpr std::string_view kPrefix = "HB";
}

std::string label(ErrorCode code) {
  return std::string(kPrefix) + std::to_string(static_cast<unsigned>(code));
}

const ErrorFacts* find_error(std::string_view label) {
  if (label.starts_with("HB") || label.starts_with("hb")) label.remove_prefix(kPrefix.size());
  unsigned number = 0;
  const auto [end, error] = std::from_chars(label.data(), label.data() + label.size(), number);
  if (error != std::errc() || end != label.data() + label.size()) return nullptr;
  const auto row = std::find_if(kErrors.begin(), kErrors.end(),
                                [=](const ErrorFacts& f) { return static_cast<unsigned>(f.code) == number; });
  return row == kErrors.end() ? nullptr : &*row;
}

std::string message_of(ErrorCode code, std::initializer_list<std::string_view> values) {
  std::string_view rest = facts(code).message;
  std::string message;
  for (const std::string_view value : values) {
    const std::size_t place = rest.find("{}");
    assert(place != std::string_view::npos);
    message += rest.substr(0, place);
    message += value;
    rest.remove_prefix(place + 2);
  }
  assert(rest.find("{}") == std::string_view::npos);
  return message += rest;
}

Diagnostic diagnose(ErrorCode code, std::string_view source, std::string_view text, std::size_t offset,
                    std::size_t length, std::initializer_list<std::string_view> values, std::string suggestion) {
  Diagnostic diagnostic =
      heckbert::diagnose(source, text, offset, length, message_of(code, values), std::move(suggestion));
  diagnostic.code = label(code);
  return diagnostic;
}

void sort_by_place(std::vector<Diagnostic>& diagnostics) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.source, a.line, a.column) < std::tie(b.source, b.line, b.column);
  });
}

std::string warning_text(const Diagnostic& d) {
  return d.message + (d.suggestion.empty() ? "" : "; " + d.suggestion) + (d.code.empty() ? "" : " [" + d.code + "]");
}

}  // namespace heckbert::taxonomy
