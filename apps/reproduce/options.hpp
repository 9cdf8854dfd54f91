#pragma once

#include "claims/evidence.hpp"

#include <string>

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

} // namespace matrigrate::apps
