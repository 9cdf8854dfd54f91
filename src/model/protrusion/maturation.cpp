#include "protrusion/maturation.hpp"

#include <algorithm>
#include <variant>

namespace matrigrate {

namespace {

/// A force `pull` between the centre of a protrusion and either end of its base, half of it each.
void pull_base(const CortexState& c, const Protrusion& protrusion, const Parameters& p, double pull, double dt,
               std::uint32_t first, std::span<Vec2> force, DragSystem& A) {
  const std::uint32_t tip = first + protrusion.centre;
  for (const int end : {-p.protrusion.half_width, p.protrusion.half_width}) {
    const auto i = static_cast<std::uint32_t>(c.along(protrusion.centre, end));
    const Vec2 d = c.x[i] - c.x[protrusion.centre];
    const double length = d.norm();
    if (length <= 0.0) continue;
    const Vec2 e = d / length;
    const double T = 0.5 * pull;
    force[tip] += T * e;
    force[first + i] -= T * e;
    A.directed.add(dt * T / length, {{tip, perpendicular(e)}, {first + i, -perpendicular(e)}});
  }
}

} // namespace

double maturation_force(const Parameters& p) { return p.adhesion.maturation_strands * p.actomyosin.force; }

double longest_maturation(const Parameters& p) {
  return p.adhesion.maturation_time + (max_maturation_steps + 2) * p.run.time_step;
}

double maturing_f_mat(int steps, const Laws& laws, const LawPlace& place) {
  return std::min(1.0, laws.maturation({steps + 1.0}, place));
}

double f_mat_of(const Phase& phase, const Laws& laws, const LawPlace& place) {
  if (const auto* maturing = std::get_if<Maturing>(&phase)) return maturing_f_mat(maturing->steps, laws, place);
  if (const auto* contracting = std::get_if<Contracting>(&phase)) return contracting->f_mat;
  if (const auto* finishing = std::get_if<Finishing>(&phase)) return finishing->f_mat;
  return 0.0;
}

double step_force(const Loaded& now, const Laws& laws) {
  return laws.maturation_force({static_cast<double>(now.steps), now.force, now.age}, now.place);
}

bool step_done(const Loaded& now, const Parameters& p, const Laws& laws) {
  if (now.steps >= max_maturation_steps || now.force < step_force(now, laws)) return false;
  return now.steps > 0 || p.adhesion.rest_speed <= 0.0 || now.recoil <= p.adhesion.rest_speed;
}

double time_since_done(const Loaded& now, double dt, const Laws& laws) {
  const double excess = now.force - step_force(now, laws);
  if (excess < dt * now.loading) return excess / now.loading;
  return now.steps == 0 ? dt : 0.0;
}

double final_f_mat(const Loaded& now, double last_step, const Parameters& p, const Laws& laws) {
  const auto share = [](double part, double of) { return of > 0.0 ? std::clamp(part / of, 0.0, 1.0) : 1.0; };
  const double part = now.steps > 0 ? share((p.adhesion.maturation_time - last_step) * now.steps, last_step)
                                    : share(now.force, step_force(now, laws));
  return std::clamp(laws.maturation({now.steps + part}, now.place), p.actomyosin.f_mat_body, 1.0);
}

void add_maturation(const Cell& cell, const Parameters& p, const Laws& laws, std::span<const LawPlace> places,
                    double dt, std::uint32_t first, std::span<Vec2> force, DragSystem& A) {
  for (const Protrusion& protrusion : cell.protrusions) {
    if (const auto* contracting = std::get_if<Contracting>(&protrusion.phase); contracting != nullptr) {
      if (contracting->bundle > 0.0) pull_base(cell.cortex, protrusion, p, contracting->bundle, dt, first, force, A);
      continue;
    }
    const auto* maturing = std::get_if<Maturing>(&protrusion.phase);
    if (maturing == nullptr) continue;
    const double f_mat = maturing_f_mat(maturing->steps, laws, place_at(places, protrusion.centre));
    force[first + protrusion.centre] -= f_mat * maturation_force(p) * maturing->direction;
  }
}

void pin_bases(const Cell& cell, const Parameters& p, std::uint32_t first, DragSystem& A) {
  for (const Protrusion& protrusion : cell.protrusions) {
    if (!std::holds_alternative<Maturing>(protrusion.phase)) continue;
    for (int k = 0; k < p.adhesion.pinned_particles; ++k)
      for (const int end : {-p.protrusion.half_width + k, p.protrusion.half_width - k})
        A.diagonal[first + cell.cortex.along(protrusion.centre, end)] += p.adhesion.base_drag;
  }
}

Contracting handover(const Maturing& maturing, double f_mat, double F, const Parameters& p) {
  Contracting next{.anchor = maturing.anchor, .f_mat = f_mat, .held = maturing.held};
  next.bundle = p.adhesion.handover_share * f_mat * p.actomyosin.force;
  next.falling = F;
  return next;
}

Contracting handed_over(Contracting phase, double F, const Parameters& p, double dt) {
  const double excess = F - p.adhesion.handover_share * phase.f_mat * p.actomyosin.force;
  phase.falling = excess > 0.0 && F < phase.falling ? F : 0.0;
  if (phase.falling > 0.0 || excess <= 0.0) return phase;
  phase.bundle = std::max(0.0, phase.bundle + std::expm1(-dt / p.adhesion.handover_time) * excess);
  return phase;
}

} // namespace matrigrate
