#pragma once

#include "apps/reproduce/options.hpp"
#include "claims/claims.hpp"

#include <string>
#include <string_view>
#include <vector>

/// The results of the studies behind claims. Test: tests/apps/reproduce_test.cpp
namespace matrigrate::apps {

/// The evidence, and a second one in which each run that ended at the rim, of a point that decides on a claim, is
/// replaced by the run of the same point and seed in a disc of study::larger_disc times the radius. The second evidence
/// has only studies with such runs.
struct ClaimEvidence {
  study::Evidence evidence;
  study::Evidence larger;
};

/// A shipped study with the settings of the options. With --from, a file NAME.toml beside the kept tables stands in its
/// place.
/// @throws ConfigurationError if an override is wrong
study::Study shipped(std::string_view name, const ReproduceOptions& options);

/// @throws InputOutputError if a folder of a study that claims need, or of its runs in a larger disc, is not its own;
///         nothing is written
/// @throws ConfigurationError if an override is wrong
void require_own_study_folders(const std::vector<study::Claim>& claims, const ReproduceOptions& options);

/// Computes what is missing of the studies that claims need, each in its own folder, but for runs whose results are
/// kept in options.kept; with options.from reads <study>-results.csv and <study>-larger-disc-results.csv of that folder
/// in place of it, where they are there.
/// @throws Stopped after a signal
/// @throws InputOutputError if a run cannot write its files, or a table cannot be read or is of other runs
ClaimEvidence gather_evidence(const std::vector<study::Claim>& claims, const ReproduceOptions& options);

/// "60 of 60 runs done; 0 ended at the rim, 0 by crossing themselves, 0 otherwise"
std::string ends_text(const study::Ensemble& ensemble);

} // namespace matrigrate::apps
