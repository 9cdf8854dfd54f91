#include "observe/readouts.hpp"

#include "observe/readout_table.hpp"
#include "parameters/nearest.hpp"
#include "protrusion/adhesion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

using namespace matrigrate;

namespace {

/// Rows every `interval` s along a zigzag: 1 um in x a minute, and 1 um up or down every minute.
std::vector<TrackRow> zigzag(double interval, int n) {
  std::vector<TrackRow> rows(static_cast<std::size_t>(n) + 1);
  for (int k = 0; k <= n; ++k) {
    TrackRow& row = rows[static_cast<std::size_t>(k)];
    row.t = interval * k;
    const double minutes = row.t / 60.0;
    row.centre = {minutes, std::abs(std::remainder(minutes, 2.0))};
  }
  return rows;
}

/// A protrusion that adhered at 400 s and matured at 1000 s.
ProtrusionRecord mature(std::uint32_t id, double length, double f_mat) {
  ProtrusionRecord r;
  r.id = id;
  r.t_initiation = 0.0;
  r.t_adhesion = 400.0;
  r.t_mature = 1000.0;
  r.length = length;
  r.f_mat = f_mat;
  return r;
}

ProtrusionRecord ended(ProtrusionRecord r, EndCause cause, double t, double force) {
  r.cause = cause;
  r.t_disassembly = t;
  r.force = force;
  return r;
}

} // namespace

TEST(ReadOutTable, HasTheReadOutsThatHintsName) {
  for (const char* word : {"speed", "cell.velocity", "migration_speed", "run.persistence"}) {
    const std::string hint = parameter_hint(word);
    const std::string before = "the read-out ";
    const std::size_t at = hint.find(before);
    ASSERT_NE(at, std::string::npos) << word << hint;
    const std::string name = hint.substr(at + before.size(), hint.find(',', at) - at - before.size());
    EXPECT_NE(find_readout(name), nullptr) << name;
  }
}

TEST(PathLength, DependsOnTheSampling) {
  const auto rows = zigzag(30.0, 40); // 20 min
  EXPECT_NEAR(path_length(rows, 30.0), 20.0 * std::numbers::sqrt2, 1e-9);
  EXPECT_NEAR(path_length(rows, 60.0), 20.0 * std::numbers::sqrt2, 1e-9);
  EXPECT_NEAR(path_length(rows, 120.0), 20.0, 1e-9) << "every second minute: only the way ahead is left";
  EXPECT_NEAR(path_length(rows, 600.0), 20.0, 1e-9);
}

TEST(PathLength, EndsAtTheLastRow) {
  const auto rows = zigzag(60.0, 15); // 15 min: one sample at 10 min, then the end
  EXPECT_NEAR(path_length(rows, 600.0), 10.0 + std::hypot(5.0, 1.0), 1e-9);
}

TEST(PathLength, TakesTimesThatAreRounded) {
  auto rows = zigzag(60.0, 20);
  for (TrackRow& row : rows) row.t *= 1.0 - 1e-12;
  EXPECT_NEAR(path_length(rows, 60.0), 20.0 * std::numbers::sqrt2, 1e-6);
}

TEST(PathLength, IsUndefinedForCoarseOrShortTracks) {
  EXPECT_TRUE(std::isnan(path_length(zigzag(120.0, 10), 60.0)));
  EXPECT_TRUE(std::isnan(path_length(zigzag(30.0, 4), 600.0)));
  EXPECT_TRUE(std::isnan(path_length({}, 60.0)));
}

TEST(ReadOuts, GiveSpeedsInMicrometresAnHour) {
  const ReadOuts r = readouts(zigzag(60.0, 60), {}, Parameters{});
  EXPECT_EQ(r.duration, 3600.0);
  EXPECT_NEAR(r.v_migr_abs, 60.0, 1e-9);
  EXPECT_NEAR(r.v_migr_path_60s, 60.0 * std::numbers::sqrt2, 1e-9);
  EXPECT_NEAR(r.v_migr_path_600s, 60.0, 1e-9);
}

