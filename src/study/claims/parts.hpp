#pragma once

#include "claims/evidence.hpp"
#include "validation/case.hpp"

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

/// Rows of the table that are judged on parts of the model and not on ensembles: V1 to V3 by verification cases, F1 by
/// the fields of two runs. Test: tests/unit/claims/parts_test.cpp, tests/apps/reproduce_test.cpp
namespace matrigrate::study {

struct PartRow {
  std::string_view id, sentence, published;
  std::string_view verification; ///< the case that its verdict comes from; empty for F1
};

std::span<const PartRow> part_rows();

/// The study whose runs F1 is judged by, and the labels of its points.
inline constexpr std::string_view field_study = "stiffness";
inline constexpr std::string_view field_points[] = {"youngs_modulus 100 Pa", "youngs_modulus 400 Pa"};

/// The verdict on a row by a case.
/// @param result  null if the case stopped: then it is undecided, as where its own checks fail
/// @param folder  of its report
JudgedClaim judged_by_case(const PartRow& row, const validation::Result* result, const std::filesystem::path& folder);

/// The same by a results.json that is kept; undecided if there is none.
/// @throws InputOutputError if it cannot be read
JudgedClaim judged_by_kept_case(const PartRow& row, const std::filesystem::path& file);

/// fields.csv of F1: the frames of the first replicates at field_points.
/// @param folder  of the runs of the study; those that are not there, as of kept results, are left out
/// @throws InputOutputError if frames cannot be read
std::string fields_csv(const Ensemble& study, const std::filesystem::path& folder);

/// F1: whether two runs, at 100 and 400 Pa, show the fields of displacement and von Mises stress over all their time,
/// each 5 min.
/// @param file  fields.csv; undecided if it is not there
/// @throws InputOutputError if it cannot be read
JudgedClaim judged_by_fields(const PartRow& row, const std::filesystem::path& file, const Evidence& evidence);

/// The rows that were asked for and are judged by fields; from runs it first writes fields.csv into their folder.
/// @throws InputOutputError if frames or the table cannot be read
std::vector<JudgedClaim> rows_by_fields(const Evidence& evidence, const EvidenceOptions& options);

} // namespace matrigrate::study
