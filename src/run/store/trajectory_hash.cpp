#include "store/trajectory_hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <memory>
#include <new>
#include <vector>

namespace matrigrate::store {

namespace {

std::string digits(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

void update(XXH3_state_t* state, const void* data, std::size_t bytes) {
  XXH3_64bits_update(state, data, bytes); // fails only on null pointers
}

void update(XXH3_state_t* state, const std::vector<Vec2>& points) {
  static_assert(sizeof(Vec2) == 2 * sizeof(double));
  if (!points.empty()) update(state, points.data(), points.size() * sizeof(Vec2));
}

struct Free {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

} // namespace

void TrajectoryHash::add(const State& s) {
  const std::unique_ptr<XXH3_state_t, Free> state(XXH3_createState());
  if (!state) throw std::bad_alloc();
  XXH3_64bits_reset_withSeed(state.get(), m_hash);
  update(state.get(), &s.step, sizeof(s.step));
  for (const Cell& cell : s.cells) update(state.get(), cell.cortex.x);
  for (const Cell& cell : s.cells)
    if (cell.nucleus.size() > 0) update(state.get(), cell.nucleus.x);
  update(state.get(), s.ecm.x);
  m_hash = XXH3_64bits_digest(state.get());
}

std::string TrajectoryHash::text() const { return digits(m_hash); }

std::string text_hash(std::string_view text) { return digits(XXH3_64bits(text.data(), text.size())); }

} // namespace matrigrate::store
