#pragma once

#include "observe/displacement_statistics.hpp"
#include "statistics/compare.hpp"
#include "study_plan/claim.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The rules of claims: how each stands in files, and when its condition is met.
/// Test: tests/unit/claims/claims_test.cpp, tests/unit/study_plan/read_claims_test.cpp
namespace matrigrate::study {

inline constexpr double claim_alpha = 0.05; ///< level of tests and of intervals

/// Mean square displacements of runs, each by lag.
using MsdCurves = std::vector<std::vector<MsdPoint>>;

/// Their mean at the lags that all have.
std::vector<MsdPoint> mean_curve(const MsdCurves& runs);

/// Slope of log over log of the mean curve, as in Figs 11D and 12D, with its interval by a bootstrap over runs.
/// @param key  of the draws
statistics::Interval mean_curve_slope(const MsdCurves& runs, std::uint64_t key);

/// The values of the read-out that a condition is about.
struct ClaimRuns {
  std::vector<double> from{}, to{}; ///< of the runs at these points, those that are defined
  std::vector<double> excess{};     ///< over the other read-out, of the runs at `to` that define both
  std::vector<double> all{};        ///< of all runs of the study; NaN where not defined
  std::vector<double> other{};      ///< the other read-out of these
  MsdCurves from_msd{}, to_msd{};   ///< of the runs at these points that have one
};

/// Conditions of a claim whose p-values are corrected together.
enum class ClaimFamily { none, no_difference, agreement };

/// What a rule says of a condition. In its sentences $readout, $other, $from, $to and $study stand for their names.
struct ClaimReading {
  std::string wanted;              ///< "$readout at $to is above that at $from"
  std::string measured;            ///< "difference 1.2 [0.4, 2], p 0.01"
  bool defined = false;            ///< whether there are runs enough
  bool met = false;                ///< of a family its corrected p decides
  std::string all_runs{};          ///< a number over all runs of the study, as a sentence
  std::optional<bool> direction{}; ///< whether the stated direction comes out; none where the claim states none
  ClaimFamily family = ClaimFamily::none;
  double p = 1.0;       ///< of the condition's family
  bool close = false;   ///< agrees whatever its p-value
  bool against = false; ///< the 95 % interval lies wholly on the other side of the stated direction
  bool vague = false;   ///< the interval is too wide for a p above 0.05 to meet the condition
};

/// The runs that a rule is about: at `from` and `to`; at a point, `at`, which counts as `to`; at the point with the
/// lowest or the highest mean of all, which counts as `to`; all of the study; or the mean square displacements at
/// `from` and `to`.
enum class ClaimPoints { from_to, at, lowest, highest, all, curves };

struct ClaimRule {
  std::string name;              ///< as it stands in files
  std::vector<std::string> keys; ///< that a condition must have
  ClaimPoints points;
  ClaimReading (*judge)(const ClaimCondition& c, const ClaimRuns& runs);
};

const std::vector<ClaimRule>& claim_rules();

} // namespace matrigrate::study
