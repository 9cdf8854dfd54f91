#include "base/parallel.hpp"

/// Stands in for src/base/parallel.cpp where there is one thread.
namespace matrigrate {

bool alone() { return true; }

void parallel_ranges(std::size_t n, std::size_t /*grain*/, const std::function<void(std::size_t, std::size_t)>& body) {
  if (n > 0) body(0, n);
}

} // namespace matrigrate