TEST(ReadOuts, AverageTheProtrusionsForWhichAValueIsDefined) {
  Parameters p;
  p.actomyosin.force = 0.25; // 0.5 in both strands
  ProtrusionRecord unadhered;
  unadhered.id = 4;
  unadhered.length = 9.0;
  unadhered = ended(unadhered, EndCause::unadhered, 400.0, undefined);
  ProtrusionRecord lost_early = mature(5, 22.0, undefined);
  lost_early.t_mature = undefined;
  lost_early = ended(lost_early, EndCause::lost, 700.0, 0.3);
  const std::vector<ProtrusionRecord> records{
      ended(mature(1, 20.0, 0.4), EndCause::disassembly, 1600.0, 0.1), // 10 min, 0.1 / (0.4 0.5) = 0.5
      ended(mature(2, 24.0, 0.8), EndCause::rupture, 2200.0, 0.4),     // 20 min, 1
      mature(3, 26.0, 0.6),                                            // still adheres
      unadhered, lost_early};
  const ReadOuts r = readouts({}, records, p);
  EXPECT_EQ(r.n_protrusions, 5U);
  EXPECT_EQ(r.n_unadhered, 1U);
  EXPECT_EQ(r.n_censored, 1U);
  EXPECT_EQ(r.tau_prot.n, 2U);
  EXPECT_NEAR(r.tau_prot.value, 15.0, 1e-12);
  EXPECT_EQ(r.l_prot.n, 4U) << "the one that never adhered is left out";
  EXPECT_NEAR(r.l_prot.value, 23.0, 1e-12);
  EXPECT_NEAR(r.f_mat.value, 0.6, 1e-12);
  EXPECT_NEAR(r.force.value, 0.25, 1e-12) << "the one lost before it matured is left out";
  EXPECT_NEAR(r.f_adh_rel.value, 0.75, 1e-12);
  EXPECT_TRUE(std::isnan(r.v_migr_abs));
}

TEST(ReadOuts, TellProtrusionsAlongFibresFromThoseAcross) {
  Parameters p;
  p.fibres.arrangement = FibreArrangement::uniaxial;
  p.fibres.direction_deg = 60.0;
  const auto towards = [](double degrees, ProtrusionRecord r) {
    r.direction = degrees * std::numbers::pi / 180.0;
    return r;
  };
  const std::vector<ProtrusionRecord> records{
      towards(70.0, ended(mature(1, 20.0, 0.9), EndCause::disassembly, 1600.0, 0.1)),
      towards(-110.0, ended(mature(2, 20.0, 0.7), EndCause::rupture, 1600.0, 0.1)),
      towards(30.0, ended(mature(3, 20.0, 0.5), EndCause::lost, 1600.0, 0.1)), // neither disassembled nor ruptured
      towards(150.0, ended(mature(4, 20.0, 0.2), EndCause::rupture, 1600.0, 0.1)),
      towards(-10.0, mature(5, 20.0, 0.3))}; // still adheres
  const ReadOuts r = readouts({}, records, p);
  EXPECT_NEAR(r.along.f_mat.value, 0.7, 1e-12);
  EXPECT_NEAR(r.along.ruptured.value, 0.5, 1e-12);
  EXPECT_EQ(r.along.ruptured.n, 2U);
  EXPECT_NEAR(r.across.f_mat.value, 0.25, 1e-12);
  EXPECT_NEAR(r.across.ruptured.value, 1.0, 1e-12);
  EXPECT_EQ(r.across.ruptured.n, 1U);
  p.fibres.arrangement = FibreArrangement::isotropic;
  EXPECT_TRUE(std::isnan(readouts({}, records, p).across.f_mat.value));
}

TEST(ReadOuts, CountSimultaneousProtrusions) {
  auto rows = zigzag(60.0, 3);
  rows[1].in_phase = {1, 0, 1, 0};
  rows[2].in_phase = {1, 1, 0, 1};
  rows[3].in_phase = {0, 0, 0, 1};
  const ReadOuts r = readouts(rows, {}, Parameters{});
  EXPECT_EQ(r.max_simultaneous, 3U);
  EXPECT_NEAR(r.mean_simultaneous, 1.5, 1e-12);
}

TEST(ReadOuts, AreUndefinedWithoutProtrusionsOrRows) {
  const ReadOuts r = readouts({}, {}, Parameters{});
  for (const double value : {r.duration, r.v_migr_abs, r.v_migr_path_60s, r.tau_prot.value, r.l_prot.value,
                             r.f_mat.value, r.force.value, r.f_adh_rel.value, r.mean_simultaneous})
    EXPECT_TRUE(std::isnan(value));
}

TEST(ReadOutTable, NamesEachReadOutOnce) {
  std::set<std::string_view> names;
  for (const ReadOutSpec& spec : readout_table()) {
    EXPECT_TRUE(names.insert(spec.name).second) << spec.name;
    EXPECT_TRUE(spec.name.starts_with(spec.label)) << spec.name;
    EXPECT_EQ(find_readout(spec.name), &spec);
  }
  EXPECT_EQ(find_readout("v_migr"), nullptr);
  EXPECT_EQ(std::ranges::count_if(readout_table(), &ReadOutSpec::usual), 8);
}

