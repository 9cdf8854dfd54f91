#include "base/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>
#include <tbb/version.h>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>

// Of ThreadSanitizer; null where the program is built without it.
extern "C" {
[[gnu::weak]] void __tsan_acquire(void* address); // NOLINT: its name
[[gnu::weak]] void __tsan_release(void* address); // NOLINT: its name
}

namespace matrigrate {

namespace {

void acquire(const char& token) {
  if (__tsan_acquire != nullptr) __tsan_acquire(const_cast<char*>(&token));
}

void release(const char& token) {
  if (__tsan_release != nullptr) __tsan_release(const_cast<char*>(&token));
}

/// ThreadSanitizer annotations for a oneTBB loop, without effect in other builds: code before the loop happens-before
/// every range, and every range happens-before code after the loop. Ranges stay unordered among each other.
class LoopOrder {
public:
  LoopOrder() { release(m_before); }
  LoopOrder(const LoopOrder&) = delete;
  LoopOrder& operator=(const LoopOrder&) = delete;
  ~LoopOrder() { acquire(m_after); }
  void enter() const { acquire(m_before); } ///< before a range
  void leave() const { release(m_after); }  ///< after it

private:
  char m_before = 0, m_after = 0; // their addresses identify the two synchronisations
};

std::atomic<unsigned> loops_begun{0}; // by the threads of this process: no result depends on it

/// Lets threads wait for the next loop for a while before they sleep: to wake one takes longer than most loops.
class Awake : public tbb::task_scheduler_observer {
public:
  Awake() { observe(true); }
  Awake(const Awake&) = delete;
  Awake& operator=(const Awake&) = delete;
  ~Awake() override { observe(false); }

  void on_scheduler_exit(bool is_worker) override {
    if (!is_worker) return;
    constexpr auto longest = std::chrono::microseconds(500);
    const unsigned before = loops_begun.load(std::memory_order_relaxed);
    const auto end = std::chrono::steady_clock::now() + longest;
    while (loops_begun.load(std::memory_order_relaxed) == before && std::chrono::steady_clock::now() < end) {
    }
  }
};

} // namespace

int hardware_threads() { return tbb::info::default_concurrency(); }

int idle_threads() {
  double load = 0.0;
  if (getloadavg(&load, 1) != 1) return hardware_threads();
  const double idle = 1.0 - load / static_cast<double>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
  return std::max(1, static_cast<int>(std::lround(idle * hardware_threads())));
}

struct ThreadLimit::Limit {
  tbb::global_control control;
  Awake awake{};
};

ThreadLimit::ThreadLimit(int threads)
    : m_limit(new Limit{{tbb::global_control::max_allowed_parallelism,
                         static_cast<std::size_t>(threads > 0 ? threads : hardware_threads())}}) {}

ThreadLimit::~ThreadLimit() = default;

std::string threading_version() { return TBB_runtime_version(); }

bool alone() { return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) == 1; }

void parallel_ranges(std::size_t n, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  const LoopOrder order;
  loops_begun.fetch_add(1, std::memory_order_relaxed);
  const auto loop = [&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, n, grain),
        [&](const auto& range) {
          order.enter();
          body(range.begin(), range.end());
          order.leave();
        },
        tbb::static_partitioner());
  };
  tbb::this_task_arena::isolate(loop); // who waits for the rest of a loop begins no other work beside it
}

void side_by_side(std::initializer_list<std::function<void()>> works) {
  if (alone()) {
    for (const auto& work : works) work();
    return;
  }
  const LoopOrder order;
  loops_begun.fetch_add(1, std::memory_order_relaxed);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, works.size()),
      [&](const auto& range) {
        order.enter();
        for (std::size_t k = range.begin(); k < range.end(); ++k) works.begin()[k]();
        order.leave();
      },
      tbb::simple_partitioner());
}

} // namespace matrigrate
