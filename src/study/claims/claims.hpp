#pragma once

#include "claims/judge.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The claims of Heck et al. 2020 that ensembles of runs can test, one entry a row of the table to reproduce. The
/// rule of a claim follows from its sentence, was written before the runs that it judges, and is not changed after
/// them.
///
/// How sentences are read: "rises" and "falls" compare the lowest with the highest value of the parameter,
/// significantly; "unaffected" and "no significant change" mean no significant difference there; "slightly" asks for
/// the sign only; a published mean agrees if it could be the mean of as many more runs of ours (published_mean_test);
/// "a low f_adh_rel" is one below table_readouts.hpp's low_relative_force; "near 1" is within 0.25. Speeds along the
/// path are sampled every 60 s, since the paper names no interval.
/// Test: tests/unit/claims/claims_test.cpp
namespace matrigrate::study {

/// What a row of the table is for: closures were chosen on calibration rows, no predicted row was looked at before they
/// were frozen (MODEL.md, "The choice of the closures"), verification rows test parts of the model, and experiment rows
/// go beyond the paper.
enum class RowKind { calibration, predicted, verification, experiment };

/// The sets of closures (MODEL.md, "The choice of the closures").
enum class ClosureSet { first, second };

/// The kind of a row by its id: A1 to A7 and D are for calibration, and E with the second set, whose choice they
/// served; V and F are for verification, X are experiments.
RowKind row_kind(std::string_view id, ClosureSet set = ClosureSet::second);
std::string to_string(RowKind kind);

struct Claim {
  std::string_view id;                   ///< "A1"
  std::vector<std::string_view> studies; ///< files of studies/ that it needs
  std::string_view sentence;             ///< what the paper says
  std::string_view published;            ///< its numbers
  Finding (*judge)(const Evidence&);
};

/// Rows A to E, in their order.
std::span<const Claim> claims();

/// Rows X: what experiments beside the paper found, and whether the model with its frozen closures shows it. They are
/// not among the paper's thirty.
std::span<const Claim> experiment_claims();

/// Rows A to E and X.
std::vector<Claim> all_claims();

/// A claim, or a verification beside them, with what became of it.
struct JudgedClaim {
  std::string id;
  std::string sentence;
  std::string published;
  Finding finding;
  std::optional<Finding> in_larger_disc{}; ///< with runs that ended at the rim made again in a larger disc
  RowKind kind = row_kind(id);
  std::string caveat{}; ///< "not the paper's runs" where the runs of its studies are not; else ""
};

JudgedClaim judged(const Claim& claim, const Evidence& evidence);

/// Why a claim does not hold, in a line; empty if it does.
std::string why_not(const Finding& finding);

/// "19 of 30 hold: 7 of 11 calibration, 9 of 15 predicted, 3 of 4 verification; 2 undecided"
std::string bottom_line(const std::vector<JudgedClaim>& claims);

/// "16 of 30 hold and 9 more are in direction by the second edition of the rules"
std::string second_bottom_line(const std::vector<JudgedClaim>& claims);

/// The table of a page of Markdown: a row a claim, with what was published, what came out, and the verdict.
std::string markdown_table(const std::vector<JudgedClaim>& claims);

/// The parts of the table: rows on stiffness and force (A), rates and times (B), adhesion laws (C), kept numbers of
/// protrusions without and with fibres (D, E).
std::vector<Claim> migration_claims();
std::vector<Claim> rate_claims();
std::vector<Claim> adhesion_claims();
std::vector<Claim> kept_claims();

/// Names of the read-outs that claims speak of.
namespace readout {
inline constexpr std::string_view v_abs = "v_migr_abs_um_per_h";
inline constexpr std::string_view v_path = "v_migr_path_60s_um_per_h";
inline constexpr std::string_view v_path_600s = "v_migr_path_600s_um_per_h";
inline constexpr std::string_view index_x = "migration_index_x";
inline constexpr std::string_view parting = "parting_index";
inline constexpr std::string_view contact = "share_in_contact";
inline constexpr std::string_view n = "n_protrusions";
inline constexpr std::string_view tau = "tau_prot_min";
inline constexpr std::string_view length = "l_prot_um";
inline constexpr std::string_view f_mat = "f_mat";
inline constexpr std::string_view low_share = "share_f_adh_rel_low";
inline constexpr std::string_view slope = "msd_slope";
inline constexpr std::string_view angle = "path_angle_deg";
inline constexpr std::string_view f_mat_along = "f_mat_along";
inline constexpr std::string_view f_mat_across = "f_mat_across";
inline constexpr std::string_view ruptured_along = "share_ruptured_along";
inline constexpr std::string_view ruptured_across = "share_ruptured_across";
} // namespace readout

inline constexpr double random_angle_deg = 45.0; ///< mean angle of random directions to a line

} // namespace matrigrate::study
