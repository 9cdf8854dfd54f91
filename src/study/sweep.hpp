#pragma once

#include "study/fault_list.hpp"
#include "study/settings.hpp"
#include "study/study.hpp"

#include <cstdint>
#include <utility>
#include <vector>

/// The points of a study: a grid of lists, points one by one, and a Latin hypercube.
/// Test: tests/unit/study/read_study_test.cpp, sweep_test.cpp
namespace matrigrate::study {

/// A point that is being made, and where its settings stand in the file.
struct Draft {
  Point point;
  Place place;
  std::vector<std::pair<std::string, Place>> settings;
};

inline constexpr std::size_t most_runs = 100'000;

/// How many points a study may still have: times the replicates, most_runs.
class Allowance {
public:
  explicit Allowance(std::size_t replicates) : m_replicates(replicates) {}

  /// To be asked before points are made. @param more  a product of lengths, which may be beyond any integer
  /// @return whether that many more are allowed; if not, a fault says how many there would be
  bool allows(double more, Place place, std::string_view key, FaultList& faults);

private:
  std::size_t m_replicates;
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

/// Places in [0, 1), one in each of n equal strips, in random order.
std::vector<double> stratified(std::size_t n, std::uint64_t seed);

/// "youngs_modulus 50 Pa, force 0.6 nN"; "all" without settings.
std::string label_of(const std::vector<Setting>& settings);

} // namespace matrigrate::study
