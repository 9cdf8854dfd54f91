#pragma once

#include "study_plan/read_study.hpp"
#include "study_plan/study.hpp"
#include "study_results/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace matrigrate::study {

/// A study of the text, with a preset and replicates in front if it names none.
inline Study read(const std::string& text) {
  return parse_study("preset = \"baseline\"\nreplicates = 3\n" + text, "f.toml", ".");
}

/// The faults of a text, as they are printed; none if it is good.
inline std::vector<std::string> faults_of(const std::string& text) {
  std::vector<std::string> printed;
  try {
    parse_study(text, "f.toml", ".");
  } catch (const ConfigurationError& error) {
    for (const Fault& fault : error.faults()) printed.push_back(to_string(fault));
  }
  return printed;
}

/// The only fault of a text behind two good lines; otherwise all of them.
inline std::string fault_of(const std::string& text) {
  const auto faults = faults_of("preset = \"baseline\"\nreplicates = 3\n" + text);
  return faults.size() == 1 ? faults.front() : fmt::format("{} faults\n{}", faults.size(), fmt::join(faults, "\n"));
}

/// Results in which one read-out has these values at the points, the others none.
inline std::vector<Result> results_of(std::string_view readout, const std::vector<std::vector<double>>& samples) {
  const std::vector<std::string> names = all_readouts();
  const auto column = static_cast<std::size_t>(std::ranges::find(names, readout) - names.begin());
  std::vector<Result> all;
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t k = 0; k < samples[i].size(); ++k) {
      Result r{{i, k + 1, 0, fmt::format("{}-{}", i, k)}, {}, std::vector<double>(names.size())};
      std::ranges::fill(r.readouts, std::numeric_limits<double>::quiet_NaN());
      r.standing.status = RunState::done;
      r.readouts[column] = samples[i][k];
      all.push_back(std::move(r));
    }
  return all;
}

} // namespace matrigrate::study
