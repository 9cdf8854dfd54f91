#pragma once

#include "parameters/laws/laws.hpp"
#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/cortex.hpp"

#include <span>

/// Contraction of the cortex by actomyosin, Heck et al. 2020, Eq. (6). Test: tests/unit/cell/cell_test.cpp
namespace matrigrate {

/// Curvature factor f_curv = exp(-q^2) with q = (kappa - kappa_0)/kappa_w (MODEL.md, I14).
/// @param kappa  [1/um], convex positive   @return [-], in [0, 1]
double curvature_factor(double kappa, const ActomyosinParameters& p);

/// The same of a law that a user may have changed.
double curvature_factor(double kappa, const ActomyosinParameters& p, const Law& law);

/// Tension of the segment of particles i and j, Eq. (6): min(f_mat,i, f_mat,j) f_curv F_am [nN].
/// @param kappa  mean curvature of its ends [1/um]
double F_am(double f_mat_i, double f_mat_j, double kappa, const ActomyosinParameters& p,
            const Law& curvature = usual_laws().curvature_factor);

/// Adds the tension of every segment.
/// @param f_mat  of each particle along the cortex [-]; 0 in a growing or maturing protrusion
/// @param first  node of particle 0   @param force  of all nodes [nN]
void add_actomyosin(const CortexState& c, const ActomyosinParameters& p, std::span<const double> f_mat, double dt,
                    std::uint32_t first, std::span<Vec2> force, DragSystem& A,
                    const Law& curvature_law = usual_laws().curvature_factor);

} // namespace matrigrate
