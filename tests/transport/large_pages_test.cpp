// Tables in large pages: where they lie, and that nothing of them is lost as they grow over the size of a page and are
// given back (the address sanitizer watches).

#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include <heckbert/transport/large_pages.h>

namespace heckbert::transport {
namespace {

TEST(LargePages, AreWhereATableIsLarge) {
  std::vector<std::uint32_t, LargePages<std::uint32_t>> table(100);
  std::iota(table.begin(), table.end(), 0u);
  table.resize(std::size_t{1} << 20);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(table.data()) % (std::size_t{2} << 20), 0u);
  std::iota(table.begin() + 100, table.end(), 100u);
  EXPECT_EQ(table.front(), 0u);
  EXPECT_EQ(table[99], 99u);
  EXPECT_EQ(table.back(), (1u << 20) - 1);
  const auto copy = table;
  EXPECT_EQ(copy, table);
}

}  // namespace
}  // namespace heckbert::transport
