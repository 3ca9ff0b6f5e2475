#include <heckbert/import/words.h>

#include <array>
#include <cstdio>

namespace heckbert::import {

std::string to_text(double number) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.6g", number);
  return buffer.data();
}

std::string to_text(Rgb colour) {
  std::string r = to_text(static_cast<double>(colour.r));
  if (colour.r == colour.g && colour.g == colour.b) {
    return r;
  }
  return r + " " + to_text(static_cast<double>(colour.g)) + " " + to_text(static_cast<double>(colour.b));
}

std::string join(const std::vector<std::string>& words, const std::string& between) {
  std::string out;
  for (const std::string& word : words) {
    out += (out.empty() ? "" : between) + word;
  }
  return out;
}

std::string count(std::size_t number, const std::string& noun) {
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

}  // namespace heckbert::import
