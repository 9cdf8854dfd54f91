#include "report/packed.hpp"

#include "store/base64.hpp"
#include "store/deflate.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace matrigrate::report {
namespace {

std::string stored(std::initializer_list<int> bytes) {
  std::string text;
  for (const int byte : bytes) text += static_cast<char>(byte);
  return text;
}

nlohmann::ordered_json pack(const Packing& packing, const std::vector<observe::Floats>& frames) {
  return packed(packing, frames.size(), [&](std::size_t k) -> const observe::Floats& { return frames[k]; });
}

TEST(Packed, IsTheWorkedExampleOfTheContract) {
  const auto json = pack({.wide = true}, {{0x0201, 0x0403}});
  EXPECT_EQ(json.at("data"), store::base64(store::deflated(stored({1, 3, 2, 4}), 6)));
  EXPECT_EQ(json.at("type"), "int16");
  EXPECT_EQ(json.at("components"), 1);
  EXPECT_EQ(json.at("per_frame"), 2);
}

TEST(Packed, StoresDifferencesOfRoundedNumbers) {
  const auto json = pack({.scale = 0.5, .offset = 1.0}, {{1.0, 2.0}, {1.3F, 1.0}});
  EXPECT_EQ(json.at("data"), store::base64(store::deflated(stored({0, 2, 1, 254}), 6))) << "modulo 256";
  const auto plain = pack({.scale = 0.5, .offset = 1.0, .delta = false}, {{1.0, 2.0}, {1.3F, 1.0}});
  EXPECT_EQ(plain.at("data"), store::base64(store::deflated(stored({0, 2, 1, 0}), 6)));
  const auto wide = pack({.wide = true}, {{-1.0}, {1.0}});
  EXPECT_EQ(wide.at("data"), store::base64(store::deflated(stored({255, 255, 2, 0}), 6))) << "modulo 65536";
}

TEST(Packed, ClampsAndReplacesWhatIsNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(pack({}, {{-3, 300, nan}}).at("data"), store::base64(store::deflated(stored({0, 255, 0}), 6)));
  EXPECT_EQ(pack({.wide = true}, {{-40000, 40000}}).at("data"),
            store::base64(store::deflated(stored({0, 255, 128, 127}), 6)));
}

} // namespace
} // namespace matrigrate::report
