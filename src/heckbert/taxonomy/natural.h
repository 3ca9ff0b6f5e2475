#pragma once
// Natural numbers without an upper bound, as far as counting words needs them: sums, and products with small numbers.

#include <cstdint>
#include <string>
#include <vector>

namespace heckbert::taxonomy {

class Natural {
 public:
  Natural() = default;
  explicit Natural(std::uint32_t value);

  /// Adds other * factor.
  void add(const Natural& other, std::uint32_t factor = 1);
  bool operator==(const Natural&) const = default;
  bool is_zero() const { return limbs_.empty(); }
  std::uint32_t modulo(std::uint32_t divisor) const;  ///< divisor > 0

  friend std::string to_string(const Natural& number);  ///< decimal

 private:
  std::vector<std::uint32_t> limbs_;  ///< base 10^9, least first, the last one not 0
};

std::string to_string(const Natural& number);

}  // namespace heckbert::taxonomy
