#pragma once

#include "parameters/parameters.hpp"
#include "state/state.hpp"

#include <cstdint>
#include <span>

/// Initiation of protrusions (Heck et al. 2020, section "Protrusion initiation"). Test:
/// tests/unit/protrusion/initiation_test.cpp, tests/unit/protrusion/protrusion_test.cpp
namespace matrigrate {

/// Whether a protrusion could be centred on particle i: none of its particles belongs to one.
/// @param of_particle  from membership()
bool has_room(const CortexState& c, std::size_t i, std::span<const int> of_particle, const ProtrusionParameters& p);

/// The cell's outline, as far as initiation needs it.
struct Outline {
  std::span<const std::uint8_t> of_front; ///< 1 for the particles of the front; all of them before the first protrusion
  std::span<const Vec2> normals;          ///< outward unit normals of the particles
  Vec2 centre = Vec2::Zero();             ///< centre of mass of the cell [um]
  double area = 1.0;                      ///< over A_0; matters with an enforced number [-]
  std::span<const double> rate;           ///< of each particle [1/s]
  std::span<const double> propensity{};   ///< factor of each particle on its rate, >= 0; empty: 1 for all [-]
};

/// Share of the growth force that the tip of a protrusion around particle i would feel: the mean of max(0, n . d_prot)
/// over its pushing particles [-].
double facing(const CortexState& c, std::size_t i, const Outline& outline, const ProtrusionParameters& p);

/// A protrusion begins around particle i; it grows from `centre` towards it. The first of all sets the polarization.
/// @param centre  centre of mass of the cell [um]   @param t  time [s]
void begin_protrusion(Cell& cell, std::size_t i, const Vec2& centre, double t, const ProtrusionParameters& p);

/// Each particle of the front that has room and whose tip faces its direction (least_facing) initiates a protrusion
/// with probability 1 - exp(-c r dt), c its propensity and r its rate, in the order of the ring; it grows from the
/// centre of mass towards the particle. The first of all sets the polarization.
///
/// With an enforced number (protrusion.number > 0) instead one candidate in each candidate_interval of model time,
/// whatever the step, is drawn among all particles, each as likely as its propensity, and times its rate where rates
/// differ, rear ones rear_share times as likely; it initiates if it has room and faces its direction, fewer than that
/// number live, and the cell's area is no more than area_limit A_0 (Heck et al. 2020, section on the number of
/// protrusions; MODEL.md, I27).
/// @param now  the end of the step of dt
void initiate(Cell& cell, const Instant& now, const Parameters& p, double dt, const Outline& outline);

} // namespace matrigrate
