#include "simulation/law_places.hpp"

#include "cues/sensing.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/maturation.hpp"

#include <algorithm>

namespace matrigrate {

std::vector<LawPlace> law_places(const Cell& cell, const EcmState& ecm, const Parameters& p, double time,
                                 const Laws& laws, std::initializer_list<const Law*> users) {
  if (std::ranges::none_of(users, &Law::uses_place)) return {};
  const CortexState& c = cell.cortex;
  std::vector<LawPlace> places = places_along(c, ecm, p, time, std::ranges::any_of(users, &Law::uses_matrix));
  for (LawPlace& place : places) place.f_mat = p.actomyosin.f_mat_body;
  for (const Protrusion& protrusion : cell.protrusions) {
    const double length = protrusion_length(c, protrusion.centre, p.protrusion);
    for (int k = -p.protrusion.half_width; k <= p.protrusion.half_width; ++k) {
      LawPlace& place = places[c.along(protrusion.centre, k)];
      place.l = length;
      place.age = time - protrusion.record.t_initiation;
      if (protrusion.record.t_mature <= time) place.t_mat = time - protrusion.record.t_mature;
      place.f_mat = f_mat_of(protrusion.phase, laws, place);
    }
  }
  return places;
}

std::vector<LawPlace> places_of_forces(const Cell& cell, const EcmState& ecm, const Parameters& p, double time,
                                       const Laws& laws) {
  return law_places(cell, ecm, p, time, laws,
                    {&laws.curvature_factor, &laws.contraction, &laws.maturation, &laws.adhesion_stiffness,
                     &laws.growth_force, &laws.degradation_tip, &laws.degradation_protrusion, &laws.degradation_body});
}

std::vector<LawPlace> places_of_transitions(const Cell& cell, const EcmState& ecm, const Parameters& p, double time,
                                            const Laws& laws) {
  return law_places(cell, ecm, p, time, laws,
                    {&laws.maturation, &laws.maturation_force, &laws.adhesion_stiffness, &laws.disassembly_rate});
}

LawPlace place_of_centre(const Cell& cell, const Vec2& centre, const EcmState& ecm, const Parameters& p, double time,
                         const Law& user) {
  LawPlace mean{.x = centre.x(), .y = centre.y(), .time = time};
  if (!user.uses_matrix()) return mean;
  const std::vector<LawPlace> places = places_along(cell.cortex, ecm, p, time, true);
  for (double LawPlace::*of : {&LawPlace::density, &LawPlace::pressure, &LawPlace::f_degr, &LawPlace::stiffness}) {
    mean.*of = 0.0;
    for (const LawPlace& place : places) mean.*of += place.*of / static_cast<double>(places.size());
  }
  return mean;
}

} // namespace matrigrate
