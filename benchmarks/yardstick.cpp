// The same step done plainly and as the program does it, on a migrating cell, one thread. Plainly: scalar loops over
// neighbours, the matrix of the drag system made anew from triplets, conjugate gradients with the diagonal as
// preconditioner (Eigen), started from the velocities of the last step. Prints milliseconds at several times of a run.
// Plainly it is solved twice: to the same residual, and to a hundredth of it, which is about what the same error takes.
//   matrigrate_yardstick [key=value...]

#include "base/parallel.hpp"
#include "ecm/drag_cache.hpp"
#include "ecm/law/material.hpp"
#include "ecm/loop/deformation.hpp"
#include "parameters/read.hpp"
#include "simulation/advance.hpp"
#include "simulation/march.hpp"
#include "simulation/start.hpp"
#include "state/dof.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/LU>
#include <fmt/format.h>

#include <chrono>

namespace {

using namespace matrigrate;

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

using Triplets = std::vector<Eigen::Triplet<double>>;

void add(Triplets& entries, std::size_t i, std::size_t j, const Mat2& block) {
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      if (block(a, b) != 0.0)
        entries.emplace_back(static_cast<int>(2 * i) + a, static_cast<int>(2 * j) + b, block(a, b));
}

/// The entries of a term c w w^T.
template <class Weight, class Product>
void add_terms(Triplets& entries, const DragTerms<Weight>& terms, const Product& product) {
  for (std::size_t m = 0; m < terms.size(); ++m)
    for (std::uint32_t p = terms.first[m]; p < terms.first[m + 1]; ++p)
      for (std::uint32_t q = terms.first[m]; q < terms.first[m + 1]; ++q)
        add(entries, terms.node[p], terms.node[q], terms.c[m] * product(terms.weight[p], terms.weight[q]));
}

/// A v = F with the drag of the matrix summed pair by pair.
[[gnu::noinline]] int solve_plainly(const State& s, const Parameters& p, const Workspace& w, double tolerance,
                                    std::vector<Vec2>& v) {
  const DragSystem& A = w.drag;
  const Kernel kernel(p.ecm.smoothing_length);
  const Adjacency& pairs = w.neighbours.pairs();
  Triplets entries;
  for (std::size_t i = 0; i < s.ecm.size(); ++i) {
    double sum = 0.0;
    if (!s.ecm.clamped[i])
      for (const std::uint32_t j : pairs.of(i)) {
        const double r2 = s.ecm.separation(i, j).squaredNorm();
        const double G =
            pair_drag(r2, kernel.W_slope(std::sqrt(r2)), s.ecm.V0, p.ecm.viscosity, p.ecm.thickness, kernel.h());
        sum += G;
        if (!s.ecm.clamped[j] && G > 0.0) add(entries, i, j, -G * Mat2::Identity());
      }
    add(entries, i, i, (sum > 0.0 ? sum : 1.0) * Mat2::Identity());
  }
  for (std::size_t i = s.ecm.size(); i < A.size(); ++i) add(entries, i, i, A.diagonal[i] * Mat2::Identity());
  add_terms(entries, A.links, [](double a, double b) { return Mat2(a * b * Mat2::Identity()); });
  add_terms(entries, A.directed, [](const Vec2& a, const Vec2& b) { return Mat2(a * b.transpose()); });
  const auto n = static_cast<Eigen::Index>(2 * A.size());
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(tolerance);
  solver.compute(matrix);
  const Eigen::Map<const Eigen::VectorXd> F(A.F[0].data(), n);
  Eigen::Map<Eigen::VectorXd> result(v[0].data(), n);
  result = solver.solveWithGuess(F, result.eval()).eval();
  return static_cast<int>(solver.iterations());
}

/// Elastic forces and the rates of the stress, particle by particle.
Vec2 solid_plainly(const State& s, const Parameters& p, const Reference& ref) {
  const EcmState& ecm = s.ecm;
  const Moduli m = moduli(p.ecm);
  const double scale = p.ecm.hourglass_weight * p.ecm.youngs_modulus * ecm.V0 * ecm.V0;
  std::vector<Mat2> F(ecm.size(), Mat2::Identity()), PB(ecm.size(), Mat2::Zero()), S(ecm.S);
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.f[i] > 0.0) F[i] = deformation_gradient(ecm, ref, i);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.f[i] <= 0.0) continue;
    Mat2 moment = Mat2::Zero();
    for (std::uint32_t k = ref.pairs().first[i]; k < ref.pairs().first[i + 1]; ++k)
      moment +=
          ecm.f[ref.pairs().index[k]] * ref.W_over_r2(k) * hourglass_error(ecm, ref, F, i, k) * ref.X_ij(k).transpose();
    PB[i] =
        (piola_kirchhoff(cauchy_stress(ecm.rho[i], ecm.S[i], m.K), F[i]) + 0.5 * scale / ecm.V0 * moment) * ref.B(i);
  }
  std::vector<Vec2> force(ecm.size(), Vec2::Zero());
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.f[i] <= 0.0) continue;
    for (std::uint32_t k = ref.pairs().first[i]; k < ref.pairs().first[i + 1]; ++k) {
      const std::uint32_t j = ref.pairs().index[k];
      force[i] += p.ecm.thickness * ecm.f[i] * ecm.f[j]
                  * (ecm.V0 * ecm.V0 * (PB[i] + PB[j]) * ref.grad_W(k)
                     + scale * ref.W_over_r2(k) * hourglass_error(ecm, ref, F, i, k));
    }
  }
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.f[i] > 0.0)
      S[i] += p.run.time_step * jaumann_rate(S[i], deformation_rate(ecm, ref, i) * F[i].inverse(), m.G);
  return force[ecm.size() / 3] + S[ecm.size() / 3].col(0);
}

