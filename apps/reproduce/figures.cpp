#include "apps/reproduce/figures.hpp"

#include "apps/reproduce/parts.hpp"
#include "apps/study/verbs.hpp"
#include "apps/verbs.hpp"
#include "base/file.hpp"
#include "run/finished_run.hpp"
#include "store/csv.hpp"
#include "study_report/box_plot.hpp"
#include "study_report/run_curves.hpp"
#include "study_report/run_shapes.hpp"
#include "validation/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

namespace matrigrate::apps {

namespace {

using Figures = std::map<std::string, std::vector<draw::Figure>>;

constexpr std::size_t largest_table = std::size_t{1} << 28U;
constexpr std::string_view fibre_study = "kept-protrusions-fibres";

/// A figure of a study that is drawn from a table.
struct Drawn {
  std::string_view table, caption;
  std::string (*draw)(std::string_view csv);
};
constexpr std::array<Drawn, 4> drawn{{{"paths", "Paths of the centre of mass from a common origin", study::paths_svg},
                                      {"shapes", "Shapes of three cells at the end of their paths", study::shapes_svg},
                                      {"msd", "Mean square displacement", study::msd_svg},
                                      {"adhesions", "Relative force at the end of adhesions", study::adhesions_svg}}};

/// The row beside which the figures of a study stand.
std::string row_of(std::string_view study) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 9> rows{{{"stiffness", "A1"},
                                                                               {"contraction", "A8"},
                                                                               {"initiation-rate", "B1"},
                                                                               {"disassembly-rate", "B3"},
                                                                               {"growth-time", "B4"},
                                                                               {"sensitive-adhesions", "C2"},
                                                                               {"insensitive-adhesions", "C3"},
                                                                               {"kept-protrusions", "D1"},
                                                                               {"kept-protrusions-fibres", "E1"}}};
  const auto* found = std::ranges::find(rows, study, &std::pair<std::string_view, std::string_view>::first);
  return found == rows.end() ? std::string() : std::string(found->second);
}

draw::Figure figure(std::string_view study, const Drawn& kind, std::string svg) {
  return {fmt::format("{}-{}", study, kind.table), fmt::format("{} ({})", kind.caption, study), std::move(svg)};
}

draw::Figure fibre_stress(const std::string& csv, double spacing) {
  return {"fibre-stress", "Von Mises stress of the fibres on the solid matrix, at the end of one run (Fig 13)",
          study::fibre_stress_svg(csv, spacing)};
}

/// The film of the first run with two protrusions among fibres that is done; empty if there is none.
observe::Film film_among_fibres(const study::Ensemble& ensemble, const ReproduceOptions& options) {
  constexpr std::size_t two_protrusions = 1;
  const auto one = std::ranges::find_if(
      ensemble.results, [](const auto& r) { return r.run.point == two_protrusions && r.standing.done(); });
  if (one == ensemble.results.end()) return {};
  return read_run(study::run_folder(std::filesystem::path(options.folder) / fibre_study, one->run)).film;
}

/// The plots of verification cases that the chosen rows are judged by, from the tables of these cases.
/// @param table  where the table of a case is
void draw_cases(Figures& figures, const std::function<std::filesystem::path(std::string_view)>& table,
                const ReproduceOptions& options) {
  for (const PartRow& row : part_rows()) {
    if (row.verification.empty() || !options.chooses(row.id)) continue;
    const std::filesystem::path file = table(row.verification);
    const auto which = std::ranges::find(validation::cases(), row.verification, &validation::Case::name);
    if (!std::filesystem::exists(file) || !which->draw) continue;
    figures[std::string(row.id)].push_back(which->draw(store::read_table(read_file(file, largest_table))));
    write_file(std::filesystem::path(options.folder) / fmt::format("validate-{}.svg", row.verification),
               figures[std::string(row.id)].back().svg);
  }
}

} // namespace

Figures draw_runs(const study::Evidence& evidence, const ReproduceOptions& options) {
  Figures figures;
  for (const auto& [name, ensemble] : evidence) {
    const std::filesystem::path folder = std::filesystem::path(options.folder) / name;
    const std::string shapes = study::shapes_csv(ensemble.study, ensemble.results, folder);
    write_file(folder / "shapes.csv", shapes);
    write_file(folder / "shapes.svg", study::shapes_svg(shapes));
    write_file(folder / "centres.csv", study::centres_csv(ensemble.study, ensemble.results, folder));
    for (const Drawn& kind : drawn)
      figures[row_of(name)].push_back(
          figure(name, kind, read_file(folder / fmt::format("{}.svg", kind.table), largest_table)));
  }
  draw_cases(
      figures,
      [&](std::string_view name) {
        return std::filesystem::path(options.folder) / fmt::format("validate-{}", name) / fmt::format("{}.csv", name);
      },
      options);
  if (const auto found = evidence.find(fibre_study); found != evidence.end())
    if (const observe::Film film = film_among_fibres(found->second, options); !film.frames.empty()) {
      const std::string csv = study::fibre_stress_csv(film);
      figures["E5"].push_back(fibre_stress(csv, film.head.spacing));
      write_file(std::filesystem::path(options.folder) / "fibre-stress.csv", csv);
      write_file(std::filesystem::path(options.folder) / "fibre-stress.svg", figures["E5"].back().svg);
    }
  return figures;
}

Figures draw_kept(const study::Evidence& evidence, const ReproduceOptions& options) {
  Figures figures;
  const std::filesystem::path from = options.from;
  const std::filesystem::path to = options.folder;
  for (const auto& [name, ensemble] : evidence) {
    write_file(to / fmt::format("{}.svg", name), study::boxes_svg(ensemble.study, ensemble.results));
    for (const Drawn& kind : drawn) {
      const std::filesystem::path table = from / fmt::format("{}-{}.csv", name, kind.table);
      if (!std::filesystem::exists(table)) continue;
      figures[row_of(name)].push_back(figure(name, kind, kind.draw(read_file(table, largest_table))));
      write_file(to / fmt::format("{}-{}.svg", name, kind.table), figures[row_of(name)].back().svg);
    }
  }
  draw_cases(
      figures, [&](std::string_view name) { return from / fmt::format("validate-{}.csv", name); }, options);
  const auto fibres = evidence.find(fibre_study);
  if (fibres != evidence.end() && std::filesystem::exists(from / "fibre-stress.csv")) {
    figures["E5"].push_back(fibre_stress(read_file(from / "fibre-stress.csv", largest_table),
                                         fibres->second.study.base.ecm.particle_spacing));
    write_file(to / "fibre-stress.svg", figures["E5"].back().svg);
  }
  return figures;
}

} // namespace matrigrate::apps
