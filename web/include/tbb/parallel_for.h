#pragma once

/// Stands in for oneTBB where there is one thread: a plain loop.
namespace tbb {

template <class Range, class Body>
void parallel_for(const Range& range, const Body& body) {
  body(range);
}

} // namespace tbb
