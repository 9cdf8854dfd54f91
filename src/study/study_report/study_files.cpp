#include "study_report/study_files.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "claims/claims.hpp"
#include "report/run_page.hpp"
#include "run/folder_state.hpp"
#include "run/own_files.hpp"
#include "run/provenance.hpp"
#include "run/run_record.hpp"
#include "study_report/run_curves.hpp"
#include "tables/csv.hpp"

#include <fmt/format.h>

#include <map>

namespace matrigrate::study {

namespace {

/// The command that computes the study again, from the file in its folder.
std::string command_of(const StudyFolder& study) {
  const std::filesystem::path folder = std::filesystem::absolute(study.folder).lexically_normal();
  const std::filesystem::path name = (folder.has_filename() ? folder : folder.parent_path()).filename();
  return run::command_text({"matrigrate", "study", "run", (name / "study.resolved.toml").string()});
}

/// A table that only some studies have: one of an earlier form of the study would mislead.
void write_or_remove(const std::filesystem::path& file, bool wanted, const std::string& text) {
  if (wanted)
    write_file(file, text);
  else
    run::remove_file(file);
}

/// The tables of what the runs look like.
void write_curves(const StudyFolder& study, const std::vector<Result>& results) {
  constexpr std::size_t max_points = 60;
  const bool wanted = study.study.points.size() <= max_points;
  const auto write = [&](const char* name, const auto& table) {
    write_or_remove(study.folder / name, wanted, wanted ? table(study.study, results, study.folder) : std::string());
  };
  write("paths.csv", paths_csv);
  write("msd.csv", msd_csv);
  write("adhesions.csv", adhesions_csv);
}

/// The rows of results.csv in the folder of the study; none if there is no such table.
store::CsvTable table_there(const StudyFolder& study) {
  constexpr std::size_t largest_table = std::size_t{1} << 28U;
  const std::filesystem::path file = study.folder / "results.csv";
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  try {
    return store::read_csv(read_file(file, largest_table));
  } catch (const InputOutputError&) { // a damaged table, which is made anew
    return {};
  }
}

} // namespace

std::vector<std::string> gone_runs(const StudyFolder& study, const std::vector<Result>& now) {
  const store::CsvTable table = table_there(study);
  const auto run = table.column("run"), label = table.column("label"), replicate = table.column("replicate"),
             seed = table.column("seed"), status = table.column("status");
  if (!run || !label || !replicate || !seed || !status) return {};
  std::map<std::vector<std::string>, std::string> done_there; // names of folders; the other keys outlive these
  for (const auto& row : table.rows)
    if (row[*status] == to_string(RunState::done)) done_there[{row[*label], row[*replicate], row[*seed]}] = row[*run];
  std::vector<std::string> gone;
  for (const Result& r : now) {
    if (r.standing.ended() || r.standing.status == RunState::damaged) continue;
    const auto there = done_there.find(
        {study.study.points[r.run.point].label, fmt::format("{}", r.run.replicate), fmt::format("{}", r.run.seed)});
    if (there != done_there.end())
      gone.push_back(fmt::format("{} (runs/{}): {}", title_of(study, r.run), there->second,
                                 r.standing.reason.empty() ? to_string(r.standing.status) : r.standing.reason));
  }
  return gone;
}

void require_no_loss(const StudyFolder& study, const std::vector<Result>& now) {
  const std::vector<std::string> gone = gone_runs(study, now);
  if (gone.empty()) return;
  throw InputOutputError(
      fmt::format("{}: is kept as it is: it holds results of runs that are not done here any more:\n  {}\n"
                  "Put their folders back into runs/, compute them again with matrigrate study run, or move the table "
                  "elsewhere to make one without them",
                  (study.folder / "results.csv").string(), run::listed(gone, "\n  ")));
}

Collected gathered(const StudyFolder& study) {
  Collected c;
  c.results = results(study.study, study.runs, study.folder);
  c.comparisons = comparisons(study.study, c.results);
  return c;
}

Collected collect_tables(const StudyFolder& study, const std::vector<Result>& kept) {
  Collected c = gathered(study);
  const std::vector<Result> all = with_kept(c.results, kept);
  require_no_loss(study, all);
  write_file(study.folder / "results.csv", results_csv(study.study, all));
  write_file(study.folder / "groups.csv", groups_csv(study.study, c.results));
  write_file(study.folder / "statistics.csv", statistics_csv(study.study, c.comparisons, c.results));
  write_file(study.folder / "correlations.csv", correlations_csv(correlations(study.study, c.results)));
  write_curves(study, c.results);
  return c;
}

void write_study_report(const StudyFolder& study, Collected& collected, const StudyPage& page) {
  collected.claims = claims_about(study, collected.results);
  write_or_remove(study.folder / "claims.csv", !collected.claims.empty(), claims_csv(collected.claims));
  write_file(study.folder / "report.html",
             report::filled_page(page.page_template,
                                 study_data({.study = study.study,
                                             .results = collected.results,
                                             .comparisons = collected.comparisons,
                                             .folder = study.folder,
                                             .provenance = run::provenance_text(),
                                             .claims = collected.claims,
                                             .claims_note = claims_note(study.study),
                                             .played = played_runs(study, collected.results, page.played, page.tracks),
                                             .command = command_of(study),
                                             .tracks = page.tracks})));
}

} // namespace matrigrate::study
