#pragma once

/// Stands in for oneTBB where there is one thread: plain loops.
namespace tbb {

template <class Index, class Body>
void parallel_for(Index begin, Index end, const Body& body) {
  for (Index k = begin; k < end; ++k) body(k);
}

template <class Range, class Body>
void parallel_for(const Range& range, const Body& body) {
  body(range);
}

} // namespace tbb
