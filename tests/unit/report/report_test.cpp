#include "base/file.hpp"
#include "report/film_json.hpp"
#include "report/run_page.hpp"
#include "report/verdict_page.hpp"
#include "store/deflate.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

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

namespace matrigrate {
namespace {

// What the viewer and the documents say as the program does.

/// A file of the source, with line breaks as blanks.
std::string source(const std::string& name) {
  std::string text = read_file(std::filesystem::path(MATRIGRATE_SOURCE_DIR) / name, 1U << 20U);
  std::ranges::replace(text, '\n', ' ');
  return text;
}

TEST(SharedTexts, NameThePaperByItsWholeTitle) {
  const std::string title = "The role of actin protrusion dynamics in cell migration through a degradable viscoelastic "
                            "extracellular matrix: Insights from a computational model";
  EXPECT_NE(report::citation().find(title + ". PLoS Comput Biol"), std::string::npos);
  for (const char* name : {"README.md", "CITATION.cff"}) EXPECT_NE(source(name).find(title), std::string::npos) << name;
}

TEST(SharedTexts, CitationGivesCreditToTheProgramToo) {
  const std::string citation = source("CITATION.cff");
  EXPECT_NE(citation.find("references:"), std::string::npos);
  EXPECT_EQ(citation.find("preferred-citation:"), std::string::npos) << "readers would cite nothing else";
}

} // namespace
} // namespace matrigrate

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
