#include "parameters/laws/constants.hpp"

#include "faults.hpp"
#include "parameters/assign.hpp"
#include "parameters/laws/law.hpp"
#include "parameters/write.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>

namespace matrigrate {
namespace {

const std::string law = "[laws]\ndisassembly_rate = \"r_0*exp(-F/F_s)*n\"\n";
const std::string table = law + "[laws.constants]\nr_0 = \"12 1/min\"\nF_s = \"400 pN\"\nn = 2\n";

Parameters parsed(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_parameters(text, "f.toml", overrides);
}

std::uint64_t bits(const Parameters& p, std::string_view name) {
  return std::bit_cast<std::uint64_t>(find_constant(name, p)->value);
}

TEST(Constants, AreTheSameInOneTextAndInATable) {
  const Parameters p = parsed(table);
  const Parameters q = parsed(law + "constants = \"n = 2, r_0 = 0.2 1/s, F_s=0.4 nN\"\n");
  EXPECT_EQ(constants_text(p), "F_s = 0.4 nN, n = 2, r_0 = 0.2 1/s");
  EXPECT_EQ(values_text(p), values_text(q)) << "of which the fingerprint is made";
  EXPECT_NE(values_text(p).find("laws.constants = \"F_s = 0.4 nN, n = 2, r_0 = 0.2 1/s\"\n"), std::string::npos);
  EXPECT_TRUE(same(p, q));
}

TEST(Constants, AreParametersOfTheirOwn) {
  const Parameters p = parsed(table);
  const Row* row = find_row("laws.constants.F_s", p);
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->path, "laws.constants.F_s");
  EXPECT_EQ(row->unit, "nN");
  EXPECT_EQ(kind(*row), Kind::quantity);
  EXPECT_EQ(value_text(*row, p), "\"0.4 nN\"");
  EXPECT_EQ(allowed_text(*row), "any number of nN");
  EXPECT_EQ(kind(*find_row("laws.constants.n", p)), Kind::ratio);
  EXPECT_EQ(find_row("laws.constants.F_z", p), nullptr);
  EXPECT_EQ(find_row("laws.constants.F_s"), nullptr) << "of no parameters";
  EXPECT_EQ(find_row("ecm.radius", p), find_row("ecm.radius"));
}

TEST(Constants, AloneLeaveTheOthers) {
  EXPECT_EQ(constants_text(parsed(table, {"laws.constants.F_s=0.1 nN", "laws.constants.n=3"})),
            "F_s = 0.1 nN, n = 3, r_0 = 0.2 1/s");
  EXPECT_EQ(constants_text(parsed(table, {"laws.constants.F_s=0.1"})), "F_s = 0.1 nN, n = 2, r_0 = 0.2 1/s");
  EXPECT_EQ(constants_text(apply_overrides(parsed(table), {"laws.constants.r_0=6 1/min"})),
            "F_s = 0.4 nN, n = 2, r_0 = 0.1 1/s");
  EXPECT_EQ(constants_text(parsed(table, {"laws.constants=F_s = 1 nN, n = 1, r_0 = 1 1/s"})),
            "F_s = 1 nN, n = 1, r_0 = 1 1/s")
      << "all in one text are all there are";
}

TEST(Constants, OfAResolvedFileHaveTheSameBitsAndRanges) {
  const std::string ranges = "[laws.constants]\nF_s = { value = \"0.4 nN\", range = [\"100 pN\", 1] }\n"
                             "n = { value = 2, range = [-1, 5] }\na = { value = \"30 deg\", range = [\"0 deg\", 2] }\n"
                             "g = \"0.3 kPa^0.5\"\np_0 = { value = \"0.7 kPa\", range = [\"1 Pa\", \"1 kPa\"] }\n";
  const Parameters p = parsed(ranges);
  const Parameters q = parsed(to_toml(p));
  EXPECT_TRUE(same(p, q));
  ASSERT_EQ(q.laws.constants.size(), 5U) << to_toml(p);
  for (const LawConstant& constant : p.laws.constants) {
    EXPECT_EQ(bits(q, constant.name), bits(p, constant.name)) << constant.name;
    const Row& row = *find_constant(constant.name, q)->row;
    EXPECT_EQ(row.range.low, constant.row->range.low) << constant.name;
    EXPECT_EQ(row.range.high, constant.row->range.high) << constant.name;
  }
  EXPECT_NE(to_toml(p).find("\np_0 = { value = \"700 Pa\", range = [\"1 Pa\", \"1000 Pa\"] }\n"), std::string::npos)
      << to_toml(p);
  EXPECT_EQ(values_text(p), values_text(parsed("[laws.constants]\nF_s = \"0.4 nN\"\nn = 2\na = \"30 deg\"\n"
                                               "g = \"0.3 kPa^0.5\"\np_0 = \"0.7 kPa\"\n")))
      << "a range makes no other run";
}

TEST(Constants, OfAngleCompareWithArguments) {
  EXPECT_TRUE(
      faults_of("[laws]\npolarization_rate = \"angle < a_0 ? 0 : r_pol\"\nconstants = \"a_0 = 30 deg\"\n").empty());
}

TEST(ConstantFaults, OfATableAreToldEachAtItsPlace) {
  const auto of = [](const std::string& line) { return fault_of("[laws.constants]\n" + line + "\n"); };
  EXPECT_EQ(of("F_s = \"1 parsec\""),
            "f.toml:2:7: laws.constants.F_s: the value of F_s, \"1 parsec\": \"parsec\" is not "
            "a unit");
  EXPECT_NE(of("F_s = true").find("F_s is a flag; write a number with its unit in quotes"), std::string::npos);
  EXPECT_NE(of("kappa = 1").find("kappa is taken: it is an argument of a law"), std::string::npos);
  EXPECT_NE(of("\"F s\" = 1").find("\"F s\" is no name"), std::string::npos);
  EXPECT_NE(of("F_s = { range = [1, 2] }").find("has no value"), std::string::npos);
  EXPECT_NE(of("F_s = { value = 1, rnge = [1, 2] }").find("no such key as rnge; a constant has value and range"),
            std::string::npos);
  EXPECT_NE(of("F_s = { value = \"1 nN\", range = [\"2 nN\", \"1 nN\"] }")
                .find("begins at 2 nN and ends at 1 nN; the lower bound comes first"),
            std::string::npos);
  EXPECT_NE(of("F_s = { value = \"1 nN\", range = [\"1 nN\", \"1 nN\"] }").find("begins at 1 nN"), std::string::npos);
  EXPECT_NE(of("F_s = { value = \"3 nN\", range = [\"1 nN\", \"2 nN\"] }")
                .find("F_s = 3 nN is out of its range; allowed is >= 1 and <= 2 nN"),
            std::string::npos);
  EXPECT_NE(of("F_s = { value = \"3 nN\", range = [\"1 nN\", \"2 Pa\"] }").find("\"2 Pa\" is a stress, but a force is"),
            std::string::npos);
  EXPECT_NE(of("F_s = { value = \"3 nN\", range = [\"1 nN\"] }").find("of 1 values; write it like"), std::string::npos);
  EXPECT_NE(of("F_s = { value = \"3 nN\", range = \"1 nN\" }").find("is a string; write it like"), std::string::npos);
  EXPECT_EQ(faults_of("[laws.constants]\nF_s = \"1 x\"\nF_c = \"2 x\"\n").size(), 2U);
  EXPECT_EQ(faults_of(law + "[laws.constants]\nF_s = \"1 x\"\n").size(), 1U) << "and no law that names it";
}

TEST(ConstantFaults, OfOneAloneAreThoseOfAnyParameter) {
  const auto of = [](const std::string& override) { return fault_of(table, {"laws.constants." + override}); };
  EXPECT_EQ(of("F_z=0.4 nN"),
            "--set: laws.constants.F_z: there is no such constant; there are F_s, n, r_0; did you mean "
            "F_s?; define it in the scenario, below [laws.constants]: F_z = \"0.1 nN\"");
  EXPECT_NE(of("F_s=0.4 Pa").find("is a stress, but a force is expected"), std::string::npos);
  EXPECT_NE(of("n=0.4 Pa").find("is a string; write a bare number"), std::string::npos);
  EXPECT_NE(of("F_s=").find("is not a number with a unit"), std::string::npos);
  EXPECT_NE(of("F_s={ value = 1 }").find("is a table, but a number with its unit is expected"), std::string::npos);
  const std::string bounded = "[laws.constants]\nF_s = { value = \"0.4 nN\", range = [\"0.1 nN\", \"1 nN\"] }\n";
  EXPECT_EQ(fault_of(bounded, {"laws.constants.F_s=2 nN"}),
            "--set: laws.constants.F_s: \"2 nN\" is out of range; allowed is >= 0.1 and <= 1 nN");
  EXPECT_NE(fault_of("", {"laws.constants.F_s=2 nN"}).find("there is no such constant; there are none; define it"),
            std::string::npos);
}

} // namespace
} // namespace matrigrate
