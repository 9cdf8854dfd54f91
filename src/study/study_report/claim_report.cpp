#include "study_report/claim_report.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "claims/parts.hpp"
#include "report/verdict_page.hpp"
#include "run/provenance.hpp"
#include "run/run_record.hpp"
#include "study_report/claim_figures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <string_view>

namespace matrigrate::study {

namespace {

template <class Value>
std::vector<Value> of_row(const std::map<std::string, std::vector<Value>>& all, std::string_view row) {
  const auto found = all.find(std::string(row));
  return found == all.end() ? std::vector<Value>() : found->second;
}

report::Statement statement(const JudgedClaim& row, const ClaimFigures& figures) {
  std::vector<std::string> conditions = row.finding.conditions;
  if (row.in_larger_disc)
    conditions.push_back(fmt::format("{}; {}", with_larger_disc(*row.in_larger_disc), row.in_larger_disc->brief));
  std::vector<report::Sentences> details{{"Ours; intervals are of 95 %", row.finding.ours},
                                         {"Conditions, each with its statistic", std::move(conditions)}};
  if (row.second_edition)
    details.push_back({fmt::format("By the second edition of the rules: {}", to_string(row.second_edition->verdict)),
                       row.second_edition->conditions});
  return {.id = row.id,
          .kind = kind_name(row.kind),
          .sentence = row.sentence,
          .verdict = row.finding.verdict,
          .caveat = row.caveat,
          .published = row.published,
          .brief = row.finding.brief,
          .why_not = why_not(row.finding),
          .details = std::move(details),
          .studies = row.studies,
          .plots = of_row(figures.plots, row.id),
          .pictures = of_row(figures.pictures, row.id)};
}

std::vector<report::Fact> facts(const Evidence& evidence, const std::string& command) {
  std::vector<report::Fact> list{{"command", command},
                                 {"date", run::minute_text(std::chrono::system_clock::now())},
                                 {"program", run::version_line()}};
  std::size_t studies = 0, runs = 0; // of which nothing is to be said
  for (const auto& [name, ensemble] : evidence) {
    const bool done = std::ranges::all_of(ensemble.results, [](const Result& r) { return r.standing.done(); });
    if (!done) list.push_back({name, ends_text(ensemble)});
    if (done) ++studies, runs += ensemble.results.size();
  }
  if (studies > 0)
    list.push_back({"runs", fmt::format("all {} of {} {} done", runs, studies, studies > 1 ? "studies" : "study")});
  return list;
}

} // namespace

void require_own_claim_report(const std::vector<Claim>& claims, const EvidenceOptions& options) {
  constexpr std::size_t largest = std::size_t{1} << 30U;
  struct Own {
    std::string name;
    std::string_view mark; ///< that a file of ours has
  };
  std::vector<Own> files{{fmt::format("claims-{}.csv", options.id), "id,sentence,published,ours,statistic"},
                         {"claims.csv", "id,kind,claim,published,ours"},
                         {fmt::format("report-{}.html", options.id), "matrigrate-verdicts"}};
  if (options.chooses("F1")) files.push_back({"fields.csv", "t_s,particles,defined,largest_displacement_um"});
  const bool among_fibres = std::ranges::any_of(claims, [](const Claim& claim) {
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

std::string with_larger_disc(const Finding& finding) {
  const std::string missed = finding.unmet.empty() ? "" : fmt::format("; missed: {}", fmt::join(finding.unmet, "; "));
  return fmt::format("with runs that ended at the rim made again in a larger disc: {}{}", to_string(finding.verdict),
                     missed);
}

void write_claim_report(const std::vector<JudgedClaim>& rows, const Evidence& evidence, const EvidenceOptions& options,
                        const ClaimReport& report) {
  const std::filesystem::path folder = options.folder;
  const ClaimFigures figures = claim_figures(evidence, options);
  write_file(folder / fmt::format("claims-{}.csv", options.id), conditions_csv(rows));
  write_file(folder / "claims.csv", claims_csv(rows));
  report::VerdictReport page{.title = fmt::format("Claims of Heck et al. 2020: {}", options.id),
                             .facts = facts(evidence, report.command),
                             .setting = report.setting,
                             .statements = {},
                             .studies = figures.studies,
                             .provenance = run::provenance_text()};
  for (const JudgedClaim& row : rows) page.statements.push_back(statement(row, figures));
  write_file(folder / fmt::format("report-{}.html", options.id),
             report::filled_page(report.page_template, report::verdict_data(page)));
}

} // namespace matrigrate::study
