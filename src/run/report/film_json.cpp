#include "report/film_json.hpp"

#include "base/parallel.hpp"
#include "ecm/loop/fibres.hpp"
#include "report/packed.hpp"
#include "sph/kernel.hpp"
#include "state/initial.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace matrigrate::report {

namespace {

using Json = nlohmann::ordered_json;

constexpr double byte_range = 255.0;

Json layer(const observe::Film& film, const observe::Floats& (*field)(const observe::Frame&)) {
  const Limits limits = usual_limits(film, field);
  return packed({.scale = (limits.high - limits.low) / byte_range, .offset = limits.low}, film.frames.size(),
                [&](std::size_t k) -> const observe::Floats& { return field(film.frames[k]); });
}

/// Positions to 0.005 um, or coarser where 16 bits would not reach the rim.
Packing positions(const observe::FrameHead& head) {
  constexpr double reach = 32767.0;
  return {.wide = true, .components = 2, .scale = std::max(0.005, 1.05 * (head.radius + head.spacing) / reach)};
}

/// Values of solid and fluid between their own limits.
/// @param field  of a frame; may be that of all frames
template <class Field>
Json everywhere(const observe::Film& film, const Field& field) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const observe::Frame& frame : film.frames)
    for (const double value : field(frame)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  return packed({.scale = (high > low ? high - low : 1.0) / byte_range, .offset = low}, film.frames.size(),
                [&](std::size_t k) -> const observe::Floats& { return field(film.frames[k]); });
}

Json particles_json(const observe::Film& film) {
  observe::Floats x;
  const auto positions_of = [&](std::size_t k) -> const observe::Floats& {
    x = film.frames[k].matrix.displacement;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += film.head.reference[i];
    return x;
  };
  const auto f_of = [&](std::size_t k) -> const observe::Floats& { return film.frames[k].matrix.f_degr; };
  Json of_x, of_f, of_pressure, of_stress; // beside each other, since to compress takes long
  side_by_side({[&] { of_x = packed(positions(film.head), film.frames.size(), positions_of); },
                [&] { of_f = packed({.scale = 1.0 / byte_range}, film.frames.size(), f_of); },
                [&] {
                  of_pressure =
                      layer(film, [](const observe::Frame& f) -> const observe::Floats& { return f.matrix.pressure; });
                },
                [&] {
                  of_stress =
                      layer(film, [](const observe::Frame& f) -> const observe::Floats& { return f.matrix.von_mises; });
                }});
  Json json{{"x", std::move(of_x)},
            {"f", std::move(of_f)},
            {"pressure", std::move(of_pressure)},
            {"von_mises", std::move(of_stress)}};
  if (!film.frames.front().matrix.fibre_von_mises.empty())
    json["fibre_von_mises"] =
        layer(film, [](const observe::Frame& f) -> const observe::Floats& { return f.matrix.fibre_von_mises; });
  if (!film.frames.front().matrix.attractant.empty())
    json["attractant"] =
        everywhere(film, [](const observe::Frame& f) -> const observe::Floats& { return f.matrix.attractant; });
  const auto of_head = [&](const observe::Floats& field) {
    return everywhere(film, [&](const observe::Frame&) -> const observe::Floats& { return field; });
  };
  for (std::size_t k = 0; k < film.head.layers.size(); ++k) {
    if (film.head.layers[k].empty()) continue;
    const MatrixField& layer = observe::matrix_layers()[k];
    json["layers"].push_back({{"name", layer.layer},
                              {"unit", layer.layer_unit == "1" ? "" : layer.layer_unit},
                              {"title", layer.title},
                              {"meaning", layer.meaning},
                              {"values", of_head(film.head.layers[k])}});
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
    return packed(packing, n,
                  [&film, field](std::size_t k) -> const observe::Floats& { return film.frames[k].outline.*field; });
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

Limits usual_limits(const observe::Film& film, const observe::Floats& (*field)(const observe::Frame&)) {
  const auto each = [&](const auto& visit) {
    for (const observe::Frame& frame : film.frames) {
      const observe::Floats& all = field(frame);
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
