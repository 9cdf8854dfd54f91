#include "apps/export/pictures.hpp"

#include "apps/export/tools.hpp"
#include "base/file.hpp"
#include "base/time_text.hpp"
#include "draw/cell_picture.hpp"
#include "draw/frame_scene.hpp"
#include "draw/particle_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::apps {

namespace {

constexpr int width = 900; // [pixel]

std::vector<std::vector<Vec2>> outlines(const observe::CellScene& scene) {
  std::vector<std::vector<Vec2>> all;
  for (const observe::DrawnCell& cell : scene.cells) all.push_back(cell.outline);
  return all;
}

std::string picture(const run::FinishedRun& run, const observe::Frame& frame, Layer layer,
                    const report::Limits& limits) {
  return draw::to_svg({.title = time_text(frame.t),
                       .value_label = std::string(label_of(layer)),
                       .position = draw::matrix_positions(run.film.head, frame),
                       .value = values_of(frame, layer),
                       .particle_size = run.film.head.spacing,
                       .value_min = limits.low,
                       .value_max = limits.high,
                       .diverging = is_signed(layer),
                       .outlines = outlines(draw::frame_scene(run.film.head, frame, {}))},
                      width);
}

} // namespace

void export_svg(const run::FinishedRun& run, const std::filesystem::path& folder) {
  write_file(folder / "contact_sheet.svg", draw::contact_sheet(run.memory.scenes));
  draw::ParticlePicture path{.title = "Path of the centre of mass", .value_label = "time [h]"};
  double reach = 0.1; // [um]
  for (const CellResult& cell : run.cells)
    for (const TrackRow& row : cell.rows) {
      path.position.push_back(row.centre);
      path.value.push_back(row.t / 3600.0);
      reach = std::max(reach, (row.centre - path.position.front()).norm());
    }
  path.particle_size = 0.02 * reach;
  write_file(folder / "path.svg", draw::to_svg(path));
}

void export_pictures(const run::FinishedRun& run, Layer layer, const std::filesystem::path& folder) {
  const report::Limits limits = limits_of(run.film, layer);
  for (std::size_t k = 0; k < run.film.frames.size(); ++k) {
    const std::string name = (folder / fmt::format("frame_{:04}", k)).string();
    write_file(name + ".svg", picture(run, run.film.frames[k], layer, limits));
    call({"rsvg-convert", "--output", name + ".png", name + ".svg"});
  }
}

} // namespace matrigrate::apps
