#include "study_report/study_files.hpp"

#include "base/file.hpp"
#include "claims/study_claims.hpp"
#include "report/run_page.hpp"
#include "run/own_files.hpp"
#include "run/provenance.hpp"
#include "run/run_record.hpp"
#include "study_report/played_runs.hpp"
#include "study_report/run_curves.hpp"

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

} // namespace

Collected gathered(const StudyFolder& study) {
  Collected c;
  c.results = results(study.study, study.runs, study.folder);
  c.comparisons = comparisons(study.study, c.results);
  c.screening = screening(study.study, c.results);
  return c;
}

Collected collect_tables(const StudyFolder& study) {
  Collected c = gathered(study);
  write_file(study.folder / "results.csv", results_csv(study.study, c.results));
  write_file(study.folder / "groups.csv", groups_csv(study.study, c.results));
  write_file(study.folder / "statistics.csv", statistics_csv(study.study, c.comparisons, c.results));
  write_file(study.folder / "correlations.csv", correlations_csv(study.study, c.results));
  write_or_remove(study.folder / "discrepancy.csv", !study.study.targets.empty(),
                  discrepancy_csv(study.study, c.screening.discrepancies));
  write_or_remove(study.folder / "effects.csv", !study.study.steps.empty(),
                  effects_csv(study.study, c.screening.effects));
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
                                             .screening = collected.screening,
                                             .tracks = page.tracks})));
}

} // namespace matrigrate::study
