#include "apps/study_files.hpp"

#include "apps/provenance.hpp"
#include "apps/shipped_pages.hpp"
#include "apps/study_claims.hpp"
#include "apps/study_players.hpp"
#include "base/file.hpp"
#include "io/run_page.hpp"
#include "study/box_plot.hpp"
#include "study/study_data.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::apps {

namespace {

/// "1.23", or "-" where it is not defined.
std::string number(double value) { return std::isnan(value) ? "-" : fmt::format("{:.3g}", value); }

std::string groups_text(const StudyFolder& study, const Collected& collected, const std::string& readout) {
  std::string text = fmt::format("{}\n", readout);
  for (std::size_t i = 0; i < study.study.points.size(); ++i) {
    const std::vector<double> x = study::sample(collected.results, i, readout);
    const statistics::Interval mean = statistics::mean_interval(x, study.study.comparisons.alpha);
    text += fmt::format("  {:<40} n = {:<4} mean {} [{}, {}]\n", study.study.points[i].label, x.size(),
                        number(mean.value), number(mean.low), number(mean.high));
  }
  return text;
}

} // namespace

Collected gathered(const StudyFolder& study) {
  Collected c;
  c.results = study::results(study.study, study.runs, study.folder);
  c.comparisons = study::comparisons(study.study, c.results);
  return c;
}

Collected collect_tables(const StudyFolder& study) {
  Collected c = gathered(study);
  write_file(study.folder / "results.csv", study::results_csv(study.study, c.results));
  write_file(study.folder / "groups.csv", study::groups_csv(study.study, c.results));
  write_file(study.folder / "statistics.csv", study::statistics_csv(study.study, c.comparisons));
  write_file(study.folder / "correlations.csv", study::correlations_csv(study.study, c.results));
  write_file(study.folder / "boxes.svg", study::boxes_svg(study.study, c.results));
  return c;
}

void write_study_report(const StudyFolder& study, const Collected& collected, const std::vector<std::string>& played) {
  write_file(study.folder / "report.html",
             io::filled_page(study_page_template(),
                             study::study_data({.study = study.study,
                                                .results = collected.results,
                                                .comparisons = collected.comparisons,
                                                .folder = study.folder,
                                                .provenance = provenance_text(),
                                                .claims = claims_about(study, collected.results),
                                                .claims_note = claims_note(study.study),
                                                .played = played_runs(study, collected.results, played)})));
}

Collected collect(const StudyFolder& study) {
  Collected c = collect_tables(study);
  write_study_report(study, c);
  return c;
}

std::string collected_text(const StudyFolder& study, const Collected& collected) {
  constexpr std::size_t most = 30; // points or pairs that a person reads
  std::string text;
  for (const std::string& readout : study.study.readouts) {
    if (study.study.points.size() <= most) text += groups_text(study, collected, readout);
    std::size_t shown = 0;
    for (const study::Comparison& c : collected.comparisons) {
      if (c.readout != readout || shown++ == most) continue;
      text += fmt::format("  {} -> {}: difference {} [{}, {}], p {}, Holm {}, g {} [{}, {}]; {}\n",
                          study.study.points[c.a].label, study.study.points[c.b].label, number(c.difference.value),
                          number(c.difference.low), number(c.difference.high), number(c.test.p), number(c.p_holm),
                          number(c.g.value), number(c.g.low), number(c.g.high), study::power_text(c));
    }
  }
  return text;
}

} // namespace matrigrate::apps
