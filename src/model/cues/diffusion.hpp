#pragma once

#include "base/adjacency.hpp"
#include "parameters/parameters.hpp"
#include "state/state.hpp"

#include <span>
#include <vector>

/// Diffusion of a chemoattractant in the matrix (MODEL.md, I34). Test: tests/unit/cues/diffusion_test.cpp
namespace matrigrate {

/// dc/dt = D laplace c - loss c + source on the lattice of the reference positions, by backward Euler and conjugate
/// gradients. The Laplacian takes the 4 nearest neighbours of the square lattice, or the 6 of the hexagonal one.
/// Clamped particles of the rim keep their concentration (Dirichlet condition); nothing passes into an obstacle.
class Diffusion {
public:
  Diffusion(const EcmState& ecm, const EcmParameters& p);

  /// Advances ecm.attractant by dt [s].
  /// @param D     [um^2/s], >= 0
  /// @param loss  rate of decay and uptake at each particle, >= 0 [1/s]
  /// @throws NumericalFailure if the system is not solved
  void advance(EcmState& ecm, double D, std::span<const double> loss, double dt);

private:
  void multiply(const EcmState& ecm, std::span<const double> diagonal, double coupling, std::span<const double> x,
                std::vector<double>& y) const;

  Adjacency m_neighbours; ///< nearest ones, without those in obstacles
  double m_weight;        ///< of a neighbour in the Laplacian [1/um^2]
  std::vector<double> m_diagonal, m_r, m_p, m_q;
};

/// Rate at which each particle loses attractant: cues.decay, and cues.uptake where it lies inside a cell [1/s].
std::vector<double> attractant_loss(const State& s, const CueParameters& p);

} // namespace matrigrate
