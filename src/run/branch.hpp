#pragma once

#include "run/simulate.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Branches of a run: other parameters, another seed or another end from a moment on.
/// Test: tests/apps/resume_test.cpp
namespace matrigrate::run {

struct BranchOptions {
  std::vector<std::string> overrides; ///< "key=value"
  std::optional<double> at;           ///< simulated time; none: the last checkpoint [s]
  bool previous = false;              ///< without a time: at checkpoint_prev.h5
};

/// Begins a branch of the run in a folder, and computes it.
/// @param options  its folder is made here, and must not hold anything
/// @throws ConfigurationError, InputOutputError before anything is written
RunOutcome branch(const std::filesystem::path& from, const BranchOptions& how, const RunOptions& options,
                  RunObserver& observer);

} // namespace matrigrate::run
