#include "io/trajectory_hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstdint>
#include <new>
#include <vector>

namespace matrigrate::io {

namespace {

std::string digits(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

void update(XXH3_state_t* state, const void* data, std::size_t bytes) {
  XXH3_64bits_update(state, data, bytes); // fails only on null pointers
}

void update(XXH3_state_t* state, const std::vector<Vec2>& points) {
  static_assert(sizeof(Vec2) == 2 * sizeof(double));
  if (!points.empty()) update(state, points.data(), points.size() * sizeof(Vec2));
}

} // namespace

void TrajectoryHash::Free::operator()(XXH3_state_s* state) const { XXH3_freeState(state); }

TrajectoryHash::TrajectoryHash() : m_state(XXH3_createState()) {
  if (!m_state) throw std::bad_alloc();
  XXH3_64bits_reset(m_state.get());
}

void TrajectoryHash::add(const State& s) {
  update(m_state.get(), &s.step, sizeof(s.step));
  update(m_state.get(), s.cortex.x);
  update(m_state.get(), s.ecm.x);
}

std::string TrajectoryHash::text() const { return digits(XXH3_64bits_digest(m_state.get())); }

std::string text_hash(std::string_view text) { return digits(XXH3_64bits(text.data(), text.size())); }

} // namespace matrigrate::io
