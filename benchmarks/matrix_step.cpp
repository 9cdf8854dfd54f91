// One step of the matrix alone and its parts, on the disc of the paper (17,665 particles without a hole at 150 um)
// while a kernel-distributed force of 0.06 nN pulls at its centre: warm starts and displacements as they are in use.

#include "base/parallel.hpp"
#include "ecm/loop/fluid.hpp"
#include "ecm/loop/stress.hpp"
#include "ecm/loop/viscosity.hpp"
#include "simulation/advance.hpp"
#include "sph/interpolate.hpp"
#include "state/initial.hpp"

#include <benchmark/benchmark.h>

#include <memory>

namespace {

using namespace matrigrate;

struct Pulled {
  explicit Pulled(double radius) {
    p.ecm.radius = radius;
    p.ecm.cell_hole = false;
    s.ecm = disc(p);
    w = std::make_unique<Workspace>(s, p);
    const PointWeights centre = solid_weights(s.ecm, Kernel(p.ecm.smoothing_length), Vec2::Zero());
    load = [centre](const State&, std::span<Vec2> force) { spread(centre, Vec2(0.06, 0.0), force); };
    for (int k = 0; k < 10; ++k) advance(s, p, p.run.time_step, *w, load);
  }
  Parameters p;
  State s;
  std::unique_ptr<Workspace> w;
  Loads load;
};

void count(benchmark::State& state, const Pulled& a) {
  const auto particles = static_cast<std::int64_t>(a.s.ecm.size());
  state.SetItemsProcessed(state.iterations() * particles);
  state.counters["particles"] = static_cast<double>(particles);
}

const ThreadLimit one_thread(1);

void neighbours(benchmark::State& state) {
  const Pulled a(static_cast<double>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(neighbours_within(a.s.ecm.x, 6.2, 0.0));
  count(state, a);
}

void assembly(benchmark::State& state) {
  Pulled a(static_cast<double>(state.range(0)));
  for (auto _ : state) {
    assemble(a.s, a.p, a.p.run.time_step, *a.w);
    complete_forces(a.s, a.p, *a.w, a.load);
    benchmark::ClobberMemory();
  }
  count(state, a);
}

void solve(benchmark::State& state) {
  Pulled a(static_cast<double>(state.range(0)));
  assemble(a.s, a.p, a.p.run.time_step, *a.w);
  complete_forces(a.s, a.p, *a.w, a.load);
  int iterations = 0;
  for (auto _ : state) {
    std::vector<Vec2> v = a.s.ecm.v; // warm start from the step before
    iterations = a.w->solver->solve(a.w->drag, v).iterations;
  }
  state.counters["iterations"] = iterations;
  count(state, a);
}

void stress(benchmark::State& state) {
  const Pulled a(static_cast<double>(state.range(0)));
  EcmState ecm = a.s.ecm;
  follow_deformation(ecm, a.w->reference, a.w->solid);
  for (auto _ : state) benchmark::DoNotOptimize(advance_stress(ecm, a.p.ecm, a.w->reference, a.w->solid, 1e-9));
  count(state, a);
}

void whole_step(benchmark::State& state) {
  Pulled a(static_cast<double>(state.range(0)));
  for (auto _ : state) advance(a.s, a.p, a.p.run.time_step, *a.w, a.load);
  count(state, a);
}

BENCHMARK(neighbours)->Arg(150)->Unit(benchmark::kMillisecond);
BENCHMARK(assembly)->Arg(150)->Unit(benchmark::kMillisecond);
BENCHMARK(solve)->Arg(150)->Unit(benchmark::kMillisecond);
BENCHMARK(stress)->Arg(150)->Unit(benchmark::kMillisecond);
BENCHMARK(whole_step)->Arg(72)->Arg(150)->Arg(300)->Arg(600)->Unit(benchmark::kMillisecond)->Iterations(40);

} // namespace
