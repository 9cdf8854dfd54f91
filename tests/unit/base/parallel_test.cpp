#include "base/parallel.hpp"

#include "base/threads.hpp"
#include "base/vector.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <vector>

namespace matrigrate {
namespace {

/// Terms whose sum depends on the order of the additions.
double rough(std::size_t i) {
  const double sign = i % 3 == 0 ? -1.0 : 1.0;
  return sign * std::pow(10.0, static_cast<double>((i * 7919) % 17)) / static_cast<double>(i + 1);
}

template <class F>
auto with_threads(int threads, const F& f) {
  const ThreadLimit limit(threads);
  tbb::task_arena arena(threads);
  return arena.execute(f);
}

TEST(Parallel, TheTermsOfTheseTestsTellOrdersApart) {
  double up = 0.0;
  double down = 0.0;
  for (std::size_t i = 0; i < 10'000; ++i) up += rough(i);
  for (std::size_t i = 10'000; i-- > 0;) down += rough(i);
  EXPECT_NE(up, down);
}

TEST(Parallel, OrderedSumHasTheSameBitsForAnyNumberOfThreads) {
  for (const std::size_t n : {std::size_t{100'003}, std::size_t{512}, std::size_t{513}, std::size_t{7}}) {
    const double reference = with_threads(1, [&] { return ordered_sum(n, 0.0, rough); });
    for (const int threads : {2, 4, 7})
      for (int repeat = 0; repeat < 20; ++repeat) {
        const double sum = with_threads(threads, [&] { return ordered_sum(n, 0.0, rough); });
        ASSERT_EQ(std::bit_cast<std::uint64_t>(sum), std::bit_cast<std::uint64_t>(reference)) << n << ' ' << threads;
      }
  }
}

TEST(Parallel, OrderedSumOfVectorsAddsEveryTermOnce) {
  const Vec2 sum = ordered_sum(2'001, Vec2(0.0, 0.0), [](std::size_t i) { return Vec2(static_cast<double>(i), 1.0); });
  EXPECT_EQ(sum, Vec2(2'001'000.0, 2'001.0));
}

TEST(Parallel, TheEmptySumIsZeroAndDoesNotCallTheTerm) {
  EXPECT_EQ(ordered_sum(0, 3.0, [](std::size_t) -> double { throw std::runtime_error("called"); }), 3.0);
}

TEST(Parallel, LoopVisitsEveryIndexOnce) {
  for (const int threads : {1, 2, 4, 7}) {
    std::vector<std::atomic<int>> visits(5'000);
    with_threads(threads, [&] {
      parallel_for(visits.size(), [&](std::size_t i) { ++visits[i]; });
      return 0;
    });
    for (const auto& n : visits) ASSERT_EQ(n.load(), 1);
  }
}

TEST(Parallel, LoopUsesSeveralThreads) {
  // Each body waits until a second thread has come, so that the test fails (after its deadline) if none does.
  std::atomic<std::thread::id> first{};
  std::atomic<bool> second{false};
  with_threads(2, [&] {
    parallel_for(64 * parallel_block, [&](std::size_t i) {
      if (i % parallel_block != 0 || second) return;
      std::thread::id nobody{};
      if (first.compare_exchange_strong(nobody, std::this_thread::get_id())) {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (!second && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
      } else if (first.load() != std::this_thread::get_id()) {
        second = true;
      }
    });
    return 0;
  });
  EXPECT_TRUE(second);
}

TEST(Parallel, AFailureInALoopReachesTheCaller) {
  const auto body = [](std::size_t i) {
    if (i == 3'000) throw std::runtime_error("3000");
  };
  EXPECT_THROW(parallel_for(5'000, body), std::runtime_error);
}

} // namespace
} // namespace matrigrate
