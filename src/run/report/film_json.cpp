#include "report/film_json.hpp"

#include "base/parallel.hpp"
#include "ecm/loop/fibres.hpp"
#include "sph/kernel.hpp"
#include "state/initial.hpp"
#include "store/deflate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace matrigrate::report {

namespace {

using Json = nlohmann::ordered_json;

constexpr double byte_range = 255.0;

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

/// The numbers of a field of each frame.
FrameValues values_of(const observe::Film& film, const observe::Floats observe::MatrixFrame::*field) {
  return [&film, field](std::size_t k) -> const observe::Floats& { return film.frames[k].matrix.*field; };
}
FrameValues values_of(const observe::Film& film, const observe::Floats observe::OutlineFrame::*field) {
  return [&film, field](std::size_t k) -> const observe::Floats& { return film.frames[k].outline.*field; };
}

Json layer(const observe::Film& film, const observe::Floats observe::MatrixFrame::*field) {
  const Limits limits = usual_limits(film, field);
  return packed({.scale = (limits.high - limits.low) / byte_range, .offset = limits.low}, film.frames.size(),
                values_of(film, field));
}

/// Positions to 0.005 um, or coarser where 16 bits would not reach the rim.
Packing positions(const observe::FrameHead& head) {
  constexpr double reach = 32767.0;
  return {.wide = true, .components = 2, .scale = std::max(0.005, 1.05 * (head.radius + head.spacing) / reach)};
}

/// Values of solid and fluid between their own limits.
Json everywhere(std::size_t frames, const FrameValues& values) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t k = 0; k < frames; ++k)
    for (const double value : values(k)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  return packed({.scale = (high > low ? high - low : 1.0) / byte_range, .offset = low}, frames, values);
}

Json particles_json(const observe::Film& film) {
  using observe::MatrixFrame;
  const std::size_t n = film.frames.size();
  observe::Floats x;
  const auto positions_of = [&](std::size_t k) -> const observe::Floats& {
    x = film.frames[k].matrix.displacement;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += film.head.reference[i];
    return x;
  };
  Json of_x, of_f, of_pressure, of_stress; // beside each other, since to compress takes long
  side_by_side({[&] { of_x = packed(positions(film.head), n, positions_of); },
                [&] { of_f = packed({.scale = 1.0 / byte_range}, n, values_of(film, &MatrixFrame::f_degr)); },
                [&] { of_pressure = layer(film, &MatrixFrame::pressure); },
                [&] { of_stress = layer(film, &MatrixFrame::von_mises); }});
  Json json{{"x", std::move(of_x)},
            {"f", std::move(of_f)},
            {"pressure", std::move(of_pressure)},
            {"von_mises", std::move(of_stress)}};
  if (!film.frames.front().matrix.fibre_von_mises.empty())
    json["fibre_von_mises"] = layer(film, &MatrixFrame::fibre_von_mises);
  if (!film.frames.front().matrix.attractant.empty())
    json["attractant"] = everywhere(n, values_of(film, &MatrixFrame::attractant));
  for (std::size_t k = 0; k < film.head.layers.size(); ++k) {
    const observe::Floats& values = film.head.layers[k];
    if (values.empty()) continue;
    const MatrixField& layer = observe::matrix_layers()[k];
    json["layers"].push_back(
        {{"name", layer.layer},
         {"unit", layer.layer_unit == "1" ? "" : layer.layer_unit},
         {"title", layer.title},
         {"meaning", layer.meaning},
         {"values", everywhere(n, [&](std::size_t) -> const observe::Floats& { return values; })}});
  }
  return json;
}

Json outline_json(const observe::Film& film) {
  const std::size_t n = film.frames.size();
  double strongest = 0.0;
  for (const observe::Frame& frame : film.frames)
    for (const float force : frame.outline.force) strongest = std::max(strongest, static_cast<double>(force));
  observe::Floats row;
  const auto bytes = [&](const observe::Bytes observe::OutlineFrame::*field) {
    return packed({}, n, [&film, &row, field](std::size_t k) -> const observe::Floats& {
      const observe::Bytes& values = film.frames[k].outline.*field;
      row.assign(values.begin(), values.end());
      return row;
    });
  };
  const auto floats = [&](const Packing& packing, const observe::Floats observe::OutlineFrame::*field) {
    return packed(packing, n, values_of(film, field));
  };
  Json json{
      {"x", floats(positions(film.head), &observe::OutlineFrame::x)},
      {"front", bytes(&observe::OutlineFrame::front)},
      {"protrusion", bytes(&observe::OutlineFrame::protrusion)},
      {"f_mat", floats({.scale = 1.0 / byte_range}, &observe::OutlineFrame::f_mat)},
      {"force", floats({.scale = (strongest > 0.0 ? strongest : 1.0) / byte_range}, &observe::OutlineFrame::force)}};
  if (!film.frames.front().nucleus.empty())
    json["nucleus"] = packed(positions(film.head), n,
                             [&film](std::size_t k) -> const observe::Floats& { return film.frames[k].nucleus; });
  if (const observe::Floats& cell = film.frames.front().outline.cell; !cell.empty())
    json["cell"] = std::vector<std::uint32_t>(cell.begin(), cell.end());
  return json;
}

