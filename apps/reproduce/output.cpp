#include "apps/reproduce/output.hpp"

#include "apps/reproduce/evidence.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/terminal/text_table.hpp"
#include "apps/verbs.hpp"
#include "base/file.hpp"
#include "claims/study_claims.hpp"
#include "report/claims_page.hpp"
#include "run/provenance.hpp"
#include "run/run_record.hpp"
#include "store/row_file.hpp"
#include "study_report/box_plot.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>

namespace matrigrate::apps {

namespace {

std::string joined(const std::vector<std::string>& parts) { return fmt::format("{}", fmt::join(parts, "; ")); }

using View = std::string_view;

/// Every mean and condition of each claim.
std::string conditions_csv(const std::vector<ReproducedRow>& rows, const study::Evidence& evidence) {
  std::string text = store::csv_line({View("id"), View("sentence"), View("published"), View("ours"), View("statistic"),
                                      View("verdict"), View("caveat")});
  for (const ReproducedRow& row : rows) {
    const std::string verdict = to_string(row.finding.verdict);
    const std::string ours = joined(row.finding.ours);
    const std::string statistic = joined(row.finding.conditions);
    const std::string caveat = claims_caveat(row.id, evidence);
    text += store::csv_line({View(row.id), View(row.sentence), View(row.published), View(ours), View(statistic),
                             View(verdict), View(caveat)});
  }
  return text;
}

/// The table that people read, a line a claim.
std::string claims_csv(const std::vector<ReproducedRow>& rows, const study::Evidence& evidence) {
  std::string text =
      store::csv_line({View("id"), View("kind"), View("claim"), View("published"), View("ours"), View("verdict"),
                       View("why_not"), View("verdict_in_larger_disc"), View("caveat")});
  for (const ReproducedRow& row : rows) {
    const std::string kind = to_string(study::row_kind(row.id));
    const std::string verdict = to_string(row.finding.verdict);
    const std::string why = study::why_not(row.finding);
    const std::string larger = row.in_larger_disc ? to_string(row.in_larger_disc->verdict) : "";
    const std::string caveat = claims_caveat(row.id, evidence);
    text += store::csv_line({View(row.id), View(kind), View(row.sentence), View(row.published), View(row.finding.brief),
                             View(verdict), View(why), View(larger), View(caveat)});
  }
  return text;
}

report::ClaimSection section(const ReproducedRow& row, const study::Evidence& evidence) {
  std::vector<std::string> conditions = row.finding.conditions;
  if (row.in_larger_disc)
    conditions.push_back(fmt::format("with runs that ended at the rim made again in a larger disc: {}; {}",
                                     to_string(row.in_larger_disc->verdict), row.in_larger_disc->brief));
  return {.id = row.id,
          .sentence = row.sentence,
          .published = row.published,
          .kind = to_string(study::row_kind(row.id)),
          .brief = row.finding.brief,
          .why_not = study::why_not(row.finding),
          .verdict = to_string(row.finding.verdict),
          .caveat = claims_caveat(row.id, evidence),
          .ours = row.finding.ours,
          .conditions = std::move(conditions),
          .figures = {}};
}

Colour colour_of(study::Verdict verdict) {
  return verdict == study::Verdict::holds       ? Colour::good
         : verdict == study::Verdict::undecided ? Colour::warning
                                                : Colour::bad;
}

std::vector<report::Fact> facts(const study::Evidence& evidence, const std::string& command) {
  std::vector<report::Fact> list{
      {"command", command}, {"date", minute_text(std::chrono::system_clock::now())}, {"program", version_line()}};
  for (const auto& [name, ensemble] : evidence) list.push_back({name, ends_text(ensemble)});
  return list;
}

} // namespace

void write_reproduction(const std::filesystem::path& folder, const std::string& id,
                        const std::vector<ReproducedRow>& rows, const study::Evidence& evidence,
                        const std::map<std::string, std::vector<draw::Figure>>& figures, const std::string& setting,
                        const std::string& command) {
  write_file(folder / fmt::format("claims-{}.csv", id), conditions_csv(rows, evidence));
  write_file(folder / "claims.csv", claims_csv(rows, evidence));
  std::vector<report::ClaimSection> sections;
  for (const ReproducedRow& row : rows) {
    sections.push_back(section(row, evidence));
    if (const auto figure = figures.find(row.id); figure != figures.end()) sections.back().figures = figure->second;
  }
  std::vector<study::BoxPlot> all_plots;
  for (const auto& [name, ensemble] : evidence) {
    std::vector<study::BoxPlot> plots = box_plots(ensemble.study, ensemble.results);
    if (!sections.empty())
      sections.back().figures.push_back({name, ensemble.study.title, to_svg(plots, ensemble.study.title)});
    for (study::BoxPlot& plot : plots) {
      plot.title = fmt::format("{}: {}", name, plot.title);
      all_plots.push_back(std::move(plot));
    }
  }
  if (!all_plots.empty())
    write_file(folder / fmt::format("boxes-{}.svg", id), to_svg(all_plots, fmt::format("Studies of row {}", id)));
  write_file(folder / fmt::format("report-{}.html", id),
             report::claims_page(fmt::format("Claims of Heck et al. 2020: {}", id), facts(evidence, command), setting,
                                 sections, provenance_text()));
}

std::string reproduction_text(const std::vector<ReproducedRow>& rows, const study::Evidence& evidence) {
  std::string text;
  for (const ReproducedRow& row : rows) {
    const std::string caveat = claims_caveat(row.id, evidence);
    text += fmt::format("{:<4}{}{}\n    {}\n", row.id,
                        coloured(to_string(row.finding.verdict), colour_of(row.finding.verdict), Stream::out),
                        caveat.empty() ? "" : fmt::format(" ({})", caveat), row.sentence);
    if (!row.published.empty()) text += fmt::format("    published: {}\n", row.published);
    for (const std::string& line : row.finding.ours) text += fmt::format("    ours: {}\n", line);
    for (const std::string& line : row.finding.conditions) text += fmt::format("      {}\n", line);
    if (row.in_larger_disc)
      text += fmt::format("    with runs that ended at the rim made again in a larger disc: {}\n      {}\n",
                          to_string(row.in_larger_disc->verdict), row.in_larger_disc->brief);
  }
  return text;
}

std::string reproduction_table(const std::vector<ReproducedRow>& rows, const study::Evidence& evidence) {
  std::string text;
  for (const auto& [name, ensemble] : evidence) text += fmt::format("{}: {}\n", name, ends_text(ensemble));
  std::vector<std::vector<std::string>> cells{{"row", "kind", "verdict", "claim"}};
  for (const ReproducedRow& row : rows) {
    const std::string caveat = claims_caveat(row.id, evidence);
    cells.push_back({row.id, to_string(study::row_kind(row.id)),
                     to_string(row.finding.verdict) + (caveat.empty() ? "" : fmt::format(" ({})", caveat)),
                     row.sentence});
  }
  return fmt::format("{}\n{}{}.\n", text, aligned(cells, 4), study::bottom_line(rows));
}

std::string reproduction_json(const std::vector<ReproducedRow>& rows, const study::Evidence& evidence,
                              const std::string& setting, bool as_published) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const ReproducedRow& row : rows)
    list.push_back({{"id", row.id},
                    {"sentence", row.sentence},
                    {"published", row.published},
                    {"ours", row.finding.ours},
                    {"statistic", row.finding.conditions},
                    {"verdict", to_string(row.finding.verdict)},
                    {"caveat", claims_caveat(row.id, evidence)},
                    {"kind", to_string(study::row_kind(row.id))},
                    {"brief", row.finding.brief},
                    {"why_not", study::why_not(row.finding)},
                    {"verdict_in_larger_disc", row.in_larger_disc ? to_string(row.in_larger_disc->verdict) : ""}});
  return Json{{"setting", setting}, {"as_published", as_published}, {"rows", list}}.dump(2, ' ', false,
                                                                                         Json::error_handler_t::replace)
         + "\n";
}

} // namespace matrigrate::apps
