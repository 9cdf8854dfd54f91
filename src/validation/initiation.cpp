#include "protrusion/initiation.hpp"
#include "base/random.hpp"
#include "cell/geometry.hpp"
#include "statistics/distributions.hpp"
#include "validation/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace matrigrate::validation {

namespace {

constexpr std::uint64_t cells = 1000;

/// Time of the first protrusion of a polarized cell [s], and its place among the particles of the front, from 0 to 1.
std::pair<double, double> wait(Parameters p, std::uint64_t seed, const Cell& start,
                               const std::vector<std::uint8_t>& of_front) {
  p.run.seed = seed;
  p.protrusion.number = 0;
  Cell cell = start;
  Instant now;
  const std::vector<Vec2> n = normals(cell.cortex);
  const std::vector<double> rate(of_front.size(), p.protrusion.initiation_rate);
  while (cell.protrusions.empty()) {
    ++now.step;
    initiate(cell, now, p, p.run.time_step, {.of_front = of_front, .normals = n, .rate = rate});
  }
  const std::uint32_t centre = cell.protrusions.front().centre;
  const auto before = static_cast<double>(std::count(of_front.begin(), of_front.begin() + centre, 1));
  const auto all = static_cast<double>(std::count(of_front.begin(), of_front.end(), 1));
  return {(static_cast<double>(now.step) - 0.5) * p.run.time_step, (before + uniform(seed, Purpose::test, 0, 0)) / all};
}

} // namespace

Result initiation(const Parameters& p) {
  Result result;
  Cell cell;
  cell.cortex = round_cortex(p.cell);
  cell.polarization = 1.0;
  const std::vector<std::uint8_t> of_front = front(cell.cortex, *cell.polarization);
  const auto n = static_cast<double>(std::count(of_front.begin(), of_front.end(), 1));
  std::vector<double> times, places;
  for (std::uint64_t seed = p.run.seed; seed < p.run.seed + cells; ++seed) {
    const auto [time, place] = wait(p, seed, cell, of_front);
    times.push_back(time);
    places.push_back(place);
  }
  const double rate = n * p.protrusion.initiation_rate;
  const double mean = std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(cells);
  const std::string rare = "exceeded by one sample in a hundred that follows it";
  result.checks.push_back({"share of the particles at the front", n / static_cast<double>(cell.cortex.size()), 0.5,
                           1.0 / static_cast<double>(cell.cortex.size()), "half of an odd number"});
  result.checks.push_back({fmt::format("mean waiting time of {} cells, times r_prot and the front's particles", cells),
                           mean * rate, 1.0, 3.0 / std::sqrt(static_cast<double>(cells)), "three standard errors"});
  result.checks.push_back({"D sqrt(n) of the waiting times against the exponential",
                           kolmogorov_smirnov_exponential(times, rate), 0.0, one_in_a_hundred, rare});
  result.checks.push_back({"D sqrt(n) of the places along the front against the uniform",
                           kolmogorov_smirnov(places, [](double x) { return x; }), 0.0, one_in_a_hundred, rare});

  std::sort(times.begin(), times.end());
  result.table.columns = {"waiting_time_s", "share_still_waiting", "exponential"};
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const double waiting = 1.0 - static_cast<double>(k + 1) / static_cast<double>(times.size());
    result.table.add({times[k], waiting, std::exp(-rate * times[k])});
  }
  result.add("initiation", "A constant rate a front particle: exponential waiting times.",
             {.title = "Waiting for the first protrusion of a polarized cell",
              .x_label = "time (s)",
              .y_label = "share still waiting",
              .log_y = true,
              .series = {result.curve("measured", "waiting_time_s", "share_still_waiting"),
                         result.curve("exponential", "waiting_time_s", "exponential", report::Mark::dashed)}});
  return result;
}

} // namespace matrigrate::validation
