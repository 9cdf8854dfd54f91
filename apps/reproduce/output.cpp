#include "apps/reproduce/output.hpp"

#include "apps/reproduce/evidence.hpp"
#include "apps/reproduce/parts.hpp"
#include "apps/shipped_pages.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/terminal/text_table.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "run/provenance.hpp"
#include "run/run_record.hpp"
#include "store/row_file.hpp"
#include "study_report/study_data.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>

namespace matrigrate::apps {

namespace {

std::string joined(const std::vector<std::string>& parts) { return fmt::format("{}", fmt::join(parts, "; ")); }

using View = std::string_view;

/// Every mean and condition of each claim.
std::string conditions_csv(const std::vector<ReproducedRow>& rows) {
  std::string text = store::csv_line({View("id"), View("sentence"), View("published"), View("ours"), View("statistic"),
                                      View("verdict"), View("caveat")});
  for (const ReproducedRow& row : rows) {
    const std::string verdict = to_string(row.finding.verdict);
    const std::string ours = joined(row.finding.ours);
    const std::string statistic = joined(row.finding.conditions);
    text += store::csv_line({View(row.id), View(row.sentence), View(row.published), View(ours), View(statistic),
                             View(verdict), View(row.caveat)});
  }
  return text;
}

/// The table that people read, a line a claim.
std::string claims_csv(const std::vector<ReproducedRow>& rows) {
  std::string text = store::csv_line({View("id"), View("kind"), View("claim"), View("published"), View("ours"),
                                      View("verdict"), View("why_not"), View("verdict_in_larger_disc"),
                                      View("verdict_second_edition"), View("caveat")});
  for (const ReproducedRow& row : rows) {
    const std::string kind = to_string(row.kind);
    const std::string verdict = to_string(row.finding.verdict);
    const std::string why = study::why_not(row.finding);
    const std::string larger = row.in_larger_disc ? to_string(row.in_larger_disc->verdict) : "";
    const std::string second = to_string(row.finding.second);
    text += store::csv_line({View(row.id), View(kind), View(row.sentence), View(row.published), View(row.finding.brief),
                             View(verdict), View(why), View(larger), View(second), View(row.caveat)});
  }
  return text;
}

template <class Value>
std::vector<Value> of_row(const std::map<std::string, std::vector<Value>>& all, View row) {
  const auto found = all.find(std::string(row));
  return found == all.end() ? std::vector<Value>() : found->second;
}

/// Names of the studies that a row is judged by, of those that there are.
std::vector<std::string> studies_of(View row, const study::Evidence& evidence) {
  std::vector<std::string> names;
  for (const study::Claim& claim : study::all_claims())
    if (claim.id == row)
      for (const View name : claim.studies)
        if (evidence.contains(name)) names.emplace_back(name);
  return names;
}

/// "by the second edition of the rules: in direction; missed: ..."
std::string second_edition(const study::Finding& finding) {
  const std::string missed = finding.second_unmet.empty() ? "" : "; missed: " + joined(finding.second_unmet);
  return fmt::format("by the second edition of the rules: {}{}", to_string(finding.second), missed);
}

report::Statement statement(const ReproducedRow& row, const study::Evidence& evidence,
                            const ReproducedFigures& figures) {
  std::vector<std::string> conditions = row.finding.conditions;
  conditions.push_back(second_edition(row.finding));
  if (row.in_larger_disc)
    conditions.push_back(fmt::format("with runs that ended at the rim made again in a larger disc: {}; {}",
                                     to_string(row.in_larger_disc->verdict), row.in_larger_disc->brief));
  return {.id = row.id,
          .kind = to_string(row.kind),
          .sentence = row.sentence,
          .verdict = study::verdict_word(row.finding.verdict),
          .caveat = row.caveat,
          .published = row.published,
          .brief = row.finding.brief,
          .why_not = study::why_not(row.finding),
          .details = {{"Ours; intervals are those of 95 %", row.finding.ours},
                      {"Conditions, each with its statistic", std::move(conditions)}},
          .studies = studies_of(row.id, evidence),
          .plots = of_row(figures.plots, row.id),
          .pictures = of_row(figures.pictures, row.id)};
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

void require_own_files(const ReproduceOptions& options, const std::vector<const study::Claim*>& claims) {
  constexpr std::size_t largest = std::size_t{1} << 30U;
  struct Own {
    std::string name;
    View mark; ///< that a file of ours has
  };
  std::vector<Own> files{{fmt::format("claims-{}.csv", options.id), "id,sentence,published,ours,statistic"},
                         {"claims.csv", "id,kind,claim,published,ours"},
                         {fmt::format("report-{}.html", options.id), "matrigrate-verdicts"}};
  if (options.chooses("F1")) files.push_back({"fields.csv", "t_s,particles,defined,largest_displacement_um"});
  const bool among_fibres = std::ranges::any_of(claims, [](const study::Claim* claim) {
    return std::ranges::find(claim->studies, fibre_study) != claim->studies.end();
  });
  if (among_fibres) files.push_back({"fibre-stress.csv", "what,x_um,y_um,von_mises_Pa"});
  if (among_fibres) files.push_back({"fibre-stress.svg", "Von Mises stress of the fibres"});
  std::vector<std::string> foreign;
  for (const Own& own : files) {
    const std::filesystem::path file = std::filesystem::path(options.folder) / own.name;
    if (std::filesystem::exists(file) && read_file(file, largest).find(own.mark) == std::string::npos)
      foreign.push_back(own.name);
  }
  for (const PartRow& row : part_rows()) { // a folder of `validate` has its results.json
    const std::string name = fmt::format("validate-{}", row.verification);
    const std::filesystem::path folder = std::filesystem::path(options.folder) / name;
    if (row.verification.empty() || !options.chooses(row.id) || !std::filesystem::exists(folder)) continue;
    const bool own = std::filesystem::is_directory(folder)
                     && (std::filesystem::is_empty(folder) || std::filesystem::exists(folder / "results.json"));
    if (!own) foreign.push_back(name);
  }
  if (!foreign.empty())
    throw InputOutputError(fmt::format("{}: {} would be replaced, but {} not written by this program; choose another "
                                       "folder with -o",
                                       options.folder, fmt::join(foreign, ", "), foreign.size() == 1 ? "was" : "were"));
}

void write_reproduction(const std::filesystem::path& folder, const std::string& id,
                        const std::vector<ReproducedRow>& rows, const study::Evidence& evidence,
                        const ReproducedFigures& figures, const std::string& setting, const std::string& command) {
  write_file(folder / fmt::format("claims-{}.csv", id), conditions_csv(rows));
  write_file(folder / "claims.csv", claims_csv(rows));
  report::VerdictReport page{.title = fmt::format("Claims of Heck et al. 2020: {}", id),
                             .facts = facts(evidence, command),
                             .setting = setting,
                             .statements = {},
                             .studies = figures.studies,
                             .provenance = provenance_text()};
  for (const ReproducedRow& row : rows) page.statements.push_back(statement(row, evidence, figures));
  write_file(folder / fmt::format("report-{}.html", id),
             report::filled_page(verdicts_page_template(), report::verdict_data(page)));
}

std::string reproduction_text(const std::vector<ReproducedRow>& rows) {
  std::string text;
  for (const ReproducedRow& row : rows) {
    text += fmt::format("{:<4}{}{}\n    {}\n", row.id,
                        coloured(to_string(row.finding.verdict), colour_of(row.finding.verdict), Stream::out),
                        row.caveat.empty() ? "" : fmt::format(" ({})", row.caveat), row.sentence);
    if (!row.published.empty()) text += fmt::format("    published: {}\n", row.published);
    for (const std::string& line : row.finding.ours) text += fmt::format("    ours: {}\n", line);
    for (const std::string& line : row.finding.conditions) text += fmt::format("      {}\n", line);
    text += fmt::format("    {}\n", second_edition(row.finding));
    if (row.in_larger_disc)
      text += fmt::format("    with runs that ended at the rim made again in a larger disc: {}\n      {}\n",
                          to_string(row.in_larger_disc->verdict), row.in_larger_disc->brief);
  }
  return text;
}

std::string reproduction_table(const std::vector<ReproducedRow>& rows, const study::Evidence& evidence) {
  std::string text;
  for (const auto& [name, ensemble] : evidence) text += fmt::format("{}: {}\n", name, ends_text(ensemble));
  std::vector<std::vector<std::string>> cells{{"row", "kind", "verdict", "second edition", "claim"}};
  for (const ReproducedRow& row : rows) {
    cells.push_back({row.id, to_string(row.kind),
                     to_string(row.finding.verdict) + (row.caveat.empty() ? "" : fmt::format(" ({})", row.caveat)),
                     to_string(row.finding.second), row.sentence});
  }
  return fmt::format("{}\n{}{}.\n{}.\n", text, aligned(cells, 5), study::bottom_line(rows),
                     study::second_bottom_line(rows));
}

std::string reproduction_json(const std::vector<ReproducedRow>& rows, const std::string& setting, bool as_published) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const ReproducedRow& row : rows)
    list.push_back({{"id", row.id},
                    {"sentence", row.sentence},
                    {"published", row.published},
                    {"ours", row.finding.ours},
                    {"statistic", row.finding.conditions},
                    {"verdict", to_string(row.finding.verdict)},
                    {"caveat", row.caveat},
                    {"kind", to_string(row.kind)},
                    {"brief", row.finding.brief},
                    {"why_not", study::why_not(row.finding)},
                    {"verdict_in_larger_disc", row.in_larger_disc ? to_string(row.in_larger_disc->verdict) : ""},
                    {"verdict_second_edition", to_string(row.finding.second)}});
  return Json{{"setting", setting}, {"as_published", as_published}, {"rows", list}}.dump(2, ' ', false,
                                                                                         Json::error_handler_t::replace)
         + "\n";
}

} // namespace matrigrate::apps