TEST(ReadOutTable, ReadsItsMember) {
  ReadOuts r;
  r.v_migr_abs = 12.5;
  r.n_protrusions = 7;
  EXPECT_EQ(std::get<double>(find_readout("v_migr_abs_um_per_h")->value(r)), 12.5);
  EXPECT_EQ(std::get<std::uint64_t>(find_readout("n_protrusions")->value(r)), 7U);
  EXPECT_EQ(find_readout("v_migr_abs_um_per_h")->meaning_with_unit(), "speed, start to end (um/h)");
  EXPECT_EQ(find_readout("n_protrusions")->meaning_with_unit(), "protrusions initiated");
}

TEST(ReadOutTable, HasThoseOfGroupsLast) {
  const auto specs = readout_table();
  EXPECT_TRUE(std::ranges::is_partitioned(specs, [](const ReadOutSpec& spec) { return !spec.of_groups; }));
  EXPECT_EQ(std::ranges::count_if(specs, &ReadOutSpec::of_groups), 4);
}

TEST(ReadOuts, HaveSharesOfAdhesionsAndTimes) {
  const Parameters p;
  const double pull = mature_pull(0.5, p);
  const std::vector<ProtrusionRecord> records{ended(mature(1, 9.0, 0.5), EndCause::disassembly, 2000.0, 0.2 * pull),
                                              ended(mature(2, 9.0, 0.5), EndCause::disassembly, 2000.0, 0.9 * pull),
                                              mature(3, 9.0, 0.5)};
  std::vector<TrackRow> rows = zigzag(600.0, 3);
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k].in_phase = {static_cast<std::uint32_t>(k), 0, 1, 0};
  const ReadOuts r = readouts(rows, records, p);
  EXPECT_DOUBLE_EQ(r.share_low_force, 0.5) << "of those that ended";
  EXPECT_DOUBLE_EQ(r.share_2_or_3, 0.5) << "1, 2, 3 and 4 at a time";
  EXPECT_TRUE(std::isnan(readouts(rows, {}, p).share_low_force));
}

TEST(ReadOuts, TheMigrationIndexIsTheWayAlongXOverThePath) {
  // 5 um to (3, 4), 4 um down to (3, 0); the point at 300 s is left out.
  const std::vector<TrackRow> rows{{.t = 0.0, .centre = {0.0, 0.0}, .polarization = {}},
                                   {.t = 300.0, .centre = {-9.0, 9.0}, .polarization = {}},
                                   {.t = 600.0, .centre = {3.0, 4.0}, .polarization = {}},
                                   {.t = 1200.0, .centre = {3.0, 0.0}, .polarization = {}}};
  EXPECT_DOUBLE_EQ(readouts(rows, {}, Parameters{}).migration_index, 3.0 / 9.0);
  EXPECT_TRUE(std::isnan(readouts(std::span(rows).first(1), {}, Parameters{}).migration_index)) << "nothing moved";
}

TEST(ReadOuts, OfSeveralCellsTellWhatTheyDoTogether) {
  // The first cell goes straight away from the second, which goes at a right angle; the third, far off, goes towards
  // them.
  const auto path = [](const Vec2& from, const Vec2& to) {
    return std::vector<TrackRow>{{.t = 0.0, .centre = from, .polarization = {}},
                                 {.t = 600.0, .centre = to, .polarization = {}}};
  };
  std::vector<CellResult> cells{{.cell = 0, .rows = path({0.0, 0.0}, {-5.0, 0.0})},
                                {.cell = 1, .rows = path({30.0, 0.0}, {30.0, 5.0})},
                                {.cell = 2, .rows = path({200.0, 0.0}, {190.0, 0.0})}};
  const std::vector<GroupRow> group{{.nearest = 30.0, .contacts = 1},
                                    {.order = 0.25, .nearest = 31.0, .contacts = 1},
                                    {.order = 0.75, .nearest = 32.0},
                                    {.order = 0.5, .nearest = 33.0}};
  add_group(cells, group);
  EXPECT_DOUBLE_EQ(cells[0].readouts.parting_index, 1.0);
  EXPECT_DOUBLE_EQ(cells[1].readouts.parting_index, 0.0);
  EXPECT_DOUBLE_EQ(cells[2].readouts.parting_index, -1.0);
  for (const CellResult& cell : cells) {
    EXPECT_DOUBLE_EQ(cell.readouts.share_in_contact, 0.5);
    EXPECT_DOUBLE_EQ(cell.readouts.nearest, 33.0) << "at the end";
    EXPECT_DOUBLE_EQ(cell.readouts.order, 0.5) << "mean of those that are defined";
  }
  std::vector<CellResult> alone{{.rows = path({0.0, 0.0}, {1.0, 0.0})}};
  add_group(alone, group);
  EXPECT_TRUE(std::isnan(alone[0].readouts.parting_index)) << "a single cell has no group";
  EXPECT_TRUE(std::isnan(alone[0].readouts.nearest));
}
