#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

/// Loops that give the same bits for any number of threads: a loop body writes only to its own index, and a sum is
/// taken over blocks whose bounds do not depend on the threads, then over the blocks in order. Test:
/// tests/unit/base/base_test.cpp
namespace matrigrate {

inline constexpr std::size_t parallel_block = 512;

/// Whether the program runs single-threaded.
bool alone();

/// Calls body(begin, end) for ranges that make up [0, n), in any order, each as a task.
/// @param grain  approximate minimum length of a range
void parallel_ranges(std::size_t n, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);

/// Calls body(k) for every k in [0, n), in any order, each as a separate task.
template <class Body>
void parallel_parts(std::size_t n, const Body& body) {
  if (alone()) {
    for (std::size_t k = 0; k < n; ++k) body(k);
    return;
  }
  parallel_ranges(n, 1, [&body](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) body(k);
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
  parallel_ranges(n, grain, [&body](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
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
