#include "run/output/output.hpp"

#include "base/failure.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace matrigrate::run {

// Each is in the file of its name.
using Begin = Output(RunSoFar&, const State&);
Begin protrusions, rows, fields, results, report_page;

std::span<const OutputKind> output_kinds() {
  static constexpr auto kinds = std::to_array<OutputKind>({
      {"", R"(checkpoint(_prev|_next)?\.h5|scenario\.resolved\.toml|run\.json)"},
      {"checkpoints", R"(t_[0-9.]+s\.h5)"},
      {"", R"(protrusions\.csv)", protrusions},
      {"", R"((tracks|health|group)\.csv)", rows},
      {"snapshots", R"(t_[0-9.]+s(_displacement|_fibre_stress)?\.svg)"}, // of earlier versions
      {"", R"((snapshots|failure)\.svg)"},                               // as well
      {"", R"(fields\.(h5|xdmf|part))", fields},
      {"", R"((msd|summary)\.csv|summary\.json)", results},
      {"", R"(report\.html)", report_page},
  });
  return kinds;
}

HealthRow health_row(const RunSoFar& run, const State& s, const Workspace& w, HealthWatch& watch) {
  HealthRow row = watch.row(s, run.p, w.health);
  row.force_imbalance = s.step == run.memory.step ? run.memory.force_imbalance : force_imbalance(w);
  return row;
}

void require_health(const RunSoFar& run, const State& s, const HealthRow& row) {
  if (const auto found = alarm(s, run.p, row))
    throw NumericalFailure(found->cause, fmt::format("step {} (t = {:.6g} s): {}", s.step, s.t, found->text));
}

std::string time_name(double t) {
  const double rounded = std::round(1e3 * t) / 1e3;
  const double whole = std::floor(rounded);
  const std::string fraction = rounded > whole ? fmt::format("{:.3g}", rounded - whole).substr(1) : std::string();
  return fmt::format("t_{:05.0f}{}s", whole, fraction);
}

} // namespace matrigrate::run
