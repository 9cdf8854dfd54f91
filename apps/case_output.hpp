#pragma once

#include "report/verdict_page.hpp"
#include "validation/case.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace matrigrate::apps {

/// How a case ended: with a result, or with the reason why there is none.
struct Outcome {
  const validation::Case* which = nullptr;
  std::optional<validation::Result> result;
  std::string failure;    ///< empty if there is a result
  double wall_time = 0.0; ///< [s]

  bool holds() const { return result && result->holds(); }
};

/// Measured beside expected, tolerance and its reason, verdict; for a terminal.
std::string to_text(const Outcome& outcome);

/// {name, summary, holds, failure, wall_time_s, checks: [{quantity, measured, expected, tolerance, sense, reason,
/// holds}], claims: [as checks], claim_notes, remarks}
nlohmann::ordered_json to_json(const Outcome& outcome);

/// The chapter of the report.
report::Statement to_statement(const Outcome& outcome);

/// Writes NAME.csv, and NAME-<picture>.svg for each picture; nothing without a result.
void write_outcome(const Outcome& outcome, const std::filesystem::path& folder);

} // namespace matrigrate::apps
