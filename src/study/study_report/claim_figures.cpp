#include "study_report/claim_figures.hpp"

#include "base/file.hpp"
#include "claims/parts.hpp"
#include "run/finished_run.hpp"
#include "study_report/drawn_study.hpp"
#include "study_report/run_shapes.hpp"
#include "tables/csv.hpp"
#include "validation/case.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::study {

namespace {

/// The text of a table; empty if it is not there.
std::string table(const std::filesystem::path& file) {
  constexpr std::size_t largest = std::size_t{1} << 28U;
  return std::filesystem::exists(file) ? read_file(file, largest) : std::string();
}

/// Where a table of a study, or of a verification case, is: apart in folders, or side by side where it is kept.
std::filesystem::path place(std::string_view owner, std::string_view kind, const EvidenceOptions& options) {
  if (!options.from.empty()) return std::filesystem::path(options.from) / fmt::format("{}-{}.csv", owner, kind);
  return std::filesystem::path(options.folder) / owner / fmt::format("{}.csv", kind);
}

std::filesystem::path case_table(std::string_view name, const EvidenceOptions& options) {
  if (!options.from.empty()) return std::filesystem::path(options.from) / fmt::format("validate-{}.csv", name);
  return std::filesystem::path(options.folder) / fmt::format("validate-{0}/{0}.csv", name);
}

/// The film of the first run with two protrusions among fibres that is done and in its folder; empty if there is none.
observe::Film film_among_fibres(const Ensemble& ensemble, const EvidenceOptions& options) {
  const auto drawn = [&](const Result& r) { return ensemble.study.points[r.run.point].label == fibre_point; };
  const auto folder = [&](const Result& r) {
    return run_folder(std::filesystem::path(options.folder) / fibre_study, r.run);
  };
  const auto one = std::ranges::find_if(
      ensemble.results, [&](const Result& r) { return drawn(r) && r.standing.done() && exists(folder(r)); });
  return one == ensemble.results.end() ? observe::Film{} : run::read_run(folder(*one)).film;
}

/// The tables that are made of the runs themselves; of runs that are kept there is no more than their results.
void write_tables(const Evidence& evidence, const EvidenceOptions& options) {
  for (const auto& [name, ensemble] : evidence) {
    const std::filesystem::path folder = std::filesystem::path(options.folder) / name;
    auto runs = ensemble.results;
    std::erase_if(runs, [&](const Result& r) { return !exists(run_folder(folder, r.run)); });
    write_file(folder / "shapes.csv", shapes_csv(ensemble.study, runs, folder));
  }
  if (const auto found = evidence.find(fibre_study); found != evidence.end())
    if (const observe::Film film = film_among_fibres(found->second, options); !film.frames.empty())
      write_file(std::filesystem::path(options.folder) / "fibre-stress.csv", fibre_stress_csv(film));
}

} // namespace

ClaimFigures claim_figures(const Evidence& evidence, const EvidenceOptions& options) {
  ClaimFigures figures;
  if (options.from.empty()) write_tables(evidence, options);
  for (const auto& [name, ensemble] : evidence)
    figures.studies.push_back({{"name", name},
                               {"study", drawn_study(ensemble.study, ensemble.results,
                                                     {.paths = table(place(name, "paths", options)),
                                                      .shapes = table(place(name, "shapes", options)),
                                                      .msd = table(place(name, "msd", options)),
                                                      .adhesions = table(place(name, "adhesions", options))})}});
  for (const PartRow& row : part_rows()) {
    if (row.verification.empty() || !options.chooses(row.id)) continue;
    const std::string csv = table(case_table(row.verification, options));
    const auto which = std::ranges::find(validation::cases(), row.verification, &validation::Case::name);
    if (csv.empty() || !which->plot) continue;
    report::Plot& plot = figures.plots[std::string(row.id)].emplace_back(which->plot(store::read_table(csv)));
    plot.name = fmt::format("validate-{}", row.verification);
  }
  const std::string stress = table(options.tables() / "fibre-stress.csv");
  if (const auto fibres = evidence.find(fibre_study); fibres != evidence.end() && !stress.empty()) {
    const std::string svg = fibre_stress_svg(stress, fibres->second.study.base.ecm.particle_spacing);
    write_file(std::filesystem::path(options.folder) / "fibre-stress.svg", svg);
    figures.pictures["E5"].push_back(
        {"fibre-stress", "Von Mises stress of the fibres on the solid matrix, at the end of one run (Fig 13)", svg});
  }
  return figures;
}

} // namespace matrigrate::study
