#pragma once

#include <optional>
#include <string>
#include <vector>

/// Claims: sentences, each with the conditions on the read-outs of studies that it must meet. They stand as [[claims]]
/// in study files (read_study.hpp); claims/judge.hpp judges them. Test:
/// tests/unit/study_plan/read_claims_test.cpp
namespace matrigrate::study {

/// What a claim is for: closures were chosen on calibration rows and on no predicted row (docs/closures.md),
/// verification rows test parts of the model, and experiment rows go beyond the paper.
enum class ClaimKind { calibration, predicted, verification, experiment };

enum class Sign { up, down };

struct ClaimRule; // claim_rules.hpp

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

} // namespace matrigrate::study
