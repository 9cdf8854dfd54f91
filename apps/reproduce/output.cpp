#include "apps/reproduce/output.hpp"

#include "apps/shipped_pages.hpp"
#include "apps/study/files.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "claims/parts.hpp"
#include "run/provenance.hpp"
#include "run/run_record.hpp"
#include "study_report/study_data.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>

namespace matrigrate::apps {

namespace {

std::string joined(const std::vector<std::string>& parts) { return fmt::format("{}", fmt::join(parts, "; ")); }

using View = std::string_view;

template <class Value>
std::vector<Value> of_row(const std::map<std::string, std::vector<Value>>& all, View row) {
  const auto found = all.find(std::string(row));
  return found == all.end() ? std::vector<Value>() : found->second;
}

/// "with runs that ended at the rim made again in a larger disc: holds; ..."
std::string with_larger_disc(const study::Finding& finding) {
  const std::string missed = finding.unmet.empty() ? "" : "; missed: " + joined(finding.unmet);
  return fmt::format("with runs that ended at the rim made again in a larger disc: {}{}", to_string(finding.verdict),
                     missed);
}

report::Statement statement(const study::JudgedClaim& row, const ReproducedFigures& figures) {
  std::vector<std::string> conditions = row.finding.conditions;
  if (row.in_larger_disc)
    conditions.push_back(fmt::format("{}; {}", with_larger_disc(*row.in_larger_disc), row.in_larger_disc->brief));
  return {.id = row.id,
          .kind = kind_name(row.kind),
          .sentence = row.sentence,
          .verdict = row.finding.verdict,
          .caveat = row.caveat,
          .published = row.published,
          .brief = row.finding.brief,
          .why_not = study::why_not(row.finding),
          .details = {{"Ours; intervals are those of 95 %", row.finding.ours},
                      {"Conditions, each with its statistic", std::move(conditions)}},
          .studies = row.studies,
          .plots = of_row(figures.plots, row.id),
          .pictures = of_row(figures.pictures, row.id)};
}

Colour colour_of(study::Verdict verdict) {
  return verdict == study::Verdict::holds           ? Colour::good
         : verdict == study::Verdict::does_not_hold ? Colour::bad
                                                    : Colour::warning;
}

std::vector<report::Fact> facts(const study::Evidence& evidence, const std::string& command) {
  std::vector<report::Fact> list{
      {"command", command}, {"date", minute_text(std::chrono::system_clock::now())}, {"program", version_line()}};
  for (const auto& [name, ensemble] : evidence) list.push_back({name, study::ends_text(ensemble)});
  return list;
}

} // namespace

void require_own_files(const ReproduceOptions& options, const std::vector<study::Claim>& claims) {
  constexpr std::size_t largest = std::size_t{1} << 30U;
  struct Own {
    std::string name;
    View mark; ///< that a file of ours has
  };
  std::vector<Own> files{{fmt::format("claims-{}.csv", options.id), "id,sentence,published,ours,statistic"},
                         {"claims.csv", "id,kind,claim,published,ours"},
                         {fmt::format("report-{}.html", options.id), "matrigrate-verdicts"}};
  if (options.chooses("F1")) files.push_back({"fields.csv", "t_s,particles,defined,largest_displacement_um"});
  const bool among_fibres = std::ranges::any_of(claims, [](const study::Claim& claim) {
    const std::vector<std::string> names = claim.studies();
    return std::ranges::find(names, fibre_study) != names.end();
  });
  if (among_fibres) files.push_back({"fibre-stress.csv", "what,x_um,y_um,von_mises_Pa"});
  if (among_fibres) files.push_back({"fibre-stress.svg", "Von Mises stress of the fibres"});
  std::vector<std::string> foreign;
  for (const Own& own : files) {
    const std::filesystem::path file = std::filesystem::path(options.folder) / own.name;
    if (std::filesystem::exists(file) && read_file(file, largest).find(own.mark) == std::string::npos)
      foreign.push_back(own.name);
  }
  for (const study::PartRow& row : study::part_rows()) { // a folder of `validate` has its results.json
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
                        const std::vector<study::JudgedClaim>& rows, const study::Evidence& evidence,
                        const ReproducedFigures& figures, const std::string& setting, const std::string& command) {
  write_file(folder / fmt::format("claims-{}.csv", id), study::conditions_csv(rows));
  write_file(folder / "claims.csv", study::claims_csv(rows));
  report::VerdictReport page{.title = fmt::format("Claims of Heck et al. 2020: {}", id),
                             .facts = facts(evidence, command),
                             .setting = setting,
                             .statements = {},
                             .studies = figures.studies,
                             .provenance = provenance_text()};
  for (const study::JudgedClaim& row : rows) page.statements.push_back(statement(row, figures));
  write_file(folder / fmt::format("report-{}.html", id),
             report::filled_page(verdicts_page_template(), report::verdict_data(page)));
}

std::string reproduction_text(const std::vector<study::JudgedClaim>& rows) {
  std::string text;
  for (const study::JudgedClaim& row : rows) {
    text += fmt::format("{:<4}{}{}\n    {}\n", row.id,
                        coloured(to_string(row.finding.verdict), colour_of(row.finding.verdict), Stream::out),
                        row.caveat.empty() ? "" : fmt::format(" ({})", row.caveat), row.sentence);
    if (!row.published.empty()) text += fmt::format("    published: {}\n", row.published);
    for (const std::string& line : row.finding.ours) text += fmt::format("    ours: {}\n", line);
    for (const std::string& line : row.finding.conditions) text += fmt::format("      {}\n", line);
    if (row.in_larger_disc)
      text += fmt::format("    {}\n      {}\n", with_larger_disc(*row.in_larger_disc), row.in_larger_disc->brief);
  }
  return text;
}

std::string reproduction_table(const std::vector<study::JudgedClaim>& rows, const study::Evidence& evidence) {
  std::string text;
  for (const auto& [name, ensemble] : evidence) text += fmt::format("{}: {}\n", name, study::ends_text(ensemble));
  return text + "\n" + claims_text(rows);
}

std::string reproduction_json(const std::vector<study::JudgedClaim>& rows, const std::string& setting,
                              bool as_published) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const study::JudgedClaim& row : rows) list.push_back(study::claim_json(row));
  return Json{{"setting", setting}, {"as_published", as_published}, {"rows", list}}.dump(2, ' ', false,
                                                                                         Json::error_handler_t::replace)
         + "\n";
}

} // namespace matrigrate::apps
