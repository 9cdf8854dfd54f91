/// What      A small study from code: how long protrusions become in two times of growth, with several seeds each,
///           means, and a t-test. Studies of many runs that resume and report are made of one file: docs/studies.md.
/// Equation  Eqs. (1) and (2) of Heck et al. 2020; Student's t-test with pooled variance, as in the paper.
/// Check     Protrusions that grow for 400 s are longer than those that grow for 200 s, with p < 0.01 (Fig 8).
/// Libraries Matrigrate::simulation, Matrigrate::observe, Matrigrate::statistics
#include "observe/readouts.hpp"
#include "simulation/simulation.hpp"
#include "statistics/compare.hpp"

#include <fmt/format.h>

#include <vector>

using namespace matrigrate;

namespace {

constexpr int seeds = 4;

Parameters parameters(double growth_time, int seed) {
  Parameters p;
  p.ecm.radius = 60.0;
  p.run.seed = static_cast<std::uint64_t>(seed);
  p.run.integrator = Integrator::adaptive;
  p.run.time_step = usual_time_step(p.run.integrator);
  p.protrusion.growth_time = growth_time;
  p.protrusion.initiation_rate = 2e-4; // the first ones begin soon
  return p;
}

/// Mean length at the end of growth of the protrusions that have adhered within ten minutes [um].
double mean_length(const Parameters& p) {
  Simulation simulation(p);
  simulation.march(600.0);
  return readouts({}, protrusion_records(simulation.s.cells.front()), p).l_prot.value;
}

std::vector<double> lengths(double growth_time) {
  std::vector<double> found;
  for (int seed = 1; seed <= seeds; ++seed) found.push_back(mean_length(parameters(growth_time, seed)));
  return statistics::finite(found); // a run without an adhered protrusion has none
}

void print(const char* label, const std::vector<double>& sample) {
  const statistics::Moments m = statistics::moments(sample);
  fmt::print("{}: l_prot = {:.2f} +- {:.2f} um (mean, standard deviation, n = {})\n", label, m.mean, m.sd, m.n);
}

} // namespace

int main() {
  const std::vector<double> brief = lengths(200.0);
  const std::vector<double> lasting = lengths(400.0);
  print("T_prot = 200 s", brief);
  print("T_prot = 400 s", lasting);
  const statistics::TestResult test = statistics::t_test(brief, lasting);
  fmt::print("t({:.0f}) = {:.2f}, p = {:.2g}\n", test.df, test.statistic, test.p);
  return test.statistic > 0.0 && test.p < 0.01 ? 0 : 1;
}
