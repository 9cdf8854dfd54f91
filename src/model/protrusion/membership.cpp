#include "protrusion/membership.hpp"

#include <variant>

namespace matrigrate {

namespace {

/// f_mat of the particles of a protrusion along the cortex.
struct CorticalMaturation {
  double operator()(const Growing&) const { return 0.0; }
  double operator()(const Maturing&) const { return 0.0; }
  double operator()(const Contracting& phase) const { return phase.f_mat; }
  double operator()(const Finishing& phase) const { return phase.f_mat; }
};

bool is_soft(const Phase& phase) {
  return std::holds_alternative<Growing>(phase) || std::holds_alternative<Maturing>(phase);
}

} // namespace

Membership membership(const Cell& cell, const Parameters& p) {
  const CortexState& c = cell.cortex;
  Membership m{std::vector<int>(c.size(), no_protrusion), std::vector<double>(c.size(), p.actomyosin.f_mat_body),
               std::vector<double>(c.size(), p.cell.spring_stiffness), std::vector<std::uint8_t>(c.size(), 0),
               std::vector<std::uint8_t>(c.size(), 0)};
  for (std::size_t n = 0; n < cell.protrusions.size(); ++n)
    for (int k = -p.protrusion.half_width; k <= p.protrusion.half_width; ++k) {
      const std::size_t i = c.along(cell.protrusions[n].centre, k);
      m.of_particle[i] = static_cast<int>(n);
      m.f_mat[i] = std::visit(CorticalMaturation{}, cell.protrusions[n].phase);
    }
  for (std::size_t i = 0; i < c.size(); ++i) {
    const int owner = m.of_particle[i];
    if (owner == no_protrusion || m.of_particle[c.next(i)] != owner) continue;
    m.on_protrusion[i] = 1;
    if (!is_soft(cell.protrusions[static_cast<std::size_t>(owner)].phase)) continue;
    m.soft[i] = 1;
    m.k_s[i] = p.protrusion.spring_stiffness;
  }
  return m;
}

} // namespace matrigrate
