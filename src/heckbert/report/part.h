#pragma once
// The part of a record that a question is about: some of its pixels, some of its words, or all of both. Shares are of
// the light of that part.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <heckbert/record/record.h>

namespace heckbert::report {

struct Part {
  std::optional<record::Window> pixels{};    ///< inside the record's window; unset: all of it
  std::optional<std::vector<bool>> words{};  ///< by word of the record; unset: all
  std::string description{};                 ///< "pixels 3 to 8, 4 to 9; words L'key' .* E", for people; empty: all

  bool has(std::size_t word) const { return !words || (*words)[word]; }
  bool is_whole() const { return !pixels && !words; }
};

}  // namespace heckbert::report
