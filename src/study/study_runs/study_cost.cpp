#include "study_runs/study_cost.hpp"

#include "run/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace matrigrate::study {

namespace {

constexpr std::size_t max_looked_at = 200; // points, for warnings

/// Takes milliseconds per point, so of many points it looks at some, spread evenly over the list.
void add_warnings(const std::vector<Point>& points, StudyCost& c) {
  c.looked_at = std::min(points.size(), max_looked_at);
  for (std::size_t k = 0; k < c.looked_at; ++k) {
    const Point& point = points[k * points.size() / c.looked_at];
    for (const std::string& warning : run::warnings(point.parameters, run::derived(point.parameters)))
      c.warnings.push_back(fmt::format("{}: {}", point.label, warning));
  }
}

} // namespace

StudyCost cost(const StudyFolder& study) {
  StudyCost c;
  const auto replicates = static_cast<double>(study.study.replicates);
  std::map<std::tuple<double, double, Lattice>, std::size_t> counted; // particles of each matrix
  for (const Point& point : study.study.points) {
    const EcmParameters& ecm = point.parameters.ecm;
    const auto [matrix, is_new] = counted.try_emplace({ecm.radius, ecm.particle_spacing, ecm.lattice}, 0);
    if (is_new) matrix->second = run::particle_count(point.parameters);
    const run::RunCost run = run::run_cost(point.parameters, matrix->second);
    c.run_times.push_back(run.wall_time);
    c.wall_time += replicates * run.wall_time;
    c.memory_bytes = std::max(c.memory_bytes, run.memory_bytes);
    c.disk_bytes += replicates * run.disk_bytes;
  }
  add_warnings(study.study.points, c);
  return c;
}

} // namespace matrigrate::study
