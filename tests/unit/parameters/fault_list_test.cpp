#include "parameters/fault_list.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace matrigrate {
namespace {

std::vector<Fault> raised(FaultList& list) {
  try {
    list.raise();
  } catch (const ConfigurationError& error) {
    return error.faults();
  }
  return {};
}

TEST(FaultList, NothingIsRaisedWithoutFaults) {
  FaultList list("f");
  EXPECT_TRUE(list.empty());
  EXPECT_NO_THROW(list.raise());
}

TEST(FaultList, TheFirstByPlaceAreKeptWhateverTheirOrder) {
  FaultList list("f");
  list.add({"--set", 0, 0, "last", "m"});
  for (int i = 5000; i > 0; --i) list.add({"f", i, 1, fmt::format("k{}", i), "m"});
  const auto faults = raised(list);
  ASSERT_EQ(faults.size(), FaultList::max_listed + 1);
  for (int i = 0; i < 200; ++i) EXPECT_EQ(faults[static_cast<std::size_t>(i)].line, i + 1);
  EXPECT_EQ(to_string(faults.back()), "f: has 4801 more faults");
}

TEST(FaultList, AFaultIsNotedOnce) {
  FaultList list("f");
  for (int i = 0; i < 3000; ++i) list.add({"f", i % 3 + 1, 1, "k", "m"});
  EXPECT_EQ(raised(list).size(), 3U);
}

TEST(FaultList, HintsAreMadeForListedFaultsOnly) {
  FaultList list("f");
  int made = 0;
  for (int i = 0; i < 60'000; ++i)
    list.add({"f", i + 1, 1, "k", "m"}, [&made] {
      ++made;
      return std::string("; hint");
    });
  EXPECT_EQ(made, 0);
  EXPECT_EQ(to_string(raised(list).front()), "f:1:1: k: m; hint");
  EXPECT_EQ(made, 200);
}

} // namespace
} // namespace matrigrate
