#include "base/parallel.hpp"

// Of ThreadSanitizer; null where the program is built without it.
extern "C" {
[[gnu::weak]] void __tsan_acquire(void* address); // NOLINT(bugprone-reserved-identifier)
[[gnu::weak]] void __tsan_release(void* address); // NOLINT(bugprone-reserved-identifier)
}

namespace matrigrate {

namespace {

void acquire(const char& token) {
  if (__tsan_acquire != nullptr) __tsan_acquire(const_cast<char*>(&token));
}

void release(const char& token) {
  if (__tsan_release != nullptr) __tsan_release(const_cast<char*>(&token));
}

} // namespace

LoopOrder::LoopOrder() { release(m_before); }
LoopOrder::~LoopOrder() { acquire(m_after); }
void LoopOrder::enter() const { acquire(m_before); }
void LoopOrder::leave() const { release(m_after); }

} // namespace matrigrate
