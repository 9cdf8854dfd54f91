#include "parameters/laws/constants.hpp"
#include "parameters/rules.hpp"
#include "parameters/schema.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <set>
#include <utility>

namespace matrigrate {
namespace {

/// Where a choice lies: the first byte that changes with it, and the size of an enumeration.
std::pair<std::size_t, std::size_t> bytes_of_choice(const Choice& choice, Parameters& p) {
  std::array<unsigned char, sizeof(Parameters)> before{};
  std::array<unsigned char, sizeof(Parameters)> after{};
  choice.set(p, 0);
  std::memcpy(before.data(), &p, sizeof(p)); // NOLINT(bugprone-undefined-memory-manipulation): to look at
  choice.set(p, 1);
  std::memcpy(after.data(), &p, sizeof(p)); // NOLINT(bugprone-undefined-memory-manipulation)
  const auto difference = std::ranges::mismatch(before, after).in1;
  return {static_cast<std::size_t>(difference - before.begin()), sizeof(Lattice)};
}

/// Where a row's member lies: first byte within Parameters, and its size.
std::pair<std::size_t, std::size_t> bytes_of(const Row& row, Parameters& p) {
  const auto offset = [&p](const void* member) {
    return static_cast<std::size_t>(static_cast<const char*>(member)
                                    - static_cast<const char*>(static_cast<void*>(&p)));
  };
  return std::visit(
      [&](const auto& member) -> std::pair<std::size_t, std::size_t> {
        using Stored = std::decay_t<decltype(member)>;
        if constexpr (std::is_same_v<Stored, Choice>)
          return bytes_of_choice(member, p);
        else if constexpr (std::is_same_v<Stored, OneConstant>)
          return {}; // no row of the schema
        else
          return {offset(&member(p)), sizeof(member(p))};
      },
      row.member);
}

TEST(Schema, EachRowHasAMemberOfItsOwn) {
  Parameters p;
  std::set<std::size_t> seen;
  for (const Row& row : schema()) {
    const auto [first, size] = bytes_of(row, p);
    EXPECT_TRUE(seen.insert(first).second) << row.path << " shares its member with another row";
    EXPECT_LE(first + size, sizeof(Parameters)) << row.path;
  }
}

TEST(Schema, NoMemberIsWithoutARow) {
  Parameters p;
  std::map<std::size_t, std::size_t> covered{{sizeof(Parameters), 0}};
  for (const Row& row : schema()) covered.insert(bytes_of(row, p));
  const auto cover = [&](void* member, std::size_t size) {
    const auto* start = static_cast<const char*>(static_cast<void*>(&p));
    covered.insert({static_cast<std::size_t>(static_cast<const char*>(member) - start), size});
  };
  cover(&p.cells, sizeof(p.cells));     // NOLINT(bugprone-sizeof-container): of the rows of [[cells]]
  cover(&p.changes, sizeof(p.changes)); // NOLINT(bugprone-sizeof-container): have a row for their times
  cover(&p.grids, sizeof(p.grids));     // no parameter
  cover(&p.origin, sizeof(p.origin));   // nor this
  std::size_t end = 0;
  for (const auto& [first, size] : covered) {
    EXPECT_LT(first - end, 8u) << "room for a member between bytes " << end << " and " << first;
    end = first + size;
  }
}

TEST(Schema, RowsAreSound) {
  std::set<std::string_view> paths;
  for (const Row& row : schema()) {
    EXPECT_TRUE(paths.insert(row.path).second) << row.path;
    EXPECT_TRUE(std::ranges::any_of(sections(), [&](const Section& s) { return s.name == section_of(row); }))
        << row.path;
    EXPECT_FALSE(row.description.empty() || row.description.ends_with('.')) << row.path;
    EXPECT_FALSE(row.source.empty()) << row.path;
    if (kind(row) == Kind::quantity || kind(row) == Kind::ratio) {
      EXPECT_NO_THROW(units::parse_unit(row.unit)) << row.path;
      EXPECT_LT(row.range.low, row.range.high) << row.path;
    }
  }
}

TEST(Schema, SectionsStandTogetherAndInOrder) {
  std::vector<std::string_view> met;
  for (const Row& row : schema())
    if (met.empty() || met.back() != section_of(row)) met.push_back(section_of(row));
  std::vector<std::string_view> expected;
  for (const Section& section : sections()) expected.push_back(section.name);
  EXPECT_EQ(met, expected);
}

TEST(Schema, DefaultsArePaperValues) {
  const auto text = [](std::string_view path) { return value_text(*find_row(path), Parameters{}); };
  EXPECT_EQ(text("ecm.youngs_modulus"), "\"200 Pa\"");
  EXPECT_EQ(text("ecm.viscosity"), "\"1000 Pa s\"");
  EXPECT_EQ(text("ecm.poissons_ratio"), "0.45");
  EXPECT_EQ(text("run.duration"), "\"6 h\"");
  EXPECT_EQ(text("run.time_step"), "\"0.4 s\"");
  EXPECT_EQ(text("ecm.lattice"), "\"square\"");
  EXPECT_EQ(text("ecm.cell_hole"), "true");
}

TEST(Schema, KindFollowsFromTypeAndUnit) {
  EXPECT_EQ(kind(*find_row("ecm.youngs_modulus")), Kind::quantity);
  EXPECT_EQ(kind(*find_row("ecm.poissons_ratio")), Kind::ratio);
  EXPECT_EQ(kind(*find_row("fibres.direction_deg")), Kind::angle);
  EXPECT_EQ(value_text(*find_row("protrusion.deflection_cone"), {}), "\"60 deg\"");
  Parameters p;
  p.protrusion.deflection_cone = 1.05; // whose degrees have no short decimal
  EXPECT_EQ(value_text(*find_row("protrusion.deflection_cone"), p), "1.05");
  EXPECT_EQ(allowed_text(*find_row("fibres.half_angle_deg")), "> 0 and <= 90");
  EXPECT_EQ(kind(*find_row("run.seed")), Kind::integer);
  EXPECT_EQ(kind(*find_row("ecm.cell_hole")), Kind::boolean);
  EXPECT_EQ(kind(*find_row("ecm.lattice")), Kind::choice);
  EXPECT_EQ(find_row("ecm.young"), nullptr);
}

TEST(Schema, AllowedValuesAreToldInWords) {
  EXPECT_EQ(allowed_text(*find_row("ecm.youngs_modulus")), "> 0 and <= 1e7 Pa");
  EXPECT_EQ(allowed_text(*find_row("ecm.poissons_ratio")), "> 0 and < 0.5");
  EXPECT_EQ(allowed_text(*find_row("ecm.radius")), ">= 10 and <= 2000 um");
  EXPECT_EQ(allowed_text(*find_row("run.seed")), ">= 0 and <= 9007199254740991");
  EXPECT_EQ(allowed_text(*find_row("ecm.cell_hole")), "true or false");
  EXPECT_EQ(allowed_text(*find_row("ecm.lattice")), "\"square\" or \"hexagonal\"");
}

TEST(Schema, SameComparesEveryRow) {
  for (const Row& row : schema()) {
    Parameters a;
    Parameters b;
    std::visit(
        [&](const auto& member) {
          using Stored = std::decay_t<decltype(member)>;
          if constexpr (std::is_same_v<Stored, Choice>)
            member.set(b, 1 - member.index(b));
          else if constexpr (std::is_same_v<Stored, OneConstant>)
            FAIL() << "no row of the schema";
          else if constexpr (std::is_same_v<std::decay_t<decltype(member(b))>, std::vector<LawConstant>>)
            member(b) = constants_in("n = 2");
          else if constexpr (std::is_same_v<std::decay_t<decltype(member(b))>, bool>)
            member(b) = !member(b);
          else
            member(b) += 1;
        },
        row.member);
    EXPECT_TRUE(same(a, a));
    EXPECT_FALSE(same(a, b)) << row.path;
  }
}

TEST(Rules, DefaultsFulfilThemAndTheirKeysExist) {
  for (const Rule& rule : rules()) {
    EXPECT_EQ(rule.broken(Parameters{}), "") << rule.name;
    EXPECT_FALSE(rule.keys.empty());
    for (const std::string_view key : rule.keys) EXPECT_NE(find_row(key), nullptr) << key;
  }
}

} // namespace
} // namespace matrigrate
