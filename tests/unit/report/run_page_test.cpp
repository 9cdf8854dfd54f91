#include "report/run_page.hpp"

#include "ecm/bonds.hpp"
#include "ecm/loop/fibres.hpp"
#include "report/film_json.hpp"
#include "tables/run_files.hpp"
#include "unit/draw/markup.hpp"
#include "unit/observe/frames.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <stdexcept>

namespace matrigrate::report {
namespace {

using nlohmann::ordered_json;

constexpr std::string_view page_template =
    "<html><script type=\"application/json\" id=\"matrigrate-data\">null</script></html>";

TEST(RunPage, HoldsTheRun) {
  const SmallRun run;
  const observe::Film film = run.film();
  const std::vector<TrackRow> rows{{.t = 0.0, .polarization = {}}, {.t = 60.0, .polarization = 0.5}};
  const std::vector<std::string_view> columns = store::health_columns();
  std::string health = store::csv_line({columns.begin(), columns.end()});
  for (const HealthRow& row :
       {HealthRow{.max_iterations = 3, .area_ratio = 1.0, .density_min = 1.0, .density_max = 1.0},
        HealthRow{.max_iterations = 7,
        .area_ratio = 0.75,
        .density_min = 0.5,
        .density_max = 1.25,
        .orphans = 2,
        .force_imbalance = 0.125}})
    health += store::csv_line(store::fields(row));
  const std::vector<ProtrusionRecord> records{{.id = 1, .t_initiation = 4.0}};
  std::vector<CellResult> cells{{.rows = rows, .records = records}};
  cells[0].readouts.v_migr_abs = 4.5;
  const RunReport report{.title = "Run <1>",
                         .status = "Done.",
                         .facts = {{"seed", "7"}},
                         .p = run.p,
                         .cells = cells,
                         .health = health,
                         .film = &film,
                         .provenance = "commit"};
  const ordered_json data = run_data(report);
  EXPECT_EQ(data.at("format"), "matrigrate-run");
  EXPECT_EQ(data.at("facts").dump(), "[{\"name\":\"seed\",\"value\":\"7\"}]");
  EXPECT_EQ(data.at("summary"), "4.5 um/h from start to end, 0 protrusions.");
  EXPECT_NE(data.at("citation").get<std::string>().find("matrix: Insights from a computational model."),
            std::string::npos);
  EXPECT_EQ(data.at("readouts").dump().find("uniaxial"), std::string::npos) << "there are no fibres";
  EXPECT_EQ(data.at("geometry").at("n_particles"), run.s.ecm.size());
  EXPECT_EQ(data.at("tracks").at("polarization_rad").dump(), "[null,0.5]");
  EXPECT_EQ(data.at("protrusions").at(0).at("id"), 1);
  EXPECT_EQ(data.at("protrusions").at(0).at("cause"), "");
  EXPECT_EQ(data.at("protrusions").at(0).at("t_end_s").dump(), "null");
  const ordered_json& signs = data.at("health");
  const std::vector<std::pair<std::string, std::string>> expected{{"solver_iterations_max", "7.0"},
                                                                  {"solver_residual_max", "0.0"},
                                                                  {"force_imbalance", "0.125"},
                                                                  {"n_orphans", "2.0"},
                                                                  {"n_torn", "0.0"},
                                                                  {"n_engulfed", "0.0"},
                                                                  {"n_solid_inside", "0.0"},
                                                                  {"area_ratio", "0.25"},
                                                                  {"density_max", "0.5"}};
  ASSERT_EQ(signs.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(signs[k].at("name"), expected[k].first);
    EXPECT_EQ(signs[k].at("value").dump(), expected[k].second) << expected[k].first;
  }
  ASSERT_EQ(data.at("parameters").size(), 1U) << "those that differ from their default";
  EXPECT_EQ(data.at("parameters").at(0).at("name"), "ecm.radius");
  EXPECT_EQ(data.at("parameters").at(0).at("value"), "40 um");
  const ordered_json& frames = data.at("frames");
  EXPECT_EQ(frames.at("times_s").dump(), "[300.0,600.0]");
  EXPECT_EQ(frames.at("particles").at("x").at("per_frame"), run.s.ecm.size());
  EXPECT_FALSE(frames.at("particles").contains("fibre_von_mises"));
  EXPECT_FALSE(frames.contains("fibres"));
  EXPECT_EQ(frames.at("protrusions").at(0).at(0).at("anchor").dump(), "null");
  EXPECT_EQ(frames.at("protrusions").at(0).at(1).at("anchor").dump(), "[30.5,-1.25]");
  EXPECT_EQ(frames.at("protrusions").at(1).size(), 1U);
}

TEST(RunPage, TellsSeveralCellsApart) {
  const TwoCells run;
  const observe::Film film = run.film();
  std::vector<CellResult> cells(2);
  for (CellResult& cell : cells) {
    cell.rows = {{.t = 0.0, .polarization = {}}};
    cell.records = {{.id = 1, .t_initiation = 4.0}};
  }
  cells[1].cell = cells[1].rows[0].cell = 4;
  const ordered_json data = run_data({.p = run.p, .cells = cells, .film = &film});
  EXPECT_EQ(data.at("tracks").at("cell").dump(), "[1,5]");
  EXPECT_EQ(data.at("protrusions").at(1).at("cell"), 5);
  EXPECT_EQ(data.at("readouts").back().at("cell"), 5);
  EXPECT_EQ(data.at("geometry").at("n_outline"), 2 * run.p.cell.particles);
  const ordered_json& frames = data.at("frames");
  EXPECT_EQ(frames.at("outline").at("cell").size(), 470U);
  EXPECT_EQ(frames.at("outline").at("cell").at(235), 5);
  EXPECT_EQ(frames.at("protrusions").at(0).at(2).at("cell"), 5);
  EXPECT_EQ(frames.at("protrusions").at(0).at(2).at("centre"), 245) << "an index on the whole outline";
  const ordered_json one = run_data({.p = run.p, .cells = std::span(cells).first(1)});
  EXPECT_FALSE(one.at("tracks").contains("cell"));
  EXPECT_FALSE(one.at("readouts").back().contains("cell"));
}

TEST(RunPage, NeedsNoFramesAndNoRows) {
  EXPECT_TRUE(run_data({}).at("frames").is_null());
  const observe::Film none;
  EXPECT_TRUE(run_data({.film = &none}).at("frames").is_null());
}

TEST(RunPage, NamesEachBondOfTheFibresOnce) {
  Parameters p;
  EXPECT_TRUE(fibres_json(p).is_null());
  p.fibres.arrangement = FibreArrangement::uniaxial;
  for (const Lattice lattice : {Lattice::square, Lattice::hexagonal})
    for (const double half_angle : {28.0, 90.0}) {
      p.ecm.lattice = lattice;
      p.fibres.half_angle_deg = half_angle;
      const ordered_json fibres = fibres_json(p);
      EXPECT_EQ(2 * fibres.at("bonds_um").size(), fibre_bonds(p).count);
      for (const ordered_json& bond : fibres.at("bonds_um"))
        EXPECT_TRUE(joined(Vec2(bond.at(0).get<double>(), bond.at(1).get<double>()), p.fibres)) << bond.dump();
      EXPECT_EQ(fibres.at("onset"), p.fibres.onset);
    }
}

TEST(RunPage, LimitsLeaveOutFewSolidValues) {
  observe::Film film{.head = {}, .frames = {observe::Frame{}}};
  observe::Frame& frame = film.frames[0];
  for (int i = 0; i < 10000; ++i) {
    frame.matrix.pressure.push_back(static_cast<float>(i));
    frame.matrix.f_degr.push_back(i < 9000 ? 1.0F : 0.0F);
  }
  frame.matrix.pressure[17] = 1e9F;
  const Limits limits = usual_limits(film, &observe::MatrixFrame::pressure);
  EXPECT_EQ(limits.low, 0.0);
  EXPECT_NEAR(limits.high, 8996.0, 2.0) << "neither the one that stands out nor the fluid";
}

TEST(FilledPage, PutsDataInItsPlaceWithoutATag) {
  const std::string page = filled_page(page_template, {{"title", "a </script> b"}});
  EXPECT_EQ(page, "<html><script type=\"application/json\" id=\"matrigrate-data\">"
                  "{\"title\":\"a \\u003c/script> b\"}</script></html>");
  EXPECT_THROW(filled_page("<html>", {}), std::invalid_argument);
  EXPECT_THROW(filled_page(std::string(page_template) + std::string(page_template), {}), std::invalid_argument);
}

} // namespace
} // namespace matrigrate::report
