#pragma once
// How numbers are written for people, the same in every table and on every page: shares in per cent with two decimals,
// energies with four significant digits, counts in groups of three. Programs read the JSON, which has all the digits.

#include <cstdint>
#include <optional>
#include <string>

#include <heckbert/record/statistics.h>

namespace heckbert::report {

/// 0.6213 -> "62.13 %"; what is there but would print as nought is "< 0.01 %".
std::string percent(double share);
/// "62.01 to 62.25 %", or "unknown" when there was only one batch.
std::string percent_interval(const record::Estimate& share);
/// "[62.01, 62.25]" in per cent, for columns; "-" when unknown.
std::string bracketed_percent(const record::Estimate& share);
/// Four significant digits.
std::string number(double value);
/// With as many decimals as `largest` needs for four significant digits, so that a column lines up.
std::string aligned_number(double value, double largest);
/// 1234567 -> "1 234 567".
std::string grouped(std::uint64_t count);
/// "1 word", "2 words".
std::string counted(std::uint64_t count, const std::string& singular);
/// A number of samples, three digits of it: 640 123.4 -> "641 000"; "-" when unknown.
std::string samples_text(const std::optional<double>& needed);
/// A confidence level: 0.95 -> "95 %".
std::string level(double confidence);

}  // namespace heckbert::report
