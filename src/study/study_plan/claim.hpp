#pragma once

#include "observe/readouts.hpp"
#include "statistics/compare.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Claims: sentences, each with the conditions on the read-outs of studies that it must meet. They stand as [[claims]]
/// in study files (read_study.hpp); claims/judge.cpp judges them. Test:
/// tests/unit/study_plan/read_claims_test.cpp
namespace matrigrate::study {

/// What a claim is for: closures were chosen on calibration rows and on no predicted row (docs/closures.md),
/// verification rows test parts of the model, and experiment rows go beyond the paper.
enum class ClaimKind { calibration, predicted, verification, experiment };

enum class Sign { up, down };

struct ClaimRule;

/// Of the rules of verdicts (docs/validation.md). A claim that an edition changed is judged by the one before as well.
enum class ClaimEdition { second = 2, third = 3 };

/// A point by its label.
struct PointName {
  std::string study; ///< empty: that of the claim
  std::string label;
};

/// In the names of the keys: `to` against `from`, each a point; or the runs `at` a point; or all runs of the study.
struct ClaimCondition {
  const ClaimRule* rule = nullptr;
  std::string study{}; ///< all of whose runs are meant; empty: that of the claim
  PointName from{};
  PointName to{}; ///< or `at`
  std::string readout{};
  std::string other{}; ///< the second read-out: `over`, `with`
  Sign sign = Sign::up;
  double value = 0.0; ///< or `bound`, `low`
  double high = 0.0;
  double runs = 0.0; ///< that a published value is the mean of
  double share = 0.0;
  std::optional<ClaimEdition> edition{}; ///< that alone asks for it; none: all
};

struct Claim {
  std::string id;      ///< "A1"
  std::string study{}; ///< whose file it stands in
  ClaimKind kind = ClaimKind::predicted;
  std::string sentence{};  ///< what is claimed
  std::string published{}; ///< the numbers that were published
  std::vector<ClaimCondition> conditions{};
  std::string text{}; ///< the [[claims]] table of a file, to be read again

  /// Names of the studies that it is judged by, its own first.
  std::vector<std::string> studies() const;
  /// Whether the second edition of the rules asks for other conditions than the third.
  bool has_editions() const;
  /// Whether the runs at a point of a study decide on it: a condition names the point, or all runs of the study.
  bool depends_on(const std::string& of_study, const std::string& label) const;
};

/// "calibration", "predicted", ...
std::string kind_name(ClaimKind kind);

// The rules of claims: how each stands in files, and when its condition is met.
// Test: tests/unit/claims/claims_test.cpp

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
