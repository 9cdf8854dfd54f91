#pragma once

#include "apps/reproduce/options.hpp"
#include "apps/study/files.hpp"
#include "claims/parts.hpp"

#include <utility>
#include <vector>

/// The runs of `matrigrate reproduce`, with what the terminal shows of them. Test: tests/apps/reproduce_test.cpp
namespace matrigrate::apps {

/// Computes runs of the studies behind claims.
class ReproducedRuns {
public:
  explicit ReproducedRuns(const ReproduceOptions& options) : m_options(options) {}

  /// As study::Compute asks for.
  /// @throws Stopped after a signal
  /// @throws InputOutputError if a run cannot write its files
  std::vector<study::Result> compute(const StudyFolder& study, const std::vector<std::size_t>& runs,
                                     const std::vector<study::Result>& kept);

  /// The pages of the studies; their claims may need several studies, so they come last.
  void write_reports();

private:
  void compute_missing(const StudyFolder& study, const std::vector<std::size_t>& runs);

  const ReproduceOptions& m_options;
  std::vector<std::pair<StudyFolder, Collected>> m_studies;
};

/// The verdict on a row by its case: run here, its files beside the studies, or kept.
/// @throws Stopped after a signal
/// @throws InputOutputError if a kept file cannot be read
study::JudgedClaim judged_by_case(const study::PartRow& row, const ReproduceOptions& options);

} // namespace matrigrate::apps
