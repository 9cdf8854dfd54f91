#include "observe/frame.hpp"

#include "base/parallel.hpp"
#include "cell/actomyosin.hpp"
#include "cell/geometry.hpp"
#include "ecm/law/material.hpp"
#include "ecm/loop/fluid.hpp"
#include "observe/tracks.hpp"
#include "protrusion/adhesion.hpp"
#include "protrusion/maturation.hpp"
#include "simulation/law_places.hpp"
#include "sph/neighbours.hpp"
#include "state/protrusion.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>

namespace matrigrate {

std::vector<double> fibre_stress_field(const EcmState& ecm, const FibreParameters& p, const FibreNetwork& network) {
  std::vector<double> field(ecm.size(), undefined);
  if (network.empty()) return field;
  parallel_for(ecm.size(), [&](std::size_t i) {
    if (ecm.f[i] > 0.0) field[i] = plane_von_mises(fibre_stress(ecm, p, network, i));
  });
  return field;
}

} // namespace matrigrate

namespace matrigrate::observe {

namespace {

constexpr double Pa = 1e3; // in a kPa

/// Rounded to multiples of 1/16384.
float fixed(double value) { return static_cast<float>(std::nearbyint(value * 16384.0) / 16384.0); }

/// Rounded to 13 binary digits: what is left out would be noise that no compression can shorten.
float short_float(double value) {
  if (!std::isfinite(value)) return static_cast<float>(value);
  constexpr std::uint32_t dropped = 11;
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  return std::bit_cast<float>((bits + (1U << (dropped - 1))) & ~((1U << dropped) - 1));
}

void add(Floats& to, const Vec2& x) {
  to.push_back(static_cast<float>(x.x()));
  to.push_back(static_cast<float>(x.y()));
}

/// Pressure of the fluid where it is now, 0 in the solid [kPa]: of the state alone, so that a run that goes on has it
/// too. Neighbours are looked for in the box around the fluid only.
std::vector<double> fluid_pressures(const EcmState& ecm, const EcmParameters& p) {
  const Kernel kernel(p.smoothing_length);
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.f[i] <= 0.0) box.extend(ecm.x[i]);
  std::vector<double> pressures(ecm.size(), 0.0);
  if (box.isEmpty()) return pressures;
  const Vec2 reach = Vec2::Constant(kernel.support());
  box = {box.min() - reach, box.max() + reach};
  EcmState part;
  part.V0 = ecm.V0;
  part.period_x = ecm.period_x;
  std::vector<std::size_t> of_part;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.period_x == 0.0 && !box.contains(ecm.x[i])) continue;
    part.x.push_back(ecm.x[i]);
    part.f.push_back(ecm.f[i]);
    if (!ecm.E_ratio.empty()) part.E_ratio.push_back(ecm.E_ratio[i]);
    of_part.push_back(i);
  }
  const double rho_lattice = lattice_density(p);
  const Adjacency pairs = neighbours_within(part.x, kernel.support(), part.period_x);
  constexpr std::size_t grain = 64;
  const auto set = [&](std::size_t k) {
    if (part.f[k] <= 0.0) pressures[of_part[k]] = fluid_pressure(part, p, pairs, kernel, rho_lattice, k);
  };
  parallel_for(of_part.size(), set, grain);
  return pressures;
}

MatrixFrame matrix_frame(const State& s, const Parameters& p, const Workspace& w) {
  const EcmState& ecm = s.ecm;
  const double K = moduli(p.ecm).K;
  const std::vector<double> fluid = fluid_pressures(ecm, p.ecm);
  const std::size_t n = ecm.size();
  MatrixFrame m{Floats(2 * n), Floats(2 * n), Floats(n), Floats(n), Floats(n), {}};
  parallel_for(n, [&](std::size_t i) {
    const Vec2 u = ecm.displacement(i);
    const bool solid = ecm.f[i] > 0.0;
    for (std::size_t d = 0; d < 2; ++d) {
      m.displacement[2 * i + d] = fixed(u[static_cast<long>(d)]);
      m.velocity[2 * i + d] = short_float(ecm.v[i][static_cast<long>(d)]);
    }
    m.f_degr[i] = static_cast<float>(ecm.f[i]);
    m.pressure[i] = short_float(Pa * (solid ? pressure(ecm.rho[i], K * ecm.stiffness(i)) : fluid[i]));
    m.von_mises[i] = solid ? short_float(Pa * von_mises(ecm.S[i])) : 0.0F;
  });
  for (const double c : ecm.attractant) m.attractant.push_back(short_float(c));
  if (!w.fibres.empty())
    for (const double stress : fibre_stress_field(ecm, p.fibres, w.fibres))
      m.fibre_von_mises.push_back(std::isnan(stress) ? 0.0F : short_float(Pa * stress));
  return m;
}

