#include "claims/fields_shown.hpp"

#include "base/failure.hpp"
#include "base/text.hpp"
#include "tables/csv.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace matrigrate::study {

namespace {

constexpr double interval = 300.0; // [s]

/// The frames of a point, summed up.
struct Shown {
  std::string label;
  std::set<double> times; ///< of frames whose fields are finite at every particle of solid [s]
  std::size_t undefined = 0;
  double displacement = 0.0; ///< [um]
  double von_mises = 0.0;    ///< [Pa]
};

std::vector<Shown> summed_up(std::string_view csv) {
  const store::CsvTable table = store::read_csv(csv);
  if (store::read_csv(fields_header()).header != table.header) throw InputOutputError("is no table of fields");
  std::vector<Shown> all;
  for (const std::vector<std::string>& row : table.rows) {
    auto shown = std::ranges::find(all, row[5], &Shown::label);
    if (shown == all.end()) shown = all.insert(all.end(), Shown{.label = row[5], .times = {}});
    if (row[1] == row[2])
      shown->times.insert(store::csv_number(row[0]));
    else
      ++shown->undefined;
    shown->displacement = std::max(shown->displacement, store::csv_number(row[3]));
    shown->von_mises = std::max(shown->von_mises, store::csv_number(row[4]));
  }
  return all;
}

} // namespace

std::string fields_header() { return "t_s,particles,defined,largest_displacement_um,largest_von_mises_Pa,point\n"; }

std::string fields_rows(std::string_view label, const observe::Film& film) {
  std::string csv;
  for (const observe::Frame& frame : film.frames) {
    std::size_t solid = 0;
    std::size_t defined = 0;
    double displacement = 0.0;
    double von_mises = 0.0;
    for (std::size_t i = 0; i < frame.matrix.f_degr.size(); ++i) {
      if (frame.matrix.f_degr[i] <= 0.0F) continue;
      ++solid;
      const double u = std::hypot(frame.matrix.displacement[2 * i], frame.matrix.displacement[2 * i + 1]);
      const double stress = frame.matrix.von_mises[i];
      if (!std::isfinite(u) || !std::isfinite(stress)) continue;
      ++defined;
      displacement = std::max(displacement, u);
      von_mises = std::max(von_mises, stress);
    }
    csv += fmt::format("{:.0f},{},{},{:.3f},{:.1f},{}\n", frame.t, solid, defined, displacement, von_mises,
                       csv_text(label));
  }
  return csv;
}

Finding fields_shown(std::string_view csv, double t_end) {
  const std::vector<Shown> all = summed_up(csv);
  const auto wanted = static_cast<std::size_t>(std::llround(t_end / interval)) + 1;
  Finding finding;
  std::vector<std::string> brief;
  const auto condition = [&](bool met, const std::string& text) {
    finding.conditions.push_back(fmt::format("{}: {}", text, met ? "met" : "not met"));
    if (!met) finding.unmet.push_back(text);
  };
  condition(all.size() == 2, fmt::format("runs at two stiffnesses ({})", all.size()));
  for (const Shown& s : all) {
    std::size_t there = 0;
    for (std::size_t k = 0; k < wanted; ++k) there += s.times.count(interval * static_cast<double>(k));
    condition(there == wanted && s.undefined == 0,
              fmt::format("both fields defined at {} in each of {} frames ({})", s.label, wanted, there));
    condition(s.displacement > 0.0 && s.von_mises > 0.0, fmt::format("neither is zero throughout at {}", s.label));
    brief.push_back(fmt::format("{}: up to {:.3g} um and {:.3g} Pa", s.label, s.displacement, s.von_mises));
  }
  finding.ours = brief;
  finding.brief = fmt::format("{}", fmt::join(brief, "; "));
  finding.verdict = all.empty() ? Verdict::undecided : finding.unmet.empty() ? Verdict::holds : Verdict::does_not_hold;
  return finding;
}

} // namespace matrigrate::study
