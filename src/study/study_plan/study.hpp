#pragma once

#include "parameters/parameters.hpp"
#include "study_plan/claim.hpp"
#include "tables/cell_tracks.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// A study: the same simulation at several points of parameter space, several seeds at each.
/// Test: tests/unit/study_plan/plan_test.cpp
namespace matrigrate::study {

/// A parameter and its value as it stands in a scenario file (value_text): "ecm.youngs_modulus", "\"50 Pa\"".
struct Setting {
  std::string key;
  std::string value;

  bool operator==(const Setting&) const = default;
};

/// A set of values that a design varies, without the conditions.
struct FactorSet {
  std::string label;             ///< unique among the sets, or conditions, of its study
  std::vector<Setting> settings; ///< what differs from the base, by key
};

/// A condition under which each factor set is run: an experiment, as parameters.
using Condition = FactorSet;

using MeasuredTracks = std::shared_ptr<const std::vector<tracks::CellTrack>>;

/// A point of parameter space: a factor set under a condition.
struct Point {
  std::string label;                   ///< unique in its study
  std::vector<Setting> settings;       ///< what differs from the base, by key
  Parameters parameters;               ///< the base with these settings
  std::size_t set = 0;                 ///< index into Study::sets
  std::size_t condition = 0;           ///< index into Study::conditions; 0 if there are none
  std::vector<Setting> seeded_by = {}; ///< what the seeds follow from, if an earlier version named parameters that have
                                       ///< gone; empty: settings
};

/// What a read-out should be: a measured mean, or a range of them.
struct Target {
  std::string readout;
  double low = 0.0;                 ///< in the unit of the read-out
  double high = 0.0;                ///< equal to low for a single value
  double error = 1.0;               ///< standard error of what was measured, > 0
  double weight = 1.0;              ///< > 0
  std::vector<std::size_t> at;      ///< conditions that it holds at; empty: all
  MeasuredTracks tracks{};          ///< that tell value and error; those of one file once
  std::vector<std::string> notes{}; ///< what the reader of these tracks has to tell
};

/// Which points are compared: neighbours along one parameter, all with all, all with one, or none.
enum class Pairs { none, adjacent, all, control };

enum class TestKind { t, welch, mann_whitney };

/// How files call them, in their order.
inline const std::vector<std::string> pairs_names{"none", "adjacent", "all", "control"};
inline const std::vector<std::string> test_names{"t", "welch", "mann_whitney"};

struct Comparisons {
  Pairs pairs = Pairs::adjacent;
  std::string control; ///< label of the point that the others are compared with
  TestKind test = TestKind::t;
  double alpha = 0.05;
};

struct Study {
  std::string title;
  Parameters base; ///< the scenario with what the study fixes; its seed and threads are of no meaning
  std::size_t replicates = 1;
  std::uint64_t seed = 1;
  bool common_random_numbers = false; ///< the same seeds at each point
  std::vector<std::string> readouts;  ///< names as in summary.json
  std::vector<FactorSet> sets;
  std::vector<Condition> conditions;
  std::vector<Point> points; ///< each set under each condition, the conditions of a set side by side
  std::vector<Target> targets;
  Comparisons comparisons;
  std::vector<Claim> claims;

  std::size_t runs() const { return points.size() * replicates; }
};

/// The paper's read-outs, which a study compares if it names none.
std::vector<std::string> default_readouts();

/// The names of readout_table().
std::vector<std::string> all_readouts();

/// Column of a read-out in all_readouts().
/// @throws std::invalid_argument if there is no such read-out
std::size_t readout_column(std::string_view readout);

/// The labels of points, sets or conditions.
template <class Labelled>
std::vector<std::string> all_labels(const std::vector<Labelled>& all) {
  std::vector<std::string> labels;
  for (const Labelled& one : all) labels.push_back(one.label);
  return labels;
}

/// The parameters that differ between points, each once, in the order in which they are first named.
std::vector<std::string> swept_keys(const Study& study);

/// The measured tracks of the targets, those of each file once, in the order in which they are first named.
std::vector<MeasuredTracks> measured_sets(const Study& study);

/// The file beside study.resolved.toml that holds the k-th of them: "measured-1.csv".
std::string measured_file(std::size_t k);

/// True if the runs of a point have several cells.
bool has_several_cells(const Study& study);

/// One run.
struct Run {
  std::size_t point = 0;     ///< index into Study::points
  std::size_t replicate = 1; ///< from 1
  std::uint64_t seed = 0;
  std::string hash; ///< of all that decides on its results: the name of its folder

  bool operator==(const Run&) const = default;
};

/// The seed of a run: a hash of the study's seed, the settings of the point, sorted by key, and the replicate. So a run
/// keeps its seed whatever points and replicates are added, left out or put in another order.
/// @param settings  empty for common random numbers
/// @return at most 2^53 - 1, which every reader of JSON keeps
std::uint64_t run_seed(std::uint64_t study_seed, std::vector<Setting> settings, std::size_t replicate);

/// The seed of a run where the settings of its point are taken as they were typed, as versions did that took two
/// spellings of a law for two points. The seed of a run follows from their meaning (meant()).
std::uint64_t seed_as_typed(const Study& study, const Run& run);

/// The parameters of a run: those of its point, with its seed and one thread.
Parameters parameters_of(const Study& study, const Run& run);

/// A fingerprint of all parameters that decide on a run's results.
using Fingerprint = std::function<std::string(const Parameters&)>;

/// All runs, replicate by replicate, so that a study that is stopped early has something of every point.
std::vector<Run> planned_runs(const Study& study, const Fingerprint& fingerprint);

} // namespace matrigrate::study
