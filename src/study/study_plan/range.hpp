#pragma once

#include "parameters/assign.hpp"
#include "study_plan/fault_list.hpp"
#include "study_plan/settings.hpp"

#include <cstddef>
#include <optional>

/// Ranges of parameters in a study file: ["low", "high"] or ["low", "high", "log"].
/// Test: tests/unit/study_plan/plan_test.cpp
namespace matrigrate::study {

/// A range that is sampled, in the unit of the row.
struct Span {
  const Row* row;
  Place place;
  double low = 0.0;
  double high = 0.0;
  bool log = false;

  /// The value at a share of the way from low to high, on the scale of the range.
  double at(double share) const;
  /// Where a value lies: the inverse of at().
  double share(double value) const;
};

/// The value of a number's row, in the row's unit; none for flags and choices.
std::optional<double> number_in_unit(const Row& row, Parameters p);

/// The range that stands behind a parameter; none, and faults, if it is none.
std::optional<Span> span_of(const Named& named, const Parameters& base, FaultList& faults);

constexpr int usual_digits = 6, most_digits = 17;

/// A number rounded to some digits, or to an integer, as if typed.
Given given_number(const Row& row, double value, int digits = usual_digits);

/// The digits that keep a rounded value in its stratum of n of a range, at least the usual ones; none if the range is
/// too narrow for n values.
/// @param share  of the way from low to high, in [0, 1)
std::optional<int> digits_for_stratum(const Span& span, double share, std::size_t n);

} // namespace matrigrate::study
