#pragma once

#include "statistics/elementary_effects.hpp"
#include "study/discrepancy.hpp"
#include "study/study.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What the factors of a screening design do. Test: tests/unit/study/effects_test.cpp
namespace matrigrate::study {

/// In place of a read-out: the discrepancy over all targets.
inline constexpr std::string_view discrepancy_readout = "discrepancy";

/// The effect of a factor on a read-out at a condition, or on the discrepancy.
///
/// One at a time: value minus base. Of read-outs the interval is that of Student's t over the differences of replicates
/// with common random numbers, otherwise Welch's; of the discrepancy it is by the bootstrap over replicates.
/// Morris: mu, mu* and sigma of the elementary effects, (y_to - y_from) / size of the step, as if the factor went
/// through its whole range; means over replicates are taken first. The interval is by the bootstrap over trajectories.
/// An effect on the discrepancy is defined where both sets were judged by the same targets.
struct Effect {
  Design design = Design::one_at_a_time;
  std::string factor;                         ///< path of the parameter
  std::string value;                          ///< as in a scenario; of Morris' design empty
  std::string readout;                        ///< or discrepancy_readout
  std::optional<std::size_t> condition;       ///< none: the study has none, or the discrepancy
  bool paired = false;                        ///< differences of replicates
  std::size_t n = 0;                          ///< pairs or, unpaired, runs of the smaller sample; targets; trajectories
  statistics::Interval effect{};              ///< one at a time; in the unit of the read-out
  statistics::ElementaryEffects elementary{}; ///< Morris
  std::size_t rank = 0; ///< from 1, among those with the same design, read-out and condition; 0: none

  /// What is ranked by its size: the effect, or mu*.
  const statistics::Interval& ranked() const { return design == Design::morris ? elementary.mu_star : effect; }
};

/// All factors by the discrepancy, if there are targets, and by all read-outs of the study at all conditions; those
/// with the same design, read-out and condition by rank.
std::vector<Effect> effects(const Study& study, const std::vector<Result>& results);

/// The results of a study of factors.
struct Screening {
  std::vector<Discrepancy> discrepancies; ///< one a factor set; empty without targets
  std::vector<Effect> effects;
};
Screening screening(const Study& study, const std::vector<Result>& results);

/// discrepancy.csv: a row a factor set, in the order of ranking().
std::string discrepancy_csv(const Study& study, const std::vector<Discrepancy>& all);

/// effects.csv: a row an effect.
std::string effects_csv(const Study& study, const std::vector<Effect>& effects);

/// A factor set, or a point, as people read it: its label; of a design whose labels only count ("sample 8", "trajectory
/// 2, step 1") the values of its factors to three digits: "youngs_modulus 138 Pa, viscosity 705 Pa s".
std::string set_text(const Study& study, std::size_t set);
std::string point_text(const Study& study, std::size_t point);

/// True if an effect has enough data for an interval: least_runs trajectories, or replicates.
bool has_interval(const Study& study, const Effect& effect);

} // namespace matrigrate::study
