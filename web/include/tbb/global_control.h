#pragma once

#include <cstddef>

/// Stands in for oneTBB where there is one thread: says so.
namespace tbb {

class global_control {
public:
  enum parameter { max_allowed_parallelism };
  static constexpr std::size_t active_value(parameter /*which*/) { return 1; }
};

} // namespace tbb
