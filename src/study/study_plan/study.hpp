#pragma once

#include "parameters/parameters.hpp"
#include "study_plan/claim.hpp"
#include "tables/cell_tracks.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// A study: the same simulation at several points of parameter space, several seeds at each.
namespace matrigrate::study {

/// A parameter and its value as it stands in a scenario file (value_text): "ecm.youngs_modulus", "\"50 Pa\"".
struct Setting {
  std::string key;
  std::string value;

  bool operator==(const Setting&) const = default;
};

/// A set of values that a design varies, without the conditions.
struct FactorSet {
  std::string label;             ///< unique among the sets of its study
  std::vector<Setting> settings; ///< what differs from the base, by key
};

/// A condition under which each factor set is run: an experiment, as parameters.
struct Condition {
  std::string label; ///< unique among the conditions of its study
  std::vector<Setting> settings;
};

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
  double low = 0.0;                                               ///< in the unit of the read-out
  double high = 0.0;                                              ///< equal to low for a single value
  double error = 1.0;                                             ///< standard error of what was measured, > 0
  double weight = 1.0;                                            ///< > 0
  std::vector<std::size_t> at;                                    ///< conditions that it holds at; empty: all
  std::shared_ptr<const std::vector<tracks::CellTrack>> tracks{}; ///< that tell value and error; those of one file once
  std::vector<std::string> notes{};                               ///< what the reader of these tracks has to tell
};

/// Which points are compared: neighbours along one parameter, all with all, all with one, or none.
enum class Pairs { none, adjacent, all, control };

enum class TestKind { t, welch, mann_whitney };

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
const std::vector<std::string>& default_readouts();

/// The names of readout_table().
std::vector<std::string> all_readouts();

/// Column of a read-out in all_readouts().
/// @throws std::invalid_argument if there is no such read-out
std::size_t readout_column(std::string_view readout);

/// The parameters that differ between points, each once, in the order in which they are first named.
std::vector<std::string> swept_keys(const Study& study);

/// The measured tracks of the targets, those of each file once, in the order in which they are first named.
std::vector<std::shared_ptr<const std::vector<tracks::CellTrack>>> measured_sets(const Study& study);

/// The file beside study.resolved.toml that holds the k-th of them: "measured-1.csv".
std::string measured_file(std::size_t k);

/// True if the runs of a point have several cells.
bool has_several_cells(const Study& study);

} // namespace matrigrate::study
