#include "protrusion/life_cycle.hpp"

#include "base/random.hpp"
#include "protrusion/adhesion.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/maturation.hpp"

#include <cmath>
#include <utility>

namespace matrigrate {

namespace {

Transition to(Phase next, EndCause cause = EndCause::none) {
  return {.changes = true, .ends = false, .next = std::move(next), .cause = cause};
}

/// The table, a row of functions: one for each phase.
struct Table {
  const Circumstances& now;
  const Parameters& p;
  double dt;
  const Laws& laws;

  Contracting contracting(const Maturing& phase) const {
    return handover(phase, final_f_mat(loaded(phase), phase.last_step, p, laws), now.force, p);
  }

  Loaded loaded(const Maturing& phase) const {
    return {phase.steps, now.force, now.age, now.loading, now.recoil, now.place};
  }

  /// Whether a phase has lasted so long; phases end at the end of a step, as early as late.
  bool lasted(double time) const { return now.age >= time - 0.5 * dt; }

  bool lost() const { return now.support < p.adhesion.least_support; }

  Transition operator()(const Growing& phase) const {
    if (!lasted(p.protrusion.growth_time)) return {};
    if (lost()) return to(Finishing{p.actomyosin.f_mat_body}, EndCause::unadhered);
    return to(Maturing{.direction = phase.direction, .anchor = now.ahead, .held = now.held});
  }

  Transition operator()(const Maturing& phase) const {
    if (lost()) return to(Finishing{p.actomyosin.f_mat_body}, EndCause::lost);
    if (lasted(p.adhesion.maturation_time)) return to(contracting(phase));
    if (step_done(loaded(phase), p, laws)) {
      Maturing next = phase;
      ++next.steps;
      Transition step = to(next);
      step.waited = std::min(now.age, time_since_done(loaded(phase), dt, laws));
      std::get<Maturing>(step.next).last_step = now.age - step.waited;
      return step;
    }
    return {};
  }

  Transition operator()(const Contracting& phase) const {
    const Finishing finishing{phase.f_mat};
    if (lost()) return to(finishing, EndCause::lost);
    if (phase.bundle <= 0.0 && ruptures(now.force, phase.f_mat, p)) return to(finishing, EndCause::rupture);
    const double rate = laws.disassembly_rate({now.force, phase.f_mat, now.age}, now.place);
    if (now.draw < event_probability(rate, dt)) return to(finishing, EndCause::disassembly);
    const Contracting next = handed_over(phase, now.force, p, dt);
    if (next.bundle == phase.bundle && next.falling == phase.falling) return {};
    return to(next);
  }

  Transition operator()(const Finishing&) const {
    if (!lasted(p.protrusion.finishing_time)) return {};
    return {.changes = true, .ends = true, .next = {}, .cause = EndCause::none};
  }
};

/// The point l_0,adh ahead of the tip of a growing protrusion, or the anchor of one that has adhered.
Vec2 adhesion_site(const CortexState& c, const Protrusion& protrusion, const AdhesionParameters& p) {
  if (const auto* growing = std::get_if<Growing>(&protrusion.phase))
    return c.x[protrusion.centre] + p.rest_length * growing->direction;
  const Vec2* point = anchor(protrusion.phase);
  return point != nullptr ? *point : c.x[protrusion.centre];
}

/// Writes down the transition at time t.
void record(Protrusion& protrusion, const Transition& change, const Circumstances& now, double length, double t) {
  ProtrusionRecord& r = protrusion.record;
  if (change.cause != EndCause::none) {
    r.cause = change.cause;
    r.t_disassembly = t;
  }
  if (const auto* growing = std::get_if<Growing>(&protrusion.phase)) {
    r.length = length;
    r.direction = std::atan2(growing->direction.y(), growing->direction.x());
    if (change.cause == EndCause::none) r.t_adhesion = t;
    return;
  }
  if (change.cause != EndCause::none) r.force = now.force;
  if (const auto* contracting = std::get_if<Contracting>(&change.next);
      contracting != nullptr && std::holds_alternative<Maturing>(protrusion.phase)) {
    r.t_mature = t;
    r.f_mat = contracting->f_mat;
  }
}

} // namespace

Transition transition(const Phase& phase, const Circumstances& now, const Parameters& p, double dt, const Laws& laws) {
  return std::visit(Table{now, p, dt, laws}, phase);
}

Circumstances circumstances(const Cell& cell, const Protrusion& protrusion, const EcmState& ecm, const Instant& now,
                            const Parameters& p, double dt, const Laws& laws, const LawPlace& place) {
  Circumstances found{.age = now.t - protrusion.since + 1e-6 * dt, // times are sums of steps
                      .force = adhesion_force(cell.cortex, protrusion, p.adhesion, laws, place),
                      .ahead = adhesion_site(cell.cortex, protrusion, p.adhesion),
                      .draw = uniform(p.run.seed, Purpose::disassembly, now.step, protrusion.record.id, cell.id),
                      .place = place};
  const bool growing = std::holds_alternative<Growing>(protrusion.phase);
  if (const auto* maturing = std::get_if<Maturing>(&protrusion.phase))
    found.recoil = -cell.cortex.v[protrusion.centre].dot(maturing->direction);
  if (growing && found.age >= p.protrusion.growth_time - 0.5 * dt) {
    const PointWeights weights = hold_weights(found.ahead, ecm, p);
    found.support = weights.support;
    found.held = reference_position(found.ahead, weights, ecm);
  }
  if (!growing) {
    const PointWeights weights = hold_weights(protrusion.phase, ecm, p);
    found.support = weights.support;
    if (const Vec2* point = anchor(protrusion.phase))
      found.loading = adhesion_slope((*point - cell.cortex.x[protrusion.centre]).norm(), p.adhesion, laws, place)
                      * lengthening(cell.cortex, protrusion, ecm, weights);
  }
  return found;
}

void update_protrusions(Cell& cell, const EcmState& ecm, const Instant& now, const Parameters& p, double dt,
                        const Laws& laws, std::span<const LawPlace> places) {
  std::vector<Protrusion> alive;
  for (Protrusion& protrusion : cell.protrusions) {
    const Circumstances found =
        circumstances(cell, protrusion, ecm, now, p, dt, laws, place_at(places, protrusion.centre));
    const Transition change = transition(protrusion.phase, found, p, dt, laws);
    if (!change.changes) {
      alive.push_back(protrusion);
      continue;
    }
    if (change.ends) {
      protrusion.record.t_end = now.t;
      cell.ended.push_back(protrusion.record);
      continue;
    }
    record(protrusion, change, found, protrusion_length(cell.cortex, protrusion.centre, p.protrusion), now.t);
    if (change.next.index() != protrusion.phase.index()) {
      if (!std::holds_alternative<Contracting>(protrusion.phase)) // growth or maturation is over
        relax_rest_lengths(cell.cortex, protrusion.centre, p.protrusion);
      protrusion.since = now.t;
    }
    protrusion.since += change.waited;
    protrusion.phase = change.next;
    alive.push_back(protrusion);
  }
  cell.protrusions = std::move(alive);
}

} // namespace matrigrate
