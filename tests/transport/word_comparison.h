#pragma once
// Two records of one scene compared word by word: whatever found them, words have one value.

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <heckbert/record/statistics.h>
#include <heckbert/taxonomy/word.h>
#include <heckbert/transport/claims.h>

namespace heckbert::transport {

/// A word of fewer paths than this has no spread that one could trust by itself.
inline constexpr std::uint64_t kEnough = 200;
/// And one of fewer than this may be missing for all that a test on spread can see.
inline constexpr std::uint64_t kAtLeast = 16;

/// Two-sample tests at 1 % for all comparisons after Sidak: of every word that both records have found often; of all
/// that they have found less often together; and of all light, so that none can be lost.
class Comparison {
 public:
  /// `most_noise`: the standard error of all light, over its energy, that still says something. `most_comparisons`: of
  /// the whole test, which this is a part of.
  Comparison(const record::Record& reference, const record::Record& other, const taxonomy::Language& both,
             double most_noise, int most_comparisons, std::string where)
      : reference_(reference),
        other_(other),
        bound_(record::student_quantile(1 - 0.005 / most_comparisons, record::kBatches - 1)),
        where_(std::move(where)) {
    std::map<std::string, std::array<std::uint64_t, 2>> counts;
    for (const std::size_t which : {0u, 1u}) {
      const record::Record& record = which == 0 ? reference : other;
      for (std::size_t w = 0; w < record.words.size(); ++w)
        if (both.contains(record.words[w])) counts[taxonomy::plain(record.words[w])][which] += record.counts[w];
    }
    std::set<std::string> all, rare;
    for (const auto& [word, found] : counts) {
      all.insert(word);
      const std::uint64_t fewest = std::min(found[0], found[1]);
      if (fewest >= kEnough)
        test({word}, word);
      else if (fewest >= kAtLeast)
        rare.insert(word);
    }
    if (!rare.empty()) test(rare, "all rare words");
    const double error = test(all, "all words");
    EXPECT_LT(error, most_noise) << where_ << ": too noisy to say anything";
  }
  int count() const { return count_; }

 private:
  static record::Estimate energy(const record::Record& record, const std::set<std::string>& words) {
    std::vector<bool> chosen;
    for (const taxonomy::Word& word : record.words) chosen.push_back(words.contains(taxonomy::plain(word)));
    return record::energy(record, chosen);
  }
  /// Gives back the standard error of the difference over the energy.
  double test(const std::set<std::string>& words, const std::string& what) {
    const record::Estimate a = energy(reference_, words), b = energy(other_, words);
    const double error = std::hypot(a.standard_error, b.standard_error);
    EXPECT_NEAR(a.mean, b.mean, bound_ * error + 1e-5 * a.mean)
        << where_ << ", " << what << ": " << (b.mean - a.mean) / error << " standard errors, relative "
        << b.mean / a.mean - 1;
    ++count_;
    return error / a.mean;
  }

  const record::Record &reference_, &other_;
  double bound_;
  std::string where_;
  int count_ = 0;
};

}  // namespace heckbert::transport
