#pragma once

#include <cstddef>
#include <memory>
#include <string>

/// The number of threads that the loops of base/parallel.hpp use. Test: tests/unit/base/base_test.cpp
namespace matrigrate {

/// The number of threads that this process may use.
int hardware_threads();

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
