#pragma once

#include "report/verdict_page.hpp"
#include "validation/case.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// results.json.
std::string results_json(const std::filesystem::path& folder, const std::vector<Outcome>& outcomes);

/// Runs cases, and writes what they come to into a folder: NAME.csv and pictures of each as it ends, then report.html
/// and results.json.
/// @param name   what was asked for, for the title of the report
/// @param shown  is told of each as it ends
std::vector<Outcome> run_cases(const std::vector<const validation::Case*>& cases, std::string_view name,
                               const Parameters& p, const std::filesystem::path& folder,
                               const std::function<void(const Outcome&)>& shown);

} // namespace matrigrate::apps
