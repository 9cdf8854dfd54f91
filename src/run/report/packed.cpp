#include "report/packed.hpp"

#include "store/deflate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace matrigrate::report {

namespace {

/// q of each number, as the bits that are stored.
std::vector<std::uint16_t> quantised(const Packing& packing, const observe::Floats& values) {
  const double low = packing.wide ? -32768.0 : 0.0;
  const double high = packing.wide ? 32767.0 : 255.0;
  std::vector<std::uint16_t> q(values.size(), 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = (values[i] - packing.offset) / packing.scale;
    if (std::isfinite(value))
      q[i] = static_cast<std::uint16_t>(static_cast<std::int32_t>(std::clamp(std::nearbyint(value), low, high)));
  }
  return q;
}

void put_bytes(std::string& to, const std::vector<std::uint16_t>& d, unsigned shift) {
  for (const std::uint16_t value : d) to += static_cast<char>(static_cast<std::uint8_t>(value >> shift));
}

} // namespace

nlohmann::ordered_json packed(const Packing& packing, std::size_t frames, const FrameValues& values) {
  std::string bytes;
  std::vector<std::uint16_t> before;
  for (std::size_t k = 0; k < frames; ++k) {
    const std::vector<std::uint16_t> q = quantised(packing, values(k));
    if (k == 0) bytes.reserve(frames * q.size() * (packing.wide ? 2 : 1));
    std::vector<std::uint16_t> d = q;
    if (packing.delta && k > 0)
      for (std::size_t i = 0; i < d.size(); ++i) d[i] = static_cast<std::uint16_t>(q[i] - before[i]);
    put_bytes(bytes, d, 0);
    if (packing.wide) put_bytes(bytes, d, 8);
    before = q;
  }
  return {{"type", packing.wide ? "int16" : "uint8"},
          {"components", packing.components},
          {"per_frame", before.size() / static_cast<std::size_t>(packing.components)},
          {"scale", packing.scale},
          {"offset", packing.offset},
          {"delta", packing.delta},
          {"data", store::base64(store::deflated(bytes, 6))}};
}

} // namespace matrigrate::report
