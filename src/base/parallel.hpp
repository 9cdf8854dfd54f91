#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace matrigrate {

// Loops that give the same bits for any number of threads: a loop body writes only to its own index, and a sum is
// taken over blocks whose bounds do not depend on the threads, then over the blocks in order. Test:
// tests/unit/base/base_test.cpp

inline constexpr std::size_t parallel_block = 512;
inline constexpr std::size_t light_grain = 2048; ///< of loops with few operations an index

/// Whether the program runs single-threaded.
bool alone();

/// Calls body(begin, end) for ranges that make up [0, n), in any order, each as a task.
/// @param grain  approximate minimum length of a range
void parallel_ranges(std::size_t n, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);

/// Calls all, in any order, side by side. None may write what another reads or writes.
/// Test: tests/unit/base/base_test.cpp
void side_by_side(std::initializer_list<std::function<void()>> works);

/// Works that are done one after the other beside what their owner goes on with; at once where the program runs
/// single-threaded. Test: tests/unit/base/base_test.cpp
class Behind {
public:
  /// @param most  works that wait for their turn
  explicit Behind(std::size_t most = 4);
  Behind(Behind&&) noexcept;
  Behind& operator=(Behind&&) = delete;
  ~Behind(); ///< once all are done

  /// @param work  what it reads stays as it is until it is done
  /// @throws what an earlier work has thrown: once, and those that waited behind it are not done
  void add(std::function<void()> work);

  /// @throws as add
  void check();

  /// Until all are done.   @throws as add
  void wait();

  /// wait() that leaves what has been thrown to the next call.
  void settle() const noexcept;

private:
  struct Works;
  std::unique_ptr<Works> m_works;
};

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

/// Calls body(k) for every k in [0, n), in any order, each as a separate task.
template <class Body>
void parallel_parts(std::size_t n, const Body& body) {
  parallel_for(n, body, 1);
}

/// Whether test(begin, end) holds for any of the ranges that make up [0, n).
/// @param grain  approximate minimum length of a range
template <class Test>
bool parallel_any(std::size_t n, const Test& test, std::size_t grain = light_grain) {
  std::atomic<bool> any = false;
  parallel_ranges(n, grain, [&](std::size_t begin, std::size_t end) {
    if (!any && test(begin, end)) any = true;
  });
  return any;
}

/// Calls body(begin, end) for each block of [0, n) for which test(begin, end) holds: the tests in any order, then the
/// bodies one after the other, in order.
template <class Test, class Body>
void each_block_with(std::size_t n, const Test& test, const Body& body) {
  const auto end_of = [n](std::size_t b) { return std::min(n, (b + 1) * parallel_block); };
  std::vector<std::uint8_t> holds((n + parallel_block - 1) / parallel_block);
  parallel_for(
      holds.size(), [&](std::size_t b) { holds[b] = test(b * parallel_block, end_of(b)) ? 1 : 0; }, 8);
  for (std::size_t b = 0; b < holds.size(); ++b)
    if (holds[b] != 0) body(b * parallel_block, end_of(b));
}

/// Makes `to` a copy.
template <class T>
void parallel_copy(std::span<const T> from, std::vector<T>& to) {
  to.resize(from.size());
  parallel_ranges(from.size(), light_grain, [&](std::size_t begin, std::size_t end) {
    std::copy(from.begin() + static_cast<std::ptrdiff_t>(begin), from.begin() + static_cast<std::ptrdiff_t>(end),
              to.begin() + static_cast<std::ptrdiff_t>(begin));
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

/// Calls body(begin, end) for every stretch of indices whose flag is 0, in order: loops without a branch inside.
/// Test: tests/unit/base/base_test.cpp
template <class Body>
void each_unflagged_stretch(std::span<const std::uint8_t> flags, const Body& body) {
  for (auto begin = std::ranges::find(flags, 0), end = begin; begin != flags.end();
       begin = std::find(end, flags.end(), 0)) {
    end = std::find_if(begin, flags.end(), [](std::uint8_t flag) { return flag != 0; });
    body(static_cast<std::size_t>(begin - flags.begin()), static_cast<std::size_t>(end - flags.begin()));
  }
}

// The number of threads that the loops of base/parallel.hpp use. Test: tests/unit/base/base_test.cpp

/// The number of threads that this process may use.
int hardware_threads();

/// As many of them as there are cores without work, by the load of the last minute; at least 1.
int idle_threads();

/// Limits parallel loops to a number of threads while it lives. Of several limits the lowest counts.
class ThreadLimit {
public:
  /// @param threads  at least 1; otherwise hardware_threads()
  explicit ThreadLimit(int threads);
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;
  ~ThreadLimit();

private:
  struct Limit;
  std::unique_ptr<Limit> m_limit;
};

/// Version of oneTBB, which shares the loops among threads.
std::string threading_version();

} // namespace matrigrate
