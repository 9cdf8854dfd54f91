#pragma once

#include "claims/evidence.hpp"

#include <string>
#include <string_view>

namespace matrigrate::apps {

/// What `matrigrate reproduce` was asked for.
struct ReproduceOptions : study::EvidenceOptions {
  std::string id;
  int jobs = 0;
  bool json = false;
  bool markdown = false;
  bool quiet = false;
  std::string command; ///< as it was typed

  /// Whether a row of the claims, by its id, was asked for.
  bool chooses(std::string_view row) const { return id == "all" || row.starts_with(id); }
};

/// A signal ended the work.
struct Stopped {
  int signal;
};

} // namespace matrigrate::apps