/// Magnitude of what the tensions of both segments of each particle add up to [nN].
Floats actomyosin_forces(const CortexState& c, const std::vector<double>& f_mat, std::span<const LawPlace> places,
                         const Laws& laws) {
  std::vector<Vec2> sum(c.size(), Vec2::Zero());
  std::vector<double> kappa;
  for (std::size_t i = 0; i < c.size(); ++i) kappa.push_back(curvature(c, i));
  for (std::size_t i = 0; i < c.size(); ++i) {
    const std::size_t j = c.next(i);
    const LawPlace place = place_at(places, i);
    const double tension = F_am(strand(c, i, f_mat, kappa, laws, place), laws, place);
    const Vec2 T = tension * (c.x[j] - c.x[i]).normalized();
    sum[i] += T;
    sum[j] -= T;
  }
  Floats magnitude;
  for (const Vec2& F : sum) magnitude.push_back(static_cast<float>(F.norm()));
  return magnitude;
}

template <class Number>
void append(std::vector<Number>& to, const std::vector<Number>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// @param before  protrusions of the cells before
void add_outline(OutlineFrame& o, const Cell& cell, std::size_t before, const Parameters& p, const Laws& laws,
                 std::span<const LawPlace> places) {
  const CortexState& c = cell.cortex;
  const Membership m = membership(cell, p);
  append(o.front, cell.polarization ? front(c, *cell.polarization) : Bytes(c.size(), 1));
  append(o.force, actomyosin_forces(c, m.f_mat, places, laws));
  for (std::size_t i = 0; i < c.size(); ++i) {
    add(o.x, c.x[i]);
    o.f_mat.push_back(static_cast<float>(m.f_mat[i]));
    o.curvature.push_back(static_cast<float>(curvature(c, i)));
    const std::size_t own = m.of_particle[i] == no_protrusion ? of_none : static_cast<std::size_t>(m.of_particle[i]);
    const bool none = own >= of_none || before + own >= of_none;
    o.protrusion.push_back(none ? of_none : static_cast<std::uint8_t>(before + own));
    o.phase.push_back(none ? of_none : static_cast<std::uint8_t>(cell.protrusions[own].phase.index()));
  }
}

void add_protrusions(ProtrusionFrame& out, const Cell& cell, const AdhesionParameters& p, const Laws& laws,
                     std::span<const LawPlace> places) {
  for (const Protrusion& protrusion : cell.protrusions) {
    const LawPlace place = place_at(places, protrusion.centre);
    const Vec2* adhered = anchor(protrusion.phase);
    out.id.push_back(static_cast<float>(protrusion.record.id));
    out.centre.push_back(static_cast<float>(protrusion.centre));
    out.phase.push_back(static_cast<std::uint8_t>(protrusion.phase.index()));
    add(out.anchor, adhered != nullptr ? *adhered : Vec2(undefined, undefined));
    out.f_mat.push_back(static_cast<float>(f_mat_of(protrusion.phase, laws, place)));
    out.force.push_back(static_cast<float>(adhesion_force(cell.cortex, protrusion, p, laws, place)));
  }
}

} // namespace

