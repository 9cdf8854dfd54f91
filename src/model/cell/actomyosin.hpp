#pragma once

#include "parameters/laws/law.hpp"
#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/cortex.hpp"

#include <span>

/// Contraction of the cortex by actomyosin, Heck et al. 2020, Eq. (6). Test: tests/unit/cell/cell_test.cpp
namespace matrigrate {

/// Tension of the segment of particles i and j, Eq. (6): min(f_mat,i, f_mat,j) f_curv F_am [nN].
/// @param kappa  mean curvature of its ends [1/um], convex positive   @param curvature_factor  f_curv (MODEL.md, I14)
double F_am(double f_mat_i, double f_mat_j, double kappa, const ActomyosinParameters& p, const Law& curvature_factor);

/// Adds the tension of every segment.
/// @param f_mat  of each particle along the cortex [-]; 0 in a growing or maturing protrusion
/// @param first  node of particle 0   @param force  of all nodes [nN]
void add_actomyosin(const CortexState& c, const ActomyosinParameters& p, std::span<const double> f_mat, double dt,
                    std::uint32_t first, std::span<Vec2> force, DragSystem& A, const Law& curvature_factor);

} // namespace matrigrate
