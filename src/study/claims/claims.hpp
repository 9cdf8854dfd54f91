#pragma once

#include "report/verdict_page.hpp"
#include "study_plan/claim.hpp"
#include "study_plan/read_study.hpp"
#include "study_runs/study_folder.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The claims of Heck et al. 2020, and of experiments beside it, that ensembles of runs can bear out, one entry a row
/// of the table to reproduce. They stand in the files of studies/. The conditions of a claim follow from its sentence,
/// were written before the runs that they judge, and are not changed after them.
///
/// How sentences are read: "rises" and "falls" compare the lowest with the highest value of the parameter,
/// significantly; "unaffected" and "no significant change" mean no significant difference there; "slightly" asks for
/// the sign only; a published mean agrees if it could be the mean of as many more runs of ours (published_mean_test);
/// "a low f_adh_rel" is one below readouts.hpp's low_relative_force; "near 1" is within 0.25. Speeds along the
/// path are sampled every 60 s, since the paper names no interval.
///
/// Whether what a paper says comes out of studies: conditions on groups of runs, each with its statistic. The test is
/// the paper's, an unpaired two-sample t-test at 0.05.
/// - Where a claim says of several comparisons that they do not differ, or of several means that they agree with
///   published ones, p-values are corrected within the claim (Holm), since ten true nulls at 0.05 each fail two times
///   in five. A mean within a tenth of the published one agrees whatever the scatter.
/// - A claim whose stated directions and orders all come out, though a value or a significance is missed, is "in
///   direction".
/// - A test that finds nothing says nothing where it could not have: where a 95 % interval reaches further to either
///   side than half of what the condition is about (the larger of two means, the published mean, r = 1), a condition
///   that p >= 0.05 would meet is not told, and the claim undecided unless another condition fails.
/// Test: tests/unit/claims/claims_test.cpp
namespace matrigrate::study {

/// A study and the results of its runs.
struct Ensemble {
  Study study;
  std::vector<Result> results;
  MsdCurves msd{}; ///< of the results, in their order; empty where a run has none, or none is known
};

/// By the name of the study.
using Evidence = std::map<std::string, Ensemble, std::less<>>;

using report::Verdict;

/// The verdict on a claim.
struct Finding {
  Verdict verdict = Verdict::undecided;
  std::vector<std::string> ours;       ///< means with their 95 % intervals
  std::vector<std::string> conditions; ///< each with its statistic, and whether it is met: "A is above B (...): met"
  std::string brief{};                 ///< ours in a line, for a table
  std::vector<std::string> unmet{};    ///< why it does not hold: the conditions that are not met
  std::vector<std::string> against{};  ///< conditions whose direction comes out opposite by its whole interval
};

/// What becomes of a claim by the evidence, under an edition of the rules.
Finding judged(const Claim& claim, const Evidence& evidence, ClaimEdition edition = ClaimEdition::third);

/// The claims of all shipped studies, by their ids: rows A to E of the paper, and rows X, experiments beside it, which
/// are not among the paper's twenty-six.
std::vector<Claim> shipped_claims();

/// A claim with what became of it.
struct JudgedClaim {
  std::string id;
  ClaimKind kind = ClaimKind::predicted;
  std::string sentence;
  std::string published;
  Finding finding;
  std::optional<Finding> in_larger_disc{}; ///< with runs that ended at the rim made again in a larger disc
  std::optional<Finding> second_edition{}; ///< by the second edition of the rules, where the third changed them
  std::string caveat{};                    ///< "not the paper's runs" where the runs of its studies are not; else ""
  std::vector<std::string> studies{};      ///< names of those that it is judged by, as far as there are any
};

JudgedClaim judged_claim(const Claim& claim, const Evidence& evidence);

/// The claims of this study and, of a shipped one, those of other shipped studies that need it, judged by its results
/// and by those of the other studies they need, as far as these lie beside its folder.
std::vector<JudgedClaim> claims_about(const StudyFolder& study, const std::vector<Result>& results);

/// How this study differs from the shipped one, and what follows for the verdicts; "" if it does not differ.
std::string claims_note(const Study& study);

/// Why a claim does not hold, in a line; empty if it does.
std::string why_not(const Finding& finding);

/// "15 of 26 hold: 10 of 19 calibration, 5 of 7 predicted; 5 more in direction"
std::string bottom_line(const std::vector<JudgedClaim>& claims);

/// claims.csv: the table that people read, a line per claim.
std::string claims_csv(const std::vector<JudgedClaim>& claims);

/// For programs, of each claim {id, sentence, published, ours, statistic, verdict, caveat, kind, brief, why_not,
/// verdict_in_larger_disc, against}, and of a claim whose rules the third edition changed {verdict_second_edition,
/// why_not_second_edition, against_second_edition, statistic_second_edition}. The tables have the same, with these
/// columns where a claim of theirs has them.
nlohmann::ordered_json claims_json(const std::vector<JudgedClaim>& claims);

/// Every mean and condition of each claim.
std::string conditions_csv(const std::vector<JudgedClaim>& claims);

// The results of the shipped studies behind claims. Test: tests/apps/reproduce_test.cpp

/// Which rows are asked for, where results are, and how the studies are to be run.
struct EvidenceOptions {
  std::string id = "all";           ///< of a row, "A2", or its beginning, "A"
  std::string folder = "reproduce"; ///< of the studies, each in its own
  std::string from;                 ///< folder of kept tables to judge by; empty: run what is missing
  std::string kept;                 ///< folder of kept tables whose runs are not made again; empty: none
  std::optional<std::size_t> replicates;
  std::string integrator = "adaptive";
  std::vector<std::string> overrides;
};

/// The evidence, and a second one in which each run that ended at the rim, of a point that decides on a claim, is
/// replaced by the run of the same point and seed in a disc of study::larger_disc times the radius. The second evidence
/// has only studies with such runs.
struct ClaimEvidence {
  Evidence evidence;
  Evidence larger;
};

/// Computes runs of a study, by their place in StudyFolder::runs, writes its tables, and gives the results of all its
/// runs; those of `kept` stand for runs that have not ended in its folder.
using Compute = std::function<std::vector<Result>(const StudyFolder& study, const std::vector<std::size_t>& runs,
                                                  const std::vector<Result>& kept)>;

/// A shipped study with the settings of the options. With `from`, a file NAME.toml beside the kept tables stands in its
/// place.
/// @throws ConfigurationError if an override is wrong
Study shipped(std::string_view name, const EvidenceOptions& options);

/// Mean square displacements of runs, in the order of the results; of several cells their mean. Empty of runs without a
/// path. Test: tests/unit/claims/claims_test.cpp
/// @param tables  files such as paths.csv: a run that stands in several counts as in the first; those that are not
///                there are left out
/// @throws InputOutputError if a table cannot be read
MsdCurves run_msd(const Study& study, const std::vector<Result>& results,
                  const std::vector<std::filesystem::path>& tables);

/// Names of the studies that claims need, each once.
std::vector<std::string> studies_of(const std::vector<Claim>& claims);

/// @throws InputOutputError if a folder of a study that claims need, or of its runs in a larger disc, is not its own;
///         nothing is written
/// @throws ConfigurationError if an override is wrong
void require_own_study_folders(const std::vector<Claim>& claims, const EvidenceOptions& options);

/// Lets compute what is missing of the studies that claims need, each in its own folder, but for runs whose results are
/// kept in options.kept; with options.from reads <study>-results.csv and <study>-larger-disc-results.csv of that folder
/// in place of it, where they are there.
/// @throws InputOutputError if a table cannot be read or is of other runs; what `compute` throws
ClaimEvidence gather_evidence(const std::vector<Claim>& claims, const EvidenceOptions& options, const Compute& compute);

/// Verdicts on claims, each with that in a larger disc where runs ended at the rim.
std::vector<JudgedClaim> judged_claims(const std::vector<Claim>& claims, const ClaimEvidence& all);

/// "60 of 60 runs done", "57 of 60 runs done; 2 ended at the rim, 1 by crossing itself"
std::string ends_text(const Ensemble& ensemble);

/// A study of the folder studies/, which the program carries with it (cmake/shipped.cmake).
struct ShippedStudy {
  std::string_view name; ///< of the file, without its ending
  std::string_view text;
};

std::span<const ShippedStudy> shipped_studies();

/// The same, read.
struct ReadStudy {
  std::string name; ///< of the file, without its ending
  Study study;
};
const std::vector<ReadStudy>& read_shipped_studies();

/// The labels of the study NAME.toml in a folder, or of the shipped one of that name.
/// @throws ConfigurationError if that file has faults, InputOutputError if it cannot be read
LabelsOf other_studies(const std::filesystem::path& folder);

/// @throws std::out_of_range if there is none of that name
const ShippedStudy& shipped_file(std::string_view name);

} // namespace matrigrate::study
