// One solve of the drag system of a step, on the disc of the paper (17,665 particles at 150 um), on one thread: of the
// matrix alone and with a cell of three protrusions; all in place or stirred; from zero and from nearby.
// Arguments: digits of the tolerance, start from nearby, cell, stirred.

#include "base/parallel.hpp"
#include "solve/multigrid.hpp"
#include "synthetic.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace matrigrate;

void multigrid(benchmark::State& state) {
  const ThreadLimit one_thread(1);
  const synthetic::Body reference = synthetic::disc(150.0);
  synthetic::Body now = synthetic::disc(150.0);
  if (state.range(3) != 0) synthetic::stir(now, 20.0, 6.0, 0.5);
  if (state.range(2) != 0) synthetic::add_cell(now, 3);
  Multigrid solver(reference.A, 2.0, std::pow(10.0, -static_cast<double>(state.range(0))), 500);
  std::vector<Vec2> guess(now.A.size(), Vec2::Zero());
  if (state.range(1) != 0) {
    Multigrid(reference.A, 2.0, 1e-9, 500).solve(now.A, guess);
    guess = synthetic::nearby(guess, 0.01);
  }
  int iterations = 0;
  for (auto _ : state) {
    std::vector<Vec2> v = guess;
    iterations = solver.solve(now.A, v).iterations;
  }
  state.counters["iterations"] = iterations;
}

BENCHMARK(multigrid)
    ->ArgNames({"digits", "warm", "cell", "stirred"})
    ->ArgsProduct({{4, 6}, {0, 1}, {0, 1}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

} // namespace
