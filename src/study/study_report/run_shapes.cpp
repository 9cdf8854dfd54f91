#include "study_report/run_shapes.hpp"

#include "base/text.hpp"
#include "cell/geometry.hpp"
#include "draw/particle_picture.hpp"
#include "store/checkpoint.hpp"
#include "tables/csv.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matrigrate::study {

namespace {

constexpr std::size_t replicates_shown = 3;

} // namespace

std::string shapes_csv(const Study& study, const std::vector<Result>& results,
                       const std::filesystem::path& study_folder) {
  std::string csv = "replicate,x_um,y_um,point\n";
  for (const Result& r : results) {
    if (!r.standing.done() || r.run.replicate > replicates_shown) continue;
    const std::filesystem::path checkpoint = run_folder(study_folder, r.run) / store::checkpoint_name;
    if (!std::filesystem::exists(checkpoint)) continue;
    const CortexState cortex = store::read_checkpoint(checkpoint).state.cells.at(0).cortex;
    for (std::size_t i = 0; i < cortex.size(); i += 2)
      csv += fmt::format("{},{:.2f},{:.2f},{}\n", r.run.replicate, cortex.x[i].x(), cortex.x[i].y(),
                         csv_text(study.points[r.run.point].label));
  }
  return csv;
}

std::string fibre_stress_csv(const observe::Film& film) {
  constexpr double shown = 60.0; // [um]
  std::string csv = "what,x_um,y_um,von_mises_Pa\n";
  if (film.frames.empty()) return csv;
  const observe::Frame& last = film.frames.back();
  CortexState cortex{.x = {}, .v = {}, .l0 = {}};
  for (std::size_t i = 0; i + 1 < last.outline.x.size(); i += 2)
    cortex.x.emplace_back(last.outline.x[i], last.outline.x[i + 1]);
  const Vec2 centre = centroid(cortex);
  for (std::size_t i = 0; i < last.matrix.fibre_von_mises.size(); ++i) {
    const Vec2 x(film.head.reference[2 * i] + last.matrix.displacement[2 * i],
                 film.head.reference[2 * i + 1] + last.matrix.displacement[2 * i + 1]);
    if ((x - centre).norm() > shown) continue;
    csv += fmt::format("matrix,{:.2f},{:.2f},{}\n", x.x(), x.y(),
                       last.matrix.f_degr[i] > 0.0F ? fmt::format("{:.1f}", last.matrix.fibre_von_mises[i])
                                                    : std::string());
  }
  for (const Vec2& x : cortex.x) csv += fmt::format("outline,{:.2f},{:.2f},\n", x.x(), x.y());
  return csv;
}

std::string fibre_stress_svg(std::string_view fibre_stress_csv, double spacing) {
  draw::ParticlePicture picture{.title = "Von Mises stress of the fibres (Eq. 11)",
                                .value_label = "von Mises stress of the fibres (Pa)"};
  std::vector<double> values;
  for (const std::vector<std::string>& row : store::read_csv(fibre_stress_csv).rows) {
    const Vec2 x(store::csv_number(row[1]), store::csv_number(row[2]));
    if (row[0] == "outline") {
      picture.outlines.resize(1);
      picture.outlines.front().push_back(x);
      continue;
    }
    picture.position.push_back(x);
    picture.value.push_back(store::csv_number(row[3]));
    if (std::isfinite(picture.value.back())) values.push_back(picture.value.back());
  }
  if (!values.empty()) { // all but one in a hundred lie on the scale
    const auto place = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * 99 / 100);
    std::ranges::nth_element(values, place);
    picture.value_min = 0.0;
    picture.value_max = *place > 0.0 ? *place : 1.0;
  }
  picture.particle_size = spacing;
  return draw::to_svg(picture, 700);
}

} // namespace matrigrate::study
