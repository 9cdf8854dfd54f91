#include "base/random.hpp"

#include <Random123/philox.h>

#include <cmath>

namespace matrigrate {

double uniform(std::uint64_t seed, Purpose purpose, std::uint64_t step, std::uint32_t entity, std::uint32_t cell) {
  const auto low = [](std::uint64_t a) { return static_cast<std::uint32_t>(a); };
  const auto high = [](std::uint64_t a) { return static_cast<std::uint32_t>(a >> 32U); };
  const std::uint32_t stream = static_cast<std::uint32_t>(purpose) | (cell << 8U);
  const r123::Philox4x32::ctr_type counter{{low(step), high(step), entity, stream}};
  const r123::Philox4x32::key_type key{{low(seed), high(seed)}};
  const auto bits = r123::Philox4x32()(counter, key);
  const std::uint64_t wide = (static_cast<std::uint64_t>(bits[0]) << 32U) | bits[1];
  return (static_cast<double>(wide >> 12U) + 0.5) * 0x1p-52;
}

double event_probability(double rate, double dt) { return -std::expm1(-rate * dt); }

} // namespace matrigrate
