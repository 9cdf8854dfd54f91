#include "base/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#include <tbb/task_scheduler_observer.h>
#include <tbb/version.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <utility>

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

std::atomic<int> offers{0}; // of the threads of this process; no result depends on it

/// Work that other threads may take, while it lives.
class Offer {
public:
  Offer() { offers.fetch_add(1, std::memory_order_relaxed); }
  Offer(const Offer&) = delete;
  Offer& operator=(const Offer&) = delete;
  ~Offer() { offers.fetch_sub(1, std::memory_order_relaxed); }
};

/// Lets threads wait for the next offer for a while before they sleep: to wake one takes longer than most loops.
class Awake : public tbb::task_scheduler_observer {
public:
  Awake() { observe(true); }
  Awake(const Awake&) = delete;
  Awake& operator=(const Awake&) = delete;
  ~Awake() override { observe(false); }

  void on_scheduler_exit(bool is_worker) override {
    if (!is_worker) return;
    using Clock = std::chrono::steady_clock;
    constexpr auto longest = std::chrono::microseconds(500);
    constexpr auto until_there = std::chrono::microseconds(3); // from an offer to its ranges
    const auto end = Clock::now() + longest;
    int least = offers.load(std::memory_order_relaxed);
    while (Clock::now() < end) {
      const int open = offers.load(std::memory_order_relaxed);
      if (open > least) {
        for (const auto there = Clock::now() + until_there; Clock::now() < there;) {
        }
        if (offers.load(std::memory_order_relaxed) > least) return;
      }
      least = std::min(least, open);
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
  if (n <= grain || alone()) { // one range: nobody else is needed
    if (n > 0) body(0, n);
    return;
  }
  const LoopOrder order;
  const Offer offer;
  const auto loop = [&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, n, grain),
        [&](const auto& range) {
          order.enter();
          body(range.begin(), range.end());
          order.leave();
        },
        tbb::auto_partitioner());
  };
  tbb::this_task_arena::isolate(loop); // who waits for the rest of a loop begins no other work beside it
}

void side_by_side(std::initializer_list<std::function<void()>> works) {
  if (alone()) {
    for (const auto& work : works) work();
    return;
  }
  const LoopOrder order;
  const Offer offer;
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, works.size()),
      [&](const auto& range) {
        order.enter();
        for (std::size_t k = range.begin(); k < range.end(); ++k) works.begin()[k]();
        order.leave();
      },
      tbb::simple_partitioner());
}

struct Behind::Works {
  explicit Works(std::size_t most_) : most(most_) {}

  void take(std::function<void()> work) {
    const std::scoped_lock lock(mutex);
    rethrow(); // in the same lock: what comes after a failure may count on what has failed
    waiting.push_back(std::move(work));
    if (std::exchange(busy, true)) return;
    offer.emplace();
    release(taken);
    group.run([this] {
      acquire(taken);
      offer.reset();
      do_all();
    });
  }

  void do_all() {
    while (const std::function<void()> work = next()) try {
        work();
      } catch (...) {
        const std::scoped_lock lock(mutex);
        failure = std::current_exception();
        waiting.clear();
      }
  }

  std::function<void()> next() {
    const std::scoped_lock lock(mutex);
    busy = !waiting.empty();
    if (!busy) return {};
    std::function<void()> work = std::move(waiting.front());
    waiting.pop_front();
    return work;
  }

  bool is_full() {
    const std::scoped_lock lock(mutex);
    return waiting.size() >= most;
  }

  /// The caller holds the lock.
  void rethrow() {
    if (const std::exception_ptr thrown = std::exchange(failure, nullptr)) std::rethrow_exception(thrown);
  }

  const std::size_t most;
  std::mutex mutex;
  std::deque<std::function<void()>> waiting;
  bool busy = false;
  std::optional<Offer> offer; // until a thread has taken the first
  char taken = 0;             // its address identifies this synchronisation
  std::exception_ptr failure;
  tbb::task_group group;
};

Behind::Behind(std::size_t most) : m_works(std::make_unique<Works>(most)) {}

Behind::Behind(Behind&&) noexcept = default;

Behind::~Behind() {
  if (m_works) settle();
}

void Behind::add(std::function<void()> work) {
  if (alone() || m_works->is_full()) wait();
  if (alone()) return work();
  m_works->take(std::move(work));
}

void Behind::check() {
  const std::scoped_lock lock(m_works->mutex);
  m_works->rethrow();
}

void Behind::wait() {
  settle();
  check();
}

void Behind::settle() const noexcept { m_works->group.wait(); }

} // namespace matrigrate
