#include "base/stretches.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

using namespace matrigrate;

namespace {

std::vector<std::pair<std::size_t, std::size_t>> stretches(const std::vector<std::uint8_t>& flags) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  each_unflagged_stretch(flags, [&](std::size_t begin, std::size_t end) { found.emplace_back(begin, end); });
  return found;
}

} // namespace

TEST(Stretches, AreThoseWithoutFlags) {
  using Found = std::vector<std::pair<std::size_t, std::size_t>>;
  EXPECT_EQ(stretches({1, 0, 0, 1, 1, 0}), (Found{{1, 3}, {5, 6}}));
  EXPECT_EQ(stretches({0, 0, 7, 0}), (Found{{0, 2}, {3, 4}}));
  EXPECT_EQ(stretches({0, 0}), (Found{{0, 2}}));
  EXPECT_TRUE(stretches({1, 1}).empty());
  EXPECT_TRUE(stretches({}).empty());
}
