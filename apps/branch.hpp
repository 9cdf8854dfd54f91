#pragma once

#include "apps/parameter_options.hpp"
#include "apps/simulate.hpp"

#include <filesystem>
#include <string>

/// Branches of a run: other parameters, another seed or another end from a moment on.
/// Test: tests/apps/resume_test.cpp
namespace matrigrate::apps {

struct BranchOptions : ParameterOptions {
  std::string at;        ///< time with its unit; empty: the last checkpoint
  bool previous = false; ///< without a time: at checkpoint_prev.h5

  bool any() const { return !at.empty() || !overrides.empty() || seed || hours; }
};

/// Begins a branch of the run in a folder, and simulates it.
/// @param manner  its folder is made here, and must not hold anything
/// @return the exit code
/// @throws ConfigurationError, InputOutputError before anything is written
int branch(const std::filesystem::path& from, const BranchOptions& options, const Manner& manner);

} // namespace matrigrate::apps
