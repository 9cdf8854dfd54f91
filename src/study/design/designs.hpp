#pragma once

#include "study/design/sweep.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Designs that screen factors: which of many parameters and choices matter at all.
/// Test: tests/unit/study/designs_test.cpp
namespace matrigrate::study {

/// Factor sets, and which of them differ in one factor; steps count the sets from 0.
struct Designed {
  std::vector<Draft> drafts;
  std::vector<Step> steps;
};

/// [one_at_a_time]: the base itself, labelled "base", and for each value of each list the base with that value alone. A
/// value that the base has anyway makes no set of its own.
Designed one_at_a_time_sets(const toml::table& lists, const Parameters& base, Allowance& allowance, FaultList& faults);

/// [morris]: trajectories after Morris 1991, Technometrics 33: 161. Each factor has `levels` equidistant levels p in
/// its range, on its scale; a trajectory starts at a random one and changes each factor once, in random order, by
///   delta = p / (2 (p - 1))   of its range, up or down.
/// Two named choices, or two flags, are the two levels of a factor that is no number. Level, direction and order are
/// drawn from the seed, the trajectory and the name of the parameter: more trajectories leave the others as they are.
/// Numbers are rounded to six digits, integers to the nearest; the size of a step is that of the rounded values. A set
/// that two trajectories meet is one set.
/// @param seed  of the study
Designed morris_sets(const toml::table& ranges, const Parameters& base, std::uint64_t seed, Allowance& allowance,
                     FaultList& faults);

inline constexpr std::string_view base_label = "base";

std::string name(Design design); ///< "one_at_a_time", "morris"

/// [[steps]]: a design as study.resolved.toml holds it, beside its sets among the [[points]].
/// @param sets    whose labels the steps name
std::vector<Step> read_steps(const toml::array& steps, const std::vector<FactorSet>& sets, FaultList& faults);

} // namespace matrigrate::study
