#pragma once

#include "observe/frame.hpp"
#include "simulation/start.hpp"
#include "simulation/workspace.hpp"

/// A small gel with a cell and two protrusions, and a film of it.
namespace matrigrate {

struct SmallRun {
  SmallRun() {
    p.ecm.radius = 40.0;
    s = initial_state(p);
    s.t = 300.0;
    s.cells[0].polarization = 0.5;
    s.cells[0].protrusions = {
        {.centre = 10, .since = 290.0, .phase = Growing{{1.0, 0.0}}, .record = {.id = 1, .centre = 10}},
        {.centre = 60, .since = 10.0, .phase = Contracting{{30.5, -1.25}, 0.75}, .record = {.id = 2, .centre = 60}}};
    for (std::size_t i = 0; i < s.ecm.size(); ++i) {
      s.ecm.x[i] += 0.01 * s.ecm.X[i];
      s.ecm.v[i] = 1e-3 * s.ecm.X[i];
      s.ecm.rho[i] = 1.01;
      s.ecm.S[i] << 0.02, 0.01, 0.01, -0.02;
    }
    s.ecm.f[3] = 0.0;
    s.ecm.f[4] = 0.5;
  }

  observe::Film film() const {
    const Workspace w(s, p);
    observe::Film film{.head = observe::frame_head(s, p), .frames = {observe::frame(s, p, w)}};
    State later = s;
    later.t = 600.0;
    later.cells[0].protrusions.pop_back();
    for (Vec2& x : later.cells[0].cortex.x) x.x() += 1.0;
    film.frames.push_back(observe::frame(later, p, w));
    return film;
  }

  Parameters p;
  State s;
};

/// The same with a second cell, of id 4 and with a single protrusion.
struct TwoCells : SmallRun {
  TwoCells() {
    Cell second = s.cells[0];
    second.id = 4;
    for (Vec2& x : second.cortex.x) x += Vec2(3.0, 1.0);
    second.protrusions.pop_back();
    s.cells.push_back(second);
  }
};

/// The first field in which two films differ; "" if they are the same.
inline std::string difference(const observe::Film& a, const observe::Film& b) {
  if (a.head.reference != b.head.reference || a.head.radius != b.head.radius || a.head.spacing != b.head.spacing)
    return "head";
  if (a.frames.size() != b.frames.size()) return "number of frames";
  for (std::size_t k = 0; k < a.frames.size(); ++k) {
    if (a.frames[k].t != b.frames[k].t) return "t";
    for (const auto& field : observe::float_fields()) {
      const observe::Floats& x = field.in(a.frames[k]);
      const observe::Floats& y = field.in(b.frames[k]);
      if (x.size() != y.size()) return std::string(field.name);
      for (std::size_t i = 0; i < x.size(); ++i)
        if (x[i] != y[i] && !(x[i] != x[i] && y[i] != y[i])) return std::string(field.name);
    }
    for (const auto& field : observe::byte_fields())
      if (field.in(a.frames[k]) != field.in(b.frames[k])) return std::string(field.name);
  }
  return "";
}

} // namespace matrigrate
