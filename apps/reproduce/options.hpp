#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace matrigrate::apps {

/// What `matrigrate reproduce` was asked for.
struct ReproduceOptions {
  std::string id;
  std::string folder = "reproduce";
  std::string from; ///< folder of kept tables to judge by; empty: run what is missing
  std::string kept; ///< folder of kept tables whose runs are not made again; empty: none
  std::optional<std::size_t> replicates;
  std::string integrator = "adaptive";
  std::vector<std::string> overrides;
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
