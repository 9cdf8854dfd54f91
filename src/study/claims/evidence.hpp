#pragma once

#include "claims/claims.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The results of the shipped studies behind claims. Test: tests/apps/reproduce_test.cpp
namespace matrigrate::study {

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

} // namespace matrigrate::study
