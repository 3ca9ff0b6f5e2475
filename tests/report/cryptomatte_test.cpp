// Hashes against published values, ids that are finite whatever the hash, and ranks.

#include <bit>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <heckbert/report/cryptomatte.h>

#include "report/sample_record.h"

namespace heckbert::report {
namespace {

TEST(Murmur3, GivesThePublishedHashes) {
  // Seed 0; the values that circulate with the algorithm, as on its Wikipedia page and in Guava's tests.
  EXPECT_EQ(murmur3(""), 0u);
  EXPECT_EQ(murmur3("test"), 0xba6bd213u);
  EXPECT_EQ(murmur3("Hello, world!"), 0xc0363e43u);
  EXPECT_EQ(murmur3("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
  EXPECT_EQ(murmur3("hello"), 0x248bfa47u);
  EXPECT_EQ(murmur3("hello, world"), 0x149bbb7fu);
}

TEST(CryptomatteId, IsAFiniteNormalNumberForEveryHash) {
  int changed = 0;
  for (int i = 0; i < 100000; ++i) {
    const std::string name = "name " + std::to_string(i);
    const float id = cryptomatte_id(name);
    ASSERT_TRUE(std::isnormal(id)) << name;
    const std::uint32_t difference = std::bit_cast<std::uint32_t>(id) ^ murmur3(name);
    ASSERT_TRUE(difference == 0 || difference == 1u << 23) << name;
    changed += difference != 0 ? 1 : 0;
  }
  // One hash in 128 has an exponent of 0 or 255: 781 of them, give or take 28 times 4.
  EXPECT_NEAR(changed, 781, 112);
}

TEST(Cryptomatte, RanksTheClassesOfAPixelByTheirLight) {
  const auto at = [](float left, float right) { return [=](int x, int) { return Rgb(x == 0 ? left : right); }; };
  const record::Record record = test::sample_record(2, 1,
                                                    {{.word = "LE", .batches = {1}, .light = at(1, 0)},
                                                     {.word = "LDE", .batches = {1}, .light = at(5, 0)},
                                                     {.word = "LpDE", .batches = {1}, .light = at(1, 3)},
                                                     {.word = "LSE", .batches = {1}, .light = at(3, 0)}});
  const PathClasses classes = classes_by_word(record);
  EXPECT_EQ(classes.names, (std::vector<std::string>{"LE", "LDE", "LSE"})) << "by plain letters";
  const record::Attachment matte = cryptomatte(record.info.window, record::rows_of(record), classes);
  ASSERT_EQ(matte.layers.size(), kCryptomatteRanks / 2);
  EXPECT_EQ(matte.layers[1].name, "PathClass01");
  const auto& first = matte.layers[0].pixels;
  EXPECT_EQ(first[0], (std::array<float, 4>{cryptomatte_id("LDE"), 0.6f, cryptomatte_id("LSE"), 0.3f}));
  EXPECT_EQ(matte.layers[1].pixels[0], (std::array<float, 4>{cryptomatte_id("LE"), 0.1f, 0, 0}));
  EXPECT_EQ(first[1], (std::array<float, 4>{cryptomatte_id("LDE"), 1, 0, 0}));
}

TEST(Cryptomatte, GivesAWordToTheFirstClassThatHasIt) {
  const PathClasses classes = classes_by_set({"a", "b"}, {{true, false, false}, {true, true, false}});
  EXPECT_EQ(classes.of_word, (std::vector<std::size_t>{0, 1, PathClasses::kNone}));
}

TEST(Cryptomatte, NamesItselfInTheHeader) {
  const record::Record record = test::sample_record(1, 1, {{.word = "L'don\"t'E", .batches = {1}}});
  const record::Attachment matte =
      cryptomatte(record.info.window, record::rows_of(record), classes_by_word(record), "x");
  std::string manifest;
  for (const auto& [key, value] : matte.attributes) {
    EXPECT_EQ(key.find("cryptomatte/"), 0u);
    EXPECT_EQ(key[19], '/') << "seven digits";
    if (key.ends_with("/manifest")) manifest = value;
  }
  EXPECT_EQ(matte.attributes.size(), 4u);
  const nlohmann::json names = nlohmann::json::parse(manifest);
  EXPECT_EQ(names.size(), 1u);
  EXPECT_TRUE(names.contains("L'don\"t'E"));
}

}  // namespace
}  // namespace heckbert::report