double squared_distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return sum;
}

/// Systems solved plainly to one residual.
struct PlainSolves {
  double tolerance;
  double ms = 0.0, iterations = 0.0, squared_error = 0.0;
};

void compare(const Parameters& p, State s) {
  constexpr int steps = 40;
  constexpr int each = 8;   // steps from one plain step to the next
  constexpr int begun = 10; // before: lists are made, and the steps have become short
  constexpr double share = static_cast<double>(each) / steps;
  Workspace w(s, p);
  Parameters to_the_end = p;
  to_the_end.solver.tolerance = 1e-11;
  const Workspace exactly(s, to_the_end);
  for (int k = 0; k < begun; ++k) advance(s, p, p.run.time_step, w);
  DragCache assembly(s.ecm, p.ecm); // the step's own, once more
  DragSystem A;
  SolidFields fields;
  std::vector<Vec2> force;
  double step = 0.0, drag = 0.0, solid = 0.0, plain_solid = 0.0, iterations = 0.0;
  double squared_error = 0.0, squared_size = 0.0; // of velocities
  PlainSolves plain[] = {{.tolerance = p.solver.tolerance}, {.tolerance = 0.01 * p.solver.tolerance}};
  for (int k = 0; k < steps; ++k) {
    State before = s;
    double start = now_ms();
    advance(s, p, p.run.time_step, w);
    step += (now_ms() - start) / steps;
    iterations += static_cast<double>(w.health.solve.iterations) / steps;
    EcmState ecm = before.ecm;
    force.assign(w.drag.size(), Vec2::Zero());
    start = now_ms();
    add_elastic_forces(ecm, p.ecm, w.reference, fields, force);
    solid += (now_ms() - start) / steps;
    ecm.x = s.ecm.x;
    start = now_ms();
    advance_stress(ecm, p.ecm, w.reference, fields, p.run.time_step);
    solid += (now_ms() - start) / steps;
    start = now_ms();
    assembly.assemble(before.ecm, p.ecm, w.neighbours, s.solver_memory.x_drag, p.ecm.drag_lag, 0.0, A);
    drag += (now_ms() - start) / steps;
    if (k % each != each - 1) continue;
    // the parts that are done in two ways, at the start of the same step
    std::vector<Vec2> exact = w.v;
    if (!exactly.solver->solve(w.drag, exact).converged) fmt::print("not solved\n");
    squared_error += squared_distance(w.v, exact);
    squared_size += squared_distance(exact, std::vector<Vec2>(exact.size(), Vec2::Zero()));
    for (PlainSolves& solves : plain) {
      std::vector<Vec2> v = node_velocities(before);
      start = now_ms();
      solves.iterations += share * solve_plainly(before, p, w, solves.tolerance, v);
      solves.ms += share * (now_ms() - start);
      solves.squared_error += squared_distance(v, exact);
    }
    std::vector<Vec2> v = node_velocities(before);
    for (std::size_t i = 0; i < before.solver_memory.v_before.size(); ++i)
      v[i] = 2.0 * v[i] - before.solver_memory.v_before[i];
    start = now_ms();
    w.solver->solve(w.drag, v);
    drag += share * (now_ms() - start);
    start = now_ms();
    if (!solid_plainly(before, p, w.reference).allFinite()) fmt::print("not finite\n");
    plain_solid += share * (now_ms() - start);
  }
  const double rest = step - drag - solid + plain_solid; // of a plain step
  fmt::print("{:8.0f} {:7.2f} {:7.2f} {:7.2f} {:7.1f} {:9.1e}", s.t, step, drag, solid, iterations,
             std::sqrt(squared_error / squared_size));
  for (const PlainSolves& solves : plain)
    fmt::print(" | {:7.1f} {:7.0f} {:9.1e} {:7.1f}", rest + solves.ms, solves.iterations,
               std::sqrt(solves.squared_error / squared_size), (rest + solves.ms) / step);
  fmt::print("\n");
}

} // namespace

int main(int argc, char** argv) {
  const ThreadLimit one_thread(1);
  const Parameters p = apply_overrides({}, std::vector<std::string>(argv + 1, argv + argc));
  Parameters quick = p; // from one time to the next
  quick.run.integrator = Integrator::adaptive;
  quick.run.time_step = 2.0;
  fmt::print(
      "                   as it is, ms, relative residual {:.0e}   | plainly, to the same residual     | to a "
      "hundredth of it\n"
      "     t_s    step    drag   solid   iter.     error |    step   iter.     error   ratio |    step   iter.   "
      "  error   ratio\n",
      p.solver.tolerance);
  State s = initial_state(p);
  Workspace w(s, quick);
  for (const double t : {600.0, 3600.0, 10800.0, 18000.0}) {
    if (t > p.run.duration) break;
    march(s, quick, w, t);
    State at = s;
    compare(p, at);
  }
}
