#pragma once

#include "apps/study/files.hpp"
#include "claims/evidence.hpp"

#include <string>
#include <utility>
#include <vector>

namespace matrigrate::apps {

/// What `matrigrate reproduce` was asked for.
struct ReproduceOptions : study::EvidenceOptions {
  int jobs = 0;
  bool json = false;
  bool quiet = false;
  std::string command; ///< as it was typed
};

/// A signal ended the work.
struct Stopped {
  int signal;
};

// The runs of `matrigrate reproduce`, with what the terminal shows of them. Test: tests/apps/reproduce_test.cpp

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

} // namespace matrigrate::apps
