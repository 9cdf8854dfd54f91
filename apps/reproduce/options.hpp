#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace matrigrate::apps {

/// What `matrigrate reproduce` was asked for.
struct ReproduceOptions {
  std::string id;
  std::string folder = "reproduce";
  std::string from; ///< folder of kept tables to judge by; empty: run what is missing
  std::optional<std::size_t> replicates;
  std::string integrator = "adaptive";
  std::vector<std::string> overrides;
  int jobs = 0;
  bool json = false;
  bool markdown = false;
  bool quiet = false;
  std::string command; ///< as it was typed
};

/// A signal ended the work.
struct Stopped {
  int signal;
};

} // namespace matrigrate::apps
