#pragma once

#include "base/vector.hpp"

#include <cstdint>
#include <limits>
#include <string_view>
#include <variant>

/// The life of a protrusion (Heck et al. 2020, Fig 3). Each phase holds what only it has.
namespace matrigrate {

/// Pushes its tip outwards along `direction`.
struct Growing {
  Vec2 direction = Vec2::Zero(); ///< d_prot, unit vector
  double base_width = 0.0;       ///< distance of the first from the last particle at initiation [um]
};

/// Adheres, pulls, and matures as the matrix resists.
struct Maturing {
  Vec2 direction = Vec2::Zero(); ///< d_prot at the end of growth, unit vector
  Vec2 anchor = Vec2::Zero();    ///< the adhered point of the matrix [um]
  int steps = 0;                 ///< maturation steps done; f_mat stands at 0.1 (steps + 1), at most 1
  double last_step = 0.0;        ///< when the last one was done, since the end of growth [s]
  Vec2 held = Vec2::Zero();      ///< the anchor in the reference configuration [um]
};

/// Pulls with its final maturation until its adhesion disassembles.
struct Contracting {
  Vec2 anchor = Vec2::Zero(); ///< [um]
  double f_mat = 0.0;         ///< [-]
  double bundle = 0.0;        ///< pull of the tip on its base that is left of maturation [nN]
  double falling = 0.0; ///< force of the adhesion when last seen, while what maturation loaded falls off; then 0 [nN]
  Vec2 held = Vec2::Zero(); ///< the anchor in the reference configuration [um]
};

/// Without adhesion, still contracting.
struct Finishing {
  double f_mat = 0.0; ///< [-]
};

using Phase = std::variant<Growing, Maturing, Contracting, Finishing>;

/// "growing", "maturing", "contracting", "finishing".
std::string_view name(const Phase& phase);

/// Why an adhesion ended.
enum class EndCause {
  none,        ///< it has not, or the run ended first
  unadhered,   ///< growth ended where no solid was in reach
  disassembly, ///< by Eq. (7)
  rupture,     ///< the force passed f_rupt 2 f_mat F_am, of both strands
  lost         ///< the matrix around the anchor was degraded
};

std::string_view name(EndCause cause);

inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// What is kept of a protrusion: times of its transitions [s], `undefined` where they did not happen, and the paper's
/// read-outs.
struct ProtrusionRecord {
  std::uint32_t id = 0;     ///< in the order of initiation, from 1
  std::uint32_t centre = 0; ///< the central particle
  double t_initiation = undefined;
  double t_adhesion = undefined;    ///< end of growth, adhered
  double t_mature = undefined;      ///< end of maturation
  double t_disassembly = undefined; ///< loss of the adhesion, or end of growth without one
  double t_end = undefined;         ///< particles free again
  double length = undefined;        ///< l_prot: from between the base particles to the tip, at the end of growth [um]
  double direction = undefined;     ///< of d_prot at the end of growth, from the x axis [rad]
  double f_mat = undefined;         ///< at the end of maturation [-]
  double force = undefined;         ///< of the adhesion at disassembly [nN]
  EndCause cause = EndCause::none;
};

/// A protrusion that lives.
struct Protrusion {
  std::uint32_t centre = 0; ///< the central particle; w_prot particles to each side belong to it
  double since = 0.0;       ///< when the phase began [s]
  Phase phase;
  ProtrusionRecord record;
};

} // namespace matrigrate
