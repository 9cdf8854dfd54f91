#pragma once

#include "parameters/laws/law.hpp"
#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/cortex.hpp"

#include <span>

/// Contraction of the cortex by actomyosin, Heck et al. 2020, Eq. (6). Test: tests/unit/cell/cell_test.cpp
namespace matrigrate {

/// What the tension of a segment depends on.
struct Strand {
  double f_mat;       ///< the smaller one of its ends [-]
  double f_curv;      ///< laws.curvature_factor (MODEL.md, I14) [-]
  double kappa;       ///< mean curvature of its ends, convex positive [1/um]
  double speed = 0.0; ///< at which it shortens [um/s]
};

/// The segment from particle i.   @param f_mat  of each particle [-]   @param kappa  of each particle [1/um]
Strand strand(const CortexState& c, std::size_t i, std::span<const double> f_mat, std::span<const double> kappa,
              const Laws& laws, const LawPlace& place);

/// Tension of a segment, Eq. (6): laws.contraction, f_mat f_curv F_am by default [nN].
double F_am(const Strand& strand, const Laws& laws, const LawPlace& place = {});

/// Adds the tension of every segment; linearly implicit in the speed at which it shortens.
/// @param f_mat   of each particle along the cortex [-]; 0 in a growing or maturing protrusion
/// @param places  of each particle, for laws that use them; a segment is where its first particle is
/// @param first   node of particle 0   @param force  of all nodes [nN]
void add_actomyosin(const CortexState& c, std::span<const double> f_mat, std::span<const LawPlace> places, double dt,
                    std::uint32_t first, std::span<Vec2> force, DragSystem& A, const Laws& laws);

} // namespace matrigrate