std::span<const FrameField<Floats>> float_fields() {
  static constexpr std::array<FrameField<Floats>, 19> all{{
      {"matrix/displacement", "um", 2, [](Frame& f) -> Floats& { return f.matrix.displacement; }},
      {"matrix/velocity", "um/s", 2, [](Frame& f) -> Floats& { return f.matrix.velocity; }},
      {"matrix/f_degr", "1", 1, [](Frame& f) -> Floats& { return f.matrix.f_degr; }},
      {"matrix/pressure", "Pa", 1, [](Frame& f) -> Floats& { return f.matrix.pressure; }},
      {"matrix/von_mises", "Pa", 1, [](Frame& f) -> Floats& { return f.matrix.von_mises; }},
      {"matrix/fibre_von_mises", "Pa", 1, [](Frame& f) -> Floats& { return f.matrix.fibre_von_mises; }},
      {"outline/position", "um", 2, [](Frame& f) -> Floats& { return f.outline.x; }},
      {"outline/f_mat", "1", 1, [](Frame& f) -> Floats& { return f.outline.f_mat; }},
      {"outline/curvature", "1/um", 1, [](Frame& f) -> Floats& { return f.outline.curvature; }},
      {"outline/actomyosin_force", "nN", 1, [](Frame& f) -> Floats& { return f.outline.force; }},
      {"protrusions/id", "1", 1, [](Frame& f) -> Floats& { return f.protrusions.id; }, true},
      {"protrusions/centre", "1", 1, [](Frame& f) -> Floats& { return f.protrusions.centre; }, true},
      {"protrusions/cell", "1", 1, [](Frame& f) -> Floats& { return f.protrusions.cell; }, true, false},
      {"protrusions/anchor", "um", 2, [](Frame& f) -> Floats& { return f.protrusions.anchor; }},
      {"protrusions/f_mat", "1", 1, [](Frame& f) -> Floats& { return f.protrusions.f_mat; }},
      {"protrusions/force", "nN", 1, [](Frame& f) -> Floats& { return f.protrusions.force; }},
      {"matrix/attractant", "1", 1, [](Frame& f) -> Floats& { return f.matrix.attractant; }, false, false},
      {"nucleus/position", "um", 2, [](Frame& f) -> Floats& { return f.nucleus; }, false, false},
      {"outline/cell", "1", 1, [](Frame& f) -> Floats& { return f.outline.cell; }, true, false},
  }};
  return all;
}

std::span<const FrameField<Bytes>> byte_fields() {
  static constexpr std::array<FrameField<Bytes>, 4> all{{
      {"outline/front", "1", 1, [](Frame& f) -> Bytes& { return f.outline.front; }},
      {"outline/protrusion", "1", 1, [](Frame& f) -> Bytes& { return f.outline.protrusion; }},
      {"outline/phase", "1", 1, [](Frame& f) -> Bytes& { return f.outline.phase; }},
      {"protrusions/phase", "1", 1, [](Frame& f) -> Bytes& { return f.protrusions.phase; }},
  }};
  return all;
}

std::vector<std::size_t> outline_ends(const OutlineFrame& outline) {
  const std::size_t n = outline.front.size();
  std::vector<std::size_t> ends;
  for (std::size_t i = 1; i < std::min(n, outline.cell.size()); ++i) // of one length, but in files from anyone
    if (outline.cell[i] != outline.cell[i - 1]) ends.push_back(i);
  if (n > 0) ends.push_back(n);
  return ends;
}

const std::vector<MatrixField>& matrix_layers() {
  static const std::vector<MatrixField> layers = [] {
    std::vector<MatrixField> found;
    std::ranges::copy_if(matrix_field_table, std::back_inserter(found),
                         [](const MatrixField& field) { return !field.layer.empty(); });
    return found;
  }();
  return layers;
}

bool FrameHead::consistent() const {
  const auto one_each = [this](const auto& field) { return field.empty() || field.size() == particles(); };
  return one_each(obstacle) && std::ranges::all_of(layers, one_each);
}

std::vector<double> times_of(const Film& film) {
  std::vector<double> times;
  for (const Frame& frame : film.frames) times.push_back(frame.t);
  return times;
}

FrameHead frame_head(const State& s, const Parameters& p) {
  FrameHead head{
      .radius = p.ecm.radius, .spacing = p.ecm.particle_spacing, .reference = {}, .obstacle = s.ecm.obstacle};
  for (const Vec2& X : s.ecm.X) add(head.reference, X);
  for (std::size_t k = 0; k < head.layers.size(); ++k) {
    const MatrixField& layer = matrix_layers()[k];
    for (const double value : s.ecm.*layer.member) head.layers[k].push_back(static_cast<float>(layer.shown(value, p)));
  }
  return head;
}

Frame frame(const State& s, const Parameters& p, const Workspace& w) {
  Frame frame{.t = s.t, .matrix = matrix_frame(s, p, w), .outline = {}, .protrusions = {}};
  for (const Cell& cell : s.cells) {
    const std::vector<LawPlace> places = places_of_forces(cell, s.ecm, p, s.t, w.laws.front());
    add_outline(frame.outline, cell, frame.protrusions.id.size(), p, w.laws.front(), places);
    add_protrusions(frame.protrusions, cell, p.adhesion, w.laws.front(), places);
    for (const Vec2& x : cell.nucleus.x) add(frame.nucleus, x);
    if (s.cells.size() == 1) continue;
    const auto number = static_cast<float>(number_of(cell.id));
    frame.outline.cell.resize(frame.outline.f_mat.size(), number);
    frame.protrusions.cell.resize(frame.protrusions.id.size(), number);
  }
  return frame;
}

} // namespace matrigrate::observe
