#include "report/verdict_page.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <stdexcept>

namespace matrigrate::report {
namespace {

Plot curves() {
  return {.name = "creep",
          .title = "Creep",
          .caption = "A layer.",
          .x_label = "time [s]",
          .y_label = "u [um]",
          .log_y = true,
          .series = {{.label = "measured", .x = {0.0, 1.0}, .y = {2.0, std::numeric_limits<double>::quiet_NaN()}},
                     {.label = "law", .x = {0.0}, .y = {2.0}, .mark = Mark::dashed, .colour = 0},
                     {.label = "other", .mark = Mark::points}}};
}

TEST(VerdictPage, PlotsAreDataWithTheirColours) {
  const auto plot = plot_json(curves());
  EXPECT_EQ(plot.at("x_label"), "time [s]");
  EXPECT_FALSE(plot.at("log_x").get<bool>());
  EXPECT_TRUE(plot.at("log_y").get<bool>());
  EXPECT_EQ(plot.at("series").at(0).at("y").dump(), "[2.0,null]") << "what is not finite is written as null";
  EXPECT_EQ(plot.at("series").at(1).at("mark"), "dashed");
  EXPECT_EQ(plot.at("series").at(1).at("colour"), 0) << "that of the first, as it asks for";
  EXPECT_EQ(plot.at("series").at(2).at("colour"), 1) << "the next one";
  Plot uneven = curves();
  uneven.series[0].y.pop_back();
  EXPECT_THROW(plot_json(uneven), std::invalid_argument);
}

TEST(VerdictPage, HoldsEverythingOfAStatement) {
  Statement claim{.id = "A2",
                  .kind = "calibration",
                  .sentence = "rises & stays",
                  .verdict = Verdict::undecided,
                  .caveat = "not the paper's runs",
                  .published = "4.1 um/h",
                  .brief = "4.4",
                  .why_not = "too few",
                  .details = {{"Ours", {"at 50 Pa 4.4"}}, {"Conditions", {}}},
                  .studies = {"stiffness"},
                  .plots = {curves()},
                  .pictures = {{"map", "What it shows.", "<svg></svg>"}}};
  claim.checks.push_back({{"quantity", "E [Pa]"}});
  const auto data = verdict_data({.title = "Claims",
                                  .facts = {{"command", "matrigrate reproduce A"}},
                                  .setting = "Replicates: 2.",
                                  .statements = {claim},
                                  .provenance = "commit 1234"});
  EXPECT_EQ(data.at("format"), "matrigrate-verdicts");
  EXPECT_EQ(data.at("facts").at(0).at("value"), "matrigrate reproduce A");
  EXPECT_EQ(data.at("setting"), "Replicates: 2.");
  EXPECT_EQ(data.at("provenance"), "commit 1234");
  EXPECT_FALSE(data.at("citation").get<std::string>().empty());
  EXPECT_TRUE(data.at("studies").is_array());
  const auto& one = data.at("statements").at(0);
  for (const auto& [key, value] : std::map<std::string, std::string>{{"id", "A2"},
                                                                     {"kind", "calibration"},
                                                                     {"sentence", "rises & stays"},
                                                                     {"verdict", "undecided"},
                                                                     {"caveat", "not the paper's runs"},
                                                                     {"published", "4.1 um/h"},
                                                                     {"brief", "4.4"},
                                                                     {"why_not", "too few"}})
    EXPECT_EQ(one.at(key), value) << key;
  EXPECT_EQ(one.at("details").dump(), R"([{"name":"Ours","sentences":["at 50 Pa 4.4"]}])") << "no empty lists";
  EXPECT_EQ(one.at("checks").at(0).at("quantity"), "E [Pa]");
  EXPECT_EQ(one.at("claims").dump(), "[]");
  EXPECT_EQ(one.at("studies").at(0), "stiffness");
  EXPECT_EQ(one.at("plots").at(0).at("name"), "creep");
  EXPECT_EQ(one.at("pictures").at(0).at("svg"), "<svg></svg>");
}

} // namespace
} // namespace matrigrate::report
