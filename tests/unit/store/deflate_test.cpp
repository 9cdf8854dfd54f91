#include "store/deflate.hpp"

#include "base/failure.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace matrigrate::store {
namespace {

TEST(Deflated, ComesBackAndRefusesWhatItIsNot) {
  const std::string text(1000, 'x');
  for (const std::string& stored : {deflated(text, 6), deflated_fast(text)}) {
    EXPECT_LT(stored.size(), 50U);
    EXPECT_EQ(inflated(stored, 1000), text);
    EXPECT_THROW(inflated(stored, 999), InputOutputError);
  }
  EXPECT_EQ(inflated(deflated_fast(""), 0), "");
  EXPECT_THROW(inflated("nonsense", 8), InputOutputError);
}

TEST(Deflated, HasRoomForWhatDoesNotCompress) {
  std::string noise;
  for (std::uint32_t k = 0, x = 1; k < 300000; ++k) noise += static_cast<char>((x = x * 1664525U + 1013904223U) >> 24U);
  EXPECT_EQ(inflated(deflated_fast(noise), noise.size()), noise);
}

TEST(BytePlanes, HoldTheFirstBytesOfAllNumbersFirst) {
  const std::array<std::uint16_t, 3> numbers{0x0102, 0x0304, 0x0506};
  EXPECT_EQ(byte_planes(std::span<const std::uint16_t>(numbers)), "\x02\x04\x06\x01\x03\x05");
  EXPECT_EQ(byte_planes(std::span<const std::uint8_t>()), "");
}

} // namespace
} // namespace matrigrate::store
