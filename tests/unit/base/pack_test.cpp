#include "base/pack.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <vector>

using namespace matrigrate;

TEST(Pack, IsReadFromAndWrittenToAnyPlace) {
  std::vector<double> numbers(11);
  std::iota(numbers.begin(), numbers.end(), 0.5);
  for (std::size_t at = 0; at + pack_size<Doubles> <= numbers.size(); ++at) {
    Doubles a;
    load(numbers.data() + at, a);
    std::vector<double> copy(numbers.size(), -1.0);
    store_pack(a, copy.data() + at);
    for (std::size_t i = 0; i < copy.size(); ++i)
      EXPECT_EQ(copy[i], i >= at && i < at + pack_size<Doubles> ? numbers[i] : -1.0);
  }
}

TEST(Pack, HasOneNumberThroughoutWhenFilled) {
  Floats a;
  fill(0.1F, a);
  for (std::size_t l = 0; l < pack_size<Floats>; ++l) EXPECT_EQ(a[l], 0.1F);
  EXPECT_EQ(pack_size<Doubles>, 4U);
  EXPECT_EQ(pack_size<Floats>, 8U);
}

TEST(Pack, KnowsWhetherAnyNumberIsNotZero) {
  HalfFloats a{};
  EXPECT_FALSE(any(a));
  for (std::size_t l = 0; l < pack_size<HalfFloats>; ++l) {
    HalfFloats b{};
    b[l] = std::numeric_limits<float>::denorm_min();
    EXPECT_TRUE(any(b)) << l;
  }
}
