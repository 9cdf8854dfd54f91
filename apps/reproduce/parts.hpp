#pragma once

#include "apps/reproduce/options.hpp"
#include "claims/claims.hpp"

#include <span>
#include <string_view>
#include <vector>

/// Rows of the table that are judged on parts of the model and not on ensembles: V1 to V3 by verification cases, F1 by
/// the fields of two runs. Test: tests/apps/reproduce_test.cpp
namespace matrigrate::apps {

struct PartRow {
  std::string_view id, sentence, published;
  std::string_view verification; ///< the case that its verdict comes from; empty for F1
};

std::span<const PartRow> part_rows();

/// The finding on a verification case: run here, its files beside the studies; or, with
/// options.from, as validate-<case>.json in that folder has it. Undecided if the case stopped or its own checks fail.
/// @throws Stopped after a signal
/// @throws InputOutputError if a kept file cannot be read
study::JudgedClaim judged_by_case(const PartRow& row, const ReproduceOptions& options);

/// F1: whether two runs, at 100 and 400 Pa, show the fields of displacement and von Mises stress over all their time,
/// each 5 min. By fields.csv, which is written first from the frames of the first replicates of the study of stiffness;
/// with options.from by that folder's fields.csv.
/// @param evidence  that holds the study of stiffness
/// @throws InputOutputError if frames or a kept file cannot be read
study::JudgedClaim judged_by_fields(const PartRow& row, const study::Evidence& evidence,
                                    const ReproduceOptions& options);

} // namespace matrigrate::apps
