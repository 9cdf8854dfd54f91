#pragma once

#include "parameters/parameters.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// A study: the same simulation at several points of parameter space, several seeds at each.
namespace matrigrate::study {

/// A parameter and its value as it stands in a scenario file (value_text): "ecm.youngs_modulus", "\"50 Pa\"".
struct Setting {
  std::string key;
  std::string value;

  bool operator==(const Setting&) const = default;
};

/// A point of parameter space.
struct Point {
  std::string label;             ///< unique in its study
  std::vector<Setting> settings; ///< what differs from the base, by key
  Parameters parameters;         ///< the base with these settings
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
  std::vector<Point> points;
  Comparisons comparisons;

  std::size_t runs() const { return points.size() * replicates; }
};

/// The paper's read-outs, which a study compares if it names none.
const std::vector<std::string>& default_readouts();

/// Every read-out that a run has: those of summary.json and those of table_readouts.hpp.
std::vector<std::string> all_readouts();

/// The parameters that differ between points, each once, in the order in which they are first named.
std::vector<std::string> swept_keys(const Study& study);

} // namespace matrigrate::study
