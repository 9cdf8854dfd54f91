#include "tables/run_files.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "tables/table.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>

namespace matrigrate::store {
namespace {

/// A file name that is taken away at the end.
struct Scratch {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("matrigrate-rows-" + std::to_string(::getpid()) + ".csv");
  ~Scratch() { std::filesystem::remove(path); }
};

TEST(CsvLine, WritesEachKindOfField) {
  EXPECT_EQ(csv_line({0.1, std::uint64_t{18446744073709551615U}, undefined, "word", "a,b", "say \"x\""}),
            "0.1,18446744073709551615,,word,\"a,b\",\"say \"\"x\"\"\"\n");
}

TEST(RowFile, ReachesTheDiskRowByRow) {
  const Scratch scratch;
  std::string rows;
  RowFile file(scratch.path, {"t_s", "cause"}, rows);
  EXPECT_EQ(read_file(scratch.path, 1000), "t_s,cause\n");
  file.add({0.4, "lost"});
  EXPECT_EQ(read_file(scratch.path, 1000), "t_s,cause\n0.4,lost\n");
  EXPECT_THROW(file.add({0.4}), std::invalid_argument);
  file.add({0.8, ""});
  EXPECT_EQ(read_file(scratch.path, 1000), "t_s,cause\n0.4,lost\n0.8,\n");
  EXPECT_EQ(rows, read_file(scratch.path, 1000));
}

TEST(RowFile, BeginsWithTheRowsThereAre) {
  const Scratch scratch;
  std::string other;
  { RowFile(scratch.path, {"t_s"}, other).add({7.0}); }
  std::string rows = "t_s\n0.4\n0.8\n";
  RowFile file(scratch.path, {"t_s"}, rows);
  file.add({1.2});
  EXPECT_EQ(read_file(scratch.path, 1000), "t_s\n0.4\n0.8\n1.2\n") << "in place of what there was";
}

TEST(RowFile, SaysWhenItCannotBeWritten) {
  std::string rows;
  EXPECT_THROW(RowFile("/nonexistent/folder/t.csv", {"t_s"}, rows), InputOutputError);
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
  EXPECT_THROW(RowFile("/dev/full", {"t_s"}, rows), InputOutputError);
}

TEST(RunFiles, HaveAFieldForEachColumn) {
  EXPECT_EQ(fields(TrackRow{}).size(), track_columns().size());
  EXPECT_EQ(fields(TrackRow{.polarization = {}, .nucleus = NucleusRow{}}).size(), track_columns(true).size());
  EXPECT_EQ(track_columns(true).size(), track_columns().size() + 4);
  EXPECT_EQ(fields(HealthRow{}).size(), health_columns().size());
  EXPECT_EQ(fields(ProtrusionRecord{}, {}).size(), protrusion_columns().size());
}

TEST(RunFiles, KeepTheirOrderOfColumns) {
  TrackRow track;
  track.t = 60.0;
  track.step = 150;
  track.centre = {1, 2};
  track.area = 3;
  track.perimeter = 4;
  track.initiated = 9;
  track.in_phase = {1, 2, 3, 0};
  EXPECT_EQ(csv_line(fields(track)), "1,60,1,2,3,4,,6,1,2,3,0,9,150\n");
  track.polarization = -0.5;
  EXPECT_EQ(csv_line(fields(track)), "1,60,1,2,3,4,-0.5,6,1,2,3,0,9,150\n");
  track.cell = 2;
  EXPECT_TRUE(csv_line(fields(track)).starts_with("3,60,"));
}

TEST(Tracks, AreReadBackToTheLastBit) {
  const TrackRow first{.t = 1.0 / 3.0,
                       .step = (std::uint64_t{1} << 53U) - 1,
                       .centre = {0.1, -0.2},
                       .area = 5.0 / 7.0,
                       .perimeter = 1e-300,
                       .polarization = {},
                       .in_phase = {1, 0, 2, 3},
                       .initiated = 2};
  TrackRow second = first;
  second.cell = 3;
  second.polarization = -0.3;
  for (const bool nucleus : {false, true}) {
    const std::vector<std::string_view> columns = track_columns(nucleus);
    std::string text = csv_line({columns.begin(), columns.end()});
    for (TrackRow written : {second, first}) {
      if (nucleus) written.nucleus = {.centre = {1.0 / 3.0, 2.0}, .area = 70.5, .aspect = 1.25};
      text += csv_line(fields(written));
    }
    const std::vector<TrackRow> rows = track_rows_of(text);
    ASSERT_EQ(rows.size(), 2U);
    std::string again = csv_line({columns.begin(), columns.end()});
    for (const TrackRow& row : rows) again += csv_line(fields(row));
    EXPECT_EQ(again, text);
    EXPECT_EQ(rows[0].cell, 3U);
    EXPECT_EQ(rows[0].polarization, -0.3);
    EXPECT_EQ(rows[1].t, first.t);
    EXPECT_EQ(rows[1].step, first.step);
    EXPECT_EQ(rows[1].centre, first.centre);
    EXPECT_EQ(rows[1].perimeter, first.perimeter);
    EXPECT_EQ(rows[1].in_phase, first.in_phase);
    EXPECT_FALSE(rows[1].polarization);
    EXPECT_EQ(rows[1].nucleus.has_value(), nucleus);
  }
}

TEST(Health, IsWrittenToTheLastBit) {
  const HealthRow written{
      .t = 1.0 / 3.0, .step = 7, .iterations = 4, .residual = 1e-300, .torn = 3, .crosses_itself = true};
  const std::vector<std::string_view> columns = health_columns();
  const std::string text = csv_line({columns.begin(), columns.end()}) + csv_line(fields(written));
  const Table read = read_table(text);
  ASSERT_EQ(read.rows.size(), 1U);
  EXPECT_EQ(read.column("t_s")[0], written.t);
  EXPECT_EQ(read.column("solver_residual")[0], 1e-300);
  EXPECT_EQ(read.column("n_torn")[0], 3.0);
  EXPECT_EQ(read.column("crosses_itself")[0], 1.0);
  EXPECT_TRUE(std::isnan(read.column("area_ratio")[0]));
  EXPECT_THROW(group_rows_of(text), InputOutputError) << "another table";
}

TEST(Tracks, AreNoOtherTable) {
  const std::vector<std::string_view> columns = track_columns();
  const std::string header = csv_line({columns.begin(), columns.end()});
  EXPECT_TRUE(track_rows_of(header).empty());
  const std::string row = "1,60,1,2,3,4,,6,1,2,3,0,9,150\n";
  EXPECT_EQ(track_rows_of(header + row).size(), 1U);
  for (const std::string& text :
       {std::string(), std::string("t_s\n1\n"), header + "1,2\n", header + "0" + row.substr(1),
        header + "1,60,1,2,3,4,,6,1,2,3,0,9,\n", header + "1,60,1,2,3,4,,6,1,2,-3,0,9,150\n",
        header + "1,60,1,2,3,4,,6,1,2,3,0,9,1e99\n", header + "one" + row.substr(1)})
    EXPECT_THROW(track_rows_of(text), InputOutputError) << text;
}

TEST(RunFiles, ProtrusionsHaveTheTimesOfTheirTransitions) {
  ProtrusionRecord r;
  r.id = 3;
  r.centre = 17;
  r.t_initiation = 100.0;
  r.t_adhesion = 500.0;
  r.t_mature = 1100.0;
  r.t_disassembly = 2000.0;
  r.length = 25.5;
  r.direction = std::numbers::pi / 2.0;
  r.f_mat = 0.5;
  r.force = 0.3;
  r.cause = EndCause::rupture;
  std::vector<CellResult> cells{{.records = {r}}};
  const std::string columns = "id,centre_particle,t_initiation_s,t_adhesion_s,t_mature_s,t_disassembly_s,t_end_s,"
                              "length_um,direction_deg,f_mat,force_nN,f_adh_rel,cause\n";
  const std::string row = "3,17,100,500,1100,2000,,25.5,90,0.5,0.3,0.5,rupture\n"; // of both strands: 2 x 0.5 x 0.6 nN
  EXPECT_EQ(protrusions_csv(cells, {}), columns + row);
  cells.push_back({.cell = 1, .records = {r}});
  EXPECT_EQ(protrusions_csv(cells, {}), "cell," + columns + "1," + row + "2," + row);
}

TEST(Summary, IsTheSameInBothFormats) {
  ReadOuts r;
  r.duration = 3600.0;
  r.v_migr_abs = 4.5;
  r.n_protrusions = 7;
  const std::vector<CellResult> cells{{.readouts = r}};
  const std::string csv = summary_csv(cells);
  EXPECT_TRUE(csv.starts_with("duration_s,v_migr_abs_um_per_h,"));
  EXPECT_TRUE(csv.find("\n3600,4.5,,,7,0,,0,") != std::string::npos) << csv;
  const auto json = nlohmann::json::parse(summary_json(cells));
  EXPECT_EQ(json.at("v_migr_abs_um_per_h"), 4.5);
  EXPECT_EQ(json.at("n_protrusions"), 7);
  EXPECT_TRUE(json.at("tau_prot_min").is_null());
  EXPECT_EQ(json.size(), named_values(r).size());
}

TEST(Summary, HasARowForEachOfSeveralCells) {
  std::vector<CellResult> cells(2);
  cells[1].cell = 1;
  cells[0].readouts.n_protrusions = 7;
  cells[1].readouts.n_protrusions = 1;
  const std::string csv = summary_csv(cells);
  EXPECT_TRUE(csv.starts_with("cell,duration_s,")) << csv;
  EXPECT_NE(csv.find("\n1,,,,,7,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\n2,,,,,1,"), std::string::npos) << csv;
  const auto json = nlohmann::json::parse(summary_json(cells));
  EXPECT_EQ(json.at("cells").at(1).at("cell"), 2);
  EXPECT_EQ(json.at("cells").at(1).at("n_protrusions"), 1);
  EXPECT_EQ(result_sentence(cells), "Cell 1: 7 protrusions. Cell 2: 1 protrusion.");
}

TEST(Msd, HasTheNumberOfTheCellWhereThereAreSeveral) {
  std::vector<CellResult> cells(1);
  for (int k = 0; k < 4; ++k) cells[0].rows.push_back({.t = 600.0 * k, .centre = {1.0 * k, 0.0}, .polarization = {}});
  EXPECT_EQ(msd_csv(cells, 600.0), "lag_s,msd_um2,samples\n600,1,3\n");
  cells.push_back(cells[0]);
  cells[1].cell = 1;
  EXPECT_EQ(msd_csv(cells, 600.0), "cell,lag_s,msd_um2,samples\n1,600,1,3\n2,600,1,3\n");
}

TEST(Summary, LeavesOutForPeopleWhatARunCannotHave) {
  Parameters p;
  constexpr std::size_t of_claims = 7;
  EXPECT_EQ(named_values({}).size(), shown_values({}, p).size() + 10 + of_claims);
  for (const NamedValue& v : shown_values({}, p)) EXPECT_EQ(v.meaning.find("fibres"), std::string_view::npos) << v.name;
  p.fibres.arrangement = FibreArrangement::uniaxial;
  EXPECT_EQ(named_values({}).size(), shown_values({}, p).size() + of_claims);
}

TEST(Summary, SaysInASentenceWhatCameOut) {
  ReadOuts r;
  EXPECT_EQ(result_sentence(r), "0 protrusions.");
  r.v_migr_abs = 12.68;
  r.msd_slope = 1.42;
  r.n_protrusions = 21;
  EXPECT_EQ(result_sentence(r), "12.7 um/h from start to end, persistent (MSD slope 1.42), 21 protrusions.");
  r.msd_slope = 1.1;
  r.n_protrusions = 1;
  EXPECT_EQ(result_sentence(r), "12.7 um/h from start to end, like a random walk (MSD slope 1.1), 1 protrusion.");
  r.msd_slope = 0.5;
  EXPECT_NE(result_sentence(r).find("confined"), std::string::npos);
}

TEST(Summary, IsReadable) {
  EXPECT_EQ(readable(undefined), "-");
  EXPECT_EQ(readable(1.23456), "1.235");
  EXPECT_EQ(readable(std::uint64_t{12}), "12");
}

} // namespace
} // namespace matrigrate::store
