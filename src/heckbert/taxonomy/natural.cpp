#include <heckbert/taxonomy/natural.h>

#include <algorithm>

namespace heckbert::taxonomy {

namespace {
constexpr std::uint64_t kBase = 1'000'000'000;
constexpr std::size_t kDigits = 9;
}  // namespace

Natural::Natural(std::uint32_t value) {
  for (std::uint64_t rest = value; rest > 0; rest /= kBase) limbs_.push_back(static_cast<std::uint32_t>(rest % kBase));
}

void Natural::add(const Natural& other, std::uint32_t factor) {
  if (factor == 0) return;
  std::uint64_t carry = 0;  // below 2^33, so that the sum below stays under 2^63
  for (std::size_t i = 0; i < other.limbs_.size() || carry > 0; ++i) {
    if (i == limbs_.size()) limbs_.push_back(0);
    const std::uint64_t sum =
        limbs_[i] + carry + (i < other.limbs_.size() ? std::uint64_t{other.limbs_[i]} * factor : 0);
    limbs_[i] = static_cast<std::uint32_t>(sum % kBase);
    carry = sum / kBase;
  }
}

std::uint32_t Natural::modulo(std::uint32_t divisor) const {
  std::uint64_t rest = 0;
  for (std::size_t i = limbs_.size(); i-- > 0;) rest = (rest * kBase + limbs_[i]) % divisor;
  return static_cast<std::uint32_t>(rest);
}

std::string to_string(const Natural& number) {
  if (number.limbs_.empty()) return "0";
  std::string text = std::to_string(number.limbs_.back());
  for (std::size_t i = number.limbs_.size() - 1; i-- > 0;) {
    const std::string limb = std::to_string(number.limbs_[i]);
    text += std::string(kDigits - limb.size(), '0') + limb;
  }
  return text;
}

}  // namespace heckbert::taxonomy
