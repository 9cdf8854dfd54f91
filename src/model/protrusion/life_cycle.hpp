#pragma once

#include "parameters/laws/law.hpp"
#include "parameters/parameters.hpp"
#include "state/state.hpp"

/// The phases of a protrusion and what leads from one to the next (Heck et al. 2020, Fig 3; MODEL.md, I20).
/// Test: tests/unit/protrusion/life_cycle_test.cpp
namespace matrigrate {

/// What decides on a transition.
struct Circumstances {
  double age = 0.0;          ///< time in the present phase [s]
  double force = 0.0;        ///< of the adhesion [nN]
  double loading = 0.0;      ///< rate of that force while the adhesion is taut [nN/s]
  double recoil = 0.0;       ///< speed of the tip of a maturing protrusion towards its base [um/s]
  double support = 0.0;      ///< share of solid around the anchor; when growth ends, around the point to adhere to [-]
  Vec2 ahead = Vec2::Zero(); ///< the point to adhere to, l_0,adh ahead of the tip [um]
  Vec2 held = Vec2::Zero();  ///< that point in the reference configuration, when growth ends [um]
  double draw = 1.0;         ///< uniform in (0, 1)
  LawPlace place{};          ///< of the tip
};

/// What becomes of a protrusion in a step of dt.
struct Transition {
  bool changes = false;
  bool ends = false; ///< its particles are free again; `next` does not matter
  Phase next;
  double waited = 0.0;             ///< time since it was due, which does not count as part of the phase [s]
  EndCause cause = EndCause::none; ///< set where an adhesion ends or is not found
};

/// The transition table:
///   Growing      age >= T_prot, solid ahead          -> Maturing
///   Growing      age >= T_prot, none                 -> Finishing (unadhered), f_mat of the body
///   Maturing     anchor's support gone               -> Finishing (lost)
///   Maturing     age >= T_mat                        -> Contracting with final_f_mat()
///   Maturing     force >= step_force(), at rest      -> Maturing, one step on
///   Contracting  anchor's support gone               -> Finishing (lost)
///   Contracting  ruptures(), bundle has given way    -> Finishing (rupture)
///   Contracting  draw < 1 - exp(-r_off dt), Eq. (7)  -> Finishing (disassembly)
///   Contracting  load above that of the handover     -> Contracting, with a weaker bundle
///   Finishing    age >= T_finish                     -> free
Transition transition(const Phase& phase, const Circumstances& now, const Parameters& p, double dt, const Laws& laws);

/// Circumstances of a protrusion of a cell after a step of dt, with its draw.   @param now  the end of the step
Circumstances circumstances(const Cell& cell, const Protrusion& protrusion, const EcmState& ecm, const Instant& now,
                            const Parameters& p, double dt, const Laws& laws, const LawPlace& place = {});

/// Lets every protrusion of a cell make its transition; those that end move to cell.ended. Rest lengths become the
/// lengths at the end of growth and of maturation.   @param now  the end of the step of dt
/// @param places  of each particle of the cortex, for laws that use them
void update_protrusions(Cell& cell, const EcmState& ecm, const Instant& now, const Parameters& p, double dt,
                        const Laws& laws, std::span<const LawPlace> places = {});

} // namespace matrigrate
