#include <heckbert/import/obj_check.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace heckbert::import {
namespace {

constexpr std::size_t kMaxErrors = 100;
constexpr double kHuge = 1e9;
constexpr std::string_view kBlanks = " \t\r";

template <class Number>
std::optional<Number> parse(std::string_view token) {
  if (token.starts_with('+')) {
    token.remove_prefix(1);
  }
  Number value{};
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc() || end != token.data() + token.size()) {
    return {};
  }
  return value;
}

class Checker {
 public:
  Checker(std::string_view text, std::string_view source) : text_(text), source_(source) {}

  std::vector<Diagnostic> check() {
    // Faces may refer to what comes later, so count first.
    each_line([&](std::size_t, std::string_view keyword, std::size_t, std::size_t) { count(keyword, totals_); });
    each_line([&](std::size_t begin, std::string_view keyword, std::size_t rest, std::size_t end) {
      count(keyword, so_far_);
      if (keyword == "v" || keyword == "vn") {
        check_numbers(begin, rest, end);
      } else if (keyword == "f") {
        check_face(begin, rest, end);
      }
    });
    return std::move(found_);
  }

 private:
  struct Counts {
    long long positions = 0, texture = 0, normals = 0;
  };

  template <class Visit>
  void each_line(const Visit& visit) const {
    for (std::size_t at = 0; at < text_.size();) {
      const std::size_t stop = std::min(text_.find('\n', at), text_.size());
      std::size_t begin = std::min(text_.find_first_not_of(kBlanks, at), stop);
      const std::size_t end =
          std::min(std::min(text_.find('#', begin), stop), text_.find_last_not_of(kBlanks, stop - 1) + 1);
      if (begin < end) {
        const std::size_t rest = std::min(text_.find_first_of(kBlanks, begin), end);
        visit(begin, text_.substr(begin, rest - begin), rest, end);
      }
      at = stop + 1;
    }
  }

  static void count(std::string_view keyword, Counts& counts) {
    counts.positions += keyword == "v" ? 1 : 0;
    counts.texture += keyword == "vt" ? 1 : 0;
    counts.normals += keyword == "vn" ? 1 : 0;
  }

  template <class Visit>
  void each_token(std::size_t at, std::size_t end, const Visit& visit) const {
    while ((at = std::min(text_.find_first_not_of(kBlanks, at), end)) < end) {
      const std::size_t stop = std::min(text_.find_first_of(kBlanks, at), end);
      visit(at, text_.substr(at, stop - at));
      at = stop;
    }
  }

  void report(std::size_t at, std::size_t length, std::string message) {
    if (found_.size() < kMaxErrors) {
      found_.push_back(diagnose(source_, text_, at, length, std::move(message)));
    }
  }

  void check_numbers(std::size_t begin, std::size_t rest, std::size_t end) {
    int numbers = 0;
    each_token(rest, end, [&](std::size_t at, std::string_view token) {
      if (++numbers > 3) {
        return;
      }
      const auto value = parse<double>(token);
      if (!value || !(std::abs(*value) <= kHuge)) {
        report(at, token.size(), "expected a number from -1e+09 to 1e+09");
      }
    });
    if (numbers < 3) {
      report(begin, end - begin, "expected three numbers, found " + std::to_string(numbers));
    }
  }

  void check_face(std::size_t begin, std::size_t rest, std::size_t end) {
    int corners = 0;
    each_token(rest, end, [&](std::size_t at, std::string_view token) {
      ++corners;
      check_corner(at, token);
    });
    if (corners < 3) {
      report(begin, end - begin, "a face needs at least three corners, found " + std::to_string(corners));
    }
  }

  /// v, v/t, v//n or v/t/n.
  void check_corner(std::size_t at, std::string_view token) {
    const struct {
      const char* what;
      long long total, so_far;
    } kinds[] = {{"position", totals_.positions, so_far_.positions},
                 {"texture coordinate", totals_.texture, so_far_.texture},
                 {"normal", totals_.normals, so_far_.normals}};
    const auto malformed = [&] { report(at, token.size(), "expected a corner: v, v/t, v//n or v/t/n"); };
    if (token.starts_with('/') || std::count(token.begin(), token.end(), '/') > 2) {
      malformed();
      return;
    }
    std::string_view rest = token;
    for (const auto& kind : kinds) {
      const std::string_view piece = rest.substr(0, rest.find('/'));
      rest.remove_prefix(std::min(piece.size() + 1, rest.size()));
      if (piece.empty()) {
        continue;
      }
      const auto index = parse<long long>(piece);
      if (!index) {
        malformed();
        return;
      }
      if (*index == 0 || *index > kind.total || *index < -kind.so_far) {
        report(at, token.size(),
               "there is no " + std::string(kind.what) + " " + std::to_string(*index) + ": the file has " +
                   std::to_string(kind.total) + ", counted from 1");
      }
    }
  }

  std::string_view text_;
  std::string_view source_;
  Counts totals_, so_far_;
  std::vector<Diagnostic> found_;
};

}  // namespace

std::vector<Diagnostic> check_obj_text(std::string_view text, std::string_view source) {
  return Checker(text, source).check();
}

}  // namespace heckbert::import
