#include "study_report/study_files.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "report/verdict_page.hpp"
#include "run/provenance.hpp"
#include "run/run_record.hpp"
#include "study_report/drawn_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string_view>
#include <utility>

namespace matrigrate::study {

namespace {

/// The text of a table; empty if it is not there.
std::string table(const std::filesystem::path& file) {
  return std::filesystem::exists(file) ? read_file(file, largest_table) : std::string();
}

/// The studies as the page draws them, from tables beside their runs, or kept side by side. Of runs it first writes
/// shapes.csv into the folders of the studies; of runs that are kept there is no more than their results.
nlohmann::ordered_json drawn_studies(const Evidence& evidence, const EvidenceOptions& options) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [name, ensemble] : evidence) {
    const std::filesystem::path folder = std::filesystem::path(options.folder) / name;
    if (options.from.empty()) {
      auto runs = ensemble.results;
      std::erase_if(runs, [&](const Result& r) { return !exists(run_folder(folder, r.run)); });
      write_file(folder / "shapes.csv", shapes_csv(ensemble.study, runs, folder));
    }
    const auto table_of = [&, &study_name = name](const char* kind) {
      return table(options.from.empty()
                       ? folder / fmt::format("{}.csv", kind)
                       : std::filesystem::path(options.from) / fmt::format("{}-{}.csv", study_name, kind));
    };
    list.push_back({{"name", name},
                    {"study", drawn_study(ensemble.study, ensemble.results,
                                          {.paths = table_of("paths"),
                                           .shapes = table_of("shapes"),
                                           .msd = table_of("msd"),
                                           .adhesions = table_of("adhesions")})}});
  }
  return list;
}

report::Statement statement(const JudgedClaim& row) {
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
          .studies = row.studies};
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

void require_own_claim_report(const EvidenceOptions& options) {
  constexpr std::size_t largest = std::size_t{1} << 30U;
  const std::pair<std::string, std::string_view> files[] = {
      // with a mark that a file of ours has
      {fmt::format("claims-{}.csv", options.id), "id,sentence,published,ours,statistic"},
      {"claims.csv", "id,kind,claim,published,ours"},
      {fmt::format("report-{}.html", options.id), "matrigrate-verdicts"}};
  std::vector<std::string> foreign;
  for (const auto& [name, mark] : files) {
    const std::filesystem::path file = std::filesystem::path(options.folder) / name;
    if (std::filesystem::exists(file) && read_file(file, largest).find(mark) == std::string::npos)
      foreign.push_back(name);
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
  write_file(folder / fmt::format("claims-{}.csv", options.id), conditions_csv(rows));
  write_file(folder / "claims.csv", claims_csv(rows));
  report::VerdictReport page{.title = fmt::format("Claims of Heck et al. 2020: {}", options.id),
                             .facts = facts(evidence, report.command),
                             .setting = report.setting,
                             .statements = {},
                             .studies = drawn_studies(evidence, options),
                             .provenance = run::provenance_text()};
  for (const JudgedClaim& row : rows) page.statements.push_back(statement(row));
  write_file(folder / fmt::format("report-{}.html", options.id),
             report::filled_page(report.page_template, report::verdict_data(page)));
}

} // namespace matrigrate::study
