#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

/// Loops that give the same bits for any number of threads: a loop body writes only to its own index, and a sum is
/// taken over blocks whose bounds do not depend on the threads, then over the blocks in order. Test:
/// tests/unit/base/parallel_test.cpp
namespace matrigrate {

inline constexpr std::size_t parallel_block = 512;

/// ThreadSanitizer annotations for oneTBB loops, without effect in other builds: code before the loop happens-before
/// every body, and every body happens-before code after the loop. Bodies stay unordered among each other.
class LoopOrder {
public:
  LoopOrder();
  LoopOrder(const LoopOrder&) = delete;
  LoopOrder& operator=(const LoopOrder&) = delete;
  ~LoopOrder();
  void enter() const; ///< before a group of bodies
  void leave() const; ///< after it

private:
  char m_before = 0, m_after = 0; // their addresses identify the two synchronisations
};

/// Whether the program runs single-threaded.
inline bool alone() { return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) == 1; }

/// Calls body(k) for every k in [0, n), in any order, each as a separate task.
template <class Body>
void parallel_parts(std::size_t n, const Body& body) {
  if (alone()) {
    for (std::size_t k = 0; k < n; ++k) body(k);
    return;
  }
  const LoopOrder order;
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t k) {
    order.enter();
    body(k);
    order.leave();
  });
}

/// Calls body(i) for every i in [0, n), in any order.
/// @param grain  approximate minimum number of indices per task
template <class Body>
void parallel_for(std::size_t n, const Body& body, std::size_t grain = parallel_block) {
  if (alone()) {
    for (std::size_t i = 0; i < n; ++i) body(i);
    return;
  }
  const LoopOrder order;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain), [&](const auto& range) {
    order.enter();
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
    order.leave();
  });
}

/// Sum of term(i) over i in [0, n), to the same bits for any number of threads.
/// @param zero  the empty sum; also fixes the type of the result
template <class T, class Term>
T ordered_sum(std::size_t n, const T& zero, const Term& term) {
  const std::size_t blocks = (n + parallel_block - 1) / parallel_block;
  std::vector<T> partial(blocks, zero);
  parallel_parts(blocks, [&](std::size_t b) {
    T sum = zero;
    const std::size_t end = std::min(n, (b + 1) * parallel_block);
    for (std::size_t i = b * parallel_block; i < end; ++i) sum += term(i);
    partial[b] = sum;
  });
  T sum = zero;
  for (const T& s : partial) sum += s;
  return sum;
}

} // namespace matrigrate
