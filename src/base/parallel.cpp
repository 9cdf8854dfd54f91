#include "base/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/version.h>

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

} // namespace

int hardware_threads() { return tbb::info::default_concurrency(); }

struct ThreadLimit::Limit {
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads)
    : m_limit(new Limit{{tbb::global_control::max_allowed_parallelism,
                         static_cast<std::size_t>(threads > 0 ? threads : hardware_threads())}}) {}

ThreadLimit::~ThreadLimit() = default;

std::string threading_version() { return TBB_runtime_version(); }

bool alone() { return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) == 1; }

void parallel_ranges(std::size_t n, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  const LoopOrder order;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain), [&](const auto& range) {
    order.enter();
    body(range.begin(), range.end());
    order.leave();
  });
}

} // namespace matrigrate