/// Keeps the first values in the order of a queue, at most that many; the last of them is at its top.
template <class Queue>
void keep(float value, std::size_t most, Queue& queue) {
  if (queue.size() == most && !typename Queue::value_compare()(value, queue.top())) return;
  queue.push(value);
  if (queue.size() > most) queue.pop();
}

/// Index on the outline of particle 0 of a cell.
std::size_t first_of(const observe::OutlineFrame& outline, float cell) {
  return static_cast<std::size_t>(std::ranges::find(outline.cell, cell) - outline.cell.begin());
}

Json protrusions_json(const observe::Frame& frame) {
  const observe::ProtrusionFrame& p = frame.protrusions;
  Json list = Json::array();
  for (std::size_t i = 0; i < p.id.size(); ++i) {
    const std::size_t first = p.cell.empty() ? 0 : first_of(frame.outline, p.cell[i]);
    list.push_back({{"id", static_cast<std::uint32_t>(p.id[i])},
                    {"phase", p.phase[i]},
                    {"centre", first + static_cast<std::size_t>(p.centre[i])},
                    {"anchor", std::isnan(p.anchor[2 * i]) ? Json() : Json{p.anchor[2 * i], p.anchor[2 * i + 1]}},
                    {"f_mat", p.f_mat[i]},
                    {"force_nN", p.force[i]}});
    if (!p.cell.empty()) list.back()["cell"] = static_cast<std::uint32_t>(p.cell[i]);
  }
  return list;
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

Limits usual_limits(const observe::Film& film, const observe::Floats observe::MatrixFrame::*field) {
  const auto each = [&](const auto& visit) {
    for (const observe::Frame& frame : film.frames) {
      const observe::Floats& all = frame.matrix.*field;
      for (std::size_t i = 0; i < all.size(); ++i)
        if (frame.matrix.f_degr[i] > 0.0F && std::isfinite(all[i])) visit(all[i]);
    }
  };
  std::size_t values = 0;
  each([&values](float) { ++values; });
  if (values == 0) return {};
  const std::size_t most = values / 2000 + 1; // those outside on either side, and the limit itself
  std::priority_queue<float> lowest;
  std::priority_queue<float, std::vector<float>, std::greater<>> highest;
  each([&](float value) {
    keep(value, most, lowest);
    keep(value, most, highest);
  });
  const Limits limits{.low = std::min(0.0, static_cast<double>(lowest.top())),
                      .high = static_cast<double>(highest.top())};
  return limits.high > limits.low ? limits : Limits{limits.low, limits.low + 1.0};
}

Json film_json(const observe::Film& film) {
  if (film.frames.empty()) return {};
  Json times = Json::array();
  Json protrusions = Json::array();
  for (const observe::Frame& frame : film.frames) {
    times.push_back(frame.t);
    protrusions.push_back(protrusions_json(frame));
  }
  Packing reference = positions(film.head);
  reference.delta = false;
  return {
      {"times_s", std::move(times)},
      {"reference", packed(reference, 1, [&](std::size_t) -> const observe::Floats& { return film.head.reference; })},
      {"particles", particles_json(film)},
      {"outline", outline_json(film)},
      {"protrusions", std::move(protrusions)}};
}

Json obstacles_json(const observe::FrameHead& head) {
  if (std::ranges::count(head.obstacle, std::uint8_t{1}) == 0) return {};
  Json places = Json::array();
  for (std::size_t i = 0; i < head.particles(); ++i)
    if (head.obstacle[i] != 0) places.push_back({head.reference[2 * i], head.reference[2 * i + 1]});
  return places;
}

Json fibres_json(const Parameters& p) {
  if (p.fibres.arrangement == FibreArrangement::none || !p.fibres.field.direction_deg.empty()) return {};
  const Kernel kernel(p.ecm.smoothing_length);
  Json bonds = Json::array();
  for (const Vec2& X : lattice_patch(p.ecm, 2.0 * p.ecm.smoothing_length)) {
    const bool once = X.y() > 0.0 || (X.y() == 0.0 && X.x() > 0.0); // the opposite bond is that of the other end
    if (once && kernel.W(X.norm()) > 0.0 && joined(X, p.fibres)) bonds.push_back({X.x(), X.y()});
  }
  return {{"bonds_um", std::move(bonds)}, {"onset", p.fibres.onset}};
}

} // namespace matrigrate::report
