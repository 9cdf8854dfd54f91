#pragma once

#include "study_plan/fault_list.hpp"
#include "study_plan/settings.hpp"
#include "study_plan/study.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The factor sets of a study, a grid of lists, points one by one, and a Latin hypercube, and its conditions.
/// Test: tests/unit/study_plan/read_study_test.cpp, plan_test.cpp, targets_test.cpp
namespace matrigrate::study {

/// Where parameters stand in a file.
using Places = std::vector<std::pair<std::string, Place>>;

/// A point, or a factor set, that is being made, and where its settings stand in the file. Without a label it is called
/// by its settings (name_sets).
struct Draft {
  Point point;
  Place place;
  Places settings;
};

inline constexpr std::size_t max_runs = 100'000;

/// How many factor sets a study may still have: times the conditions and the replicates, max_runs.
class Allowance {
public:
  /// @param conditions  0 if the study has none
  Allowance(std::size_t replicates, std::size_t conditions) : m_replicates(replicates), m_conditions(conditions) {}

  /// To be asked before points are made. @param more  a product of lengths, which may be beyond any integer
  /// @return whether that many more are allowed; if not, a fault says how many there would be
  bool allows(double more, Place place, std::string_view key, FaultList& faults);

private:
  std::size_t m_replicates;
  std::size_t m_conditions;
  double m_points = 0.0;
};

/// [sweep]: each value of each list with each of the others; the last list changes fastest.
std::vector<Draft> grid_points(const toml::table& sweep, const Parameters& base, Allowance& allowance,
                               FaultList& faults);

/// [[points]]: each a table of parameters, with an optional `label`.
std::vector<Draft> listed_points(const toml::array& points, const Parameters& base, Allowance& allowance,
                                 FaultList& faults);

/// [latin_hypercube]: `samples` points; each range, ["low", "high"] or ["low", "high", "log"], is cut into as many
/// strips, and each strip is met once (McKay, Beckman and Conover 1979, Technometrics 21: 239). Which strips meet, and
/// where in them, is drawn from the seed and the name of the parameter, so that it never changes. Values are rounded to
/// six digits.
std::vector<Draft> hypercube_points(const toml::table& hypercube, const Parameters& base, std::uint64_t seed,
                                    Allowance& allowance, FaultList& faults);

/// Calls the sets that have no label by their settings. Fields from files of one name in two folders are called by
/// their whole paths.
/// @param conditions  under which the sets will be run: their parameters have to be told apart, too
void name_sets(std::vector<Draft>& sets, const std::vector<Condition>& conditions);

/// Places in [0, 1), one in each of n equal strips, in random order.
std::vector<double> stratified(std::size_t n, std::uint64_t seed);

/// A condition, and where it stands in the file.
struct ConditionDraft {
  Condition condition;
  Place place;
  std::vector<Named> parameters;
  std::string meaning; ///< meaning_of() the settings
};

/// [[conditions]]: each a `label` and parameters.
std::vector<ConditionDraft> read_conditions(const toml::array& list, const Parameters& base, FaultList& faults);

/// Each factor set under each condition, labelled "condition: set"; the sets as they are without conditions.
std::vector<Draft> crossed(std::vector<Draft> sets, const std::vector<ConditionDraft>& conditions);

/// Faults for parameters that a design varies and a condition sets.
/// @param study  the whole file
void check_overlaps(const toml::table& study, const std::vector<ConditionDraft>& conditions, const Parameters& base,
                    FaultList& faults);

} // namespace matrigrate::study
