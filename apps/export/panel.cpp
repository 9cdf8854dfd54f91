#include "apps/export/panel.hpp"

#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/file.hpp"
#include "base/time_text.hpp"
#include "draw/figure_panel.hpp"
#include "draw/frame_scene.hpp"
#include "parameters/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace matrigrate::apps {

namespace {

/// A time of a list [s].
double time_of(const std::string& text) {
  try {
    const units::Quantity quantity = units::parse_quantity(text);
    const units::Unit unit = units::parse_unit(quantity.unit.empty() ? "h" : quantity.unit);
    if (unit.dimension != units::Dimension{.time = 1000}) throw std::invalid_argument("is no time");
    return units::to_internal(quantity.number, unit);
  } catch (const std::invalid_argument& fault) {
    throw UsageError(
        fmt::format("--panel: \"{}\": {}; an example: --panel \"0 h, 1 h, 3 h, 6 h\"", text, fault.what()));
  }
}

std::vector<std::vector<Vec2>> paths_until(const run::FinishedRun& run, double t) {
  std::vector<std::vector<Vec2>> paths;
  for (const CellResult& cell : run.cells) {
    paths.emplace_back();
    for (const TrackRow& row : cell.rows)
      if (row.t <= t) paths.back().push_back(row.centre);
  }
  return paths;
}

} // namespace

std::vector<std::size_t> frames_at(const run::FinishedRun& run, const std::string& times) {
  const std::vector<observe::Frame>& frames = run.film.frames;
  std::vector<std::size_t> chosen;
  std::istringstream list(times);
  for (std::string text; std::getline(list, text, ',');) {
    const std::size_t begin = text.find_first_not_of(' ');
    text = begin == std::string::npos ? std::string() : text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
    const double t = time_of(text);
    const auto nearest =
        std::ranges::min_element(frames, {}, [&](const observe::Frame& f) { return std::abs(f.t - t); });
    if (std::abs(nearest->t - t) > 0.5 * run.p.output.field_interval + 1.0)
      throw UsageError(fmt::format("--panel: there is no frame at {}: the frames of {} are from {} to {}, {} apart",
                                   text, run.folder.string(), time_text(frames.front().t), time_text(frames.back().t),
                                   time_text(run.p.output.field_interval)));
    constexpr double same = 0.5; // a frame of a run that was stopped may be a step off [s]
    if (std::abs(nearest->t - t) > same)
      print_warning(fmt::format("--panel: there is no frame at {}; the nearest one, at {}, is used", text,
                                time_text(nearest->t)));
    chosen.push_back(static_cast<std::size_t>(nearest - frames.begin()));
  }
  if (chosen.empty()) throw UsageError("--panel: names no time; an example: --panel \"0 h, 1 h, 3 h, 6 h\"");
  return chosen;
}

void export_panel(const run::FinishedRun& run, const std::vector<std::size_t>& frames, Layer layer,
                  const std::filesystem::path& folder) {
  const report::Limits limits = limits_of(run.film, layer);
  draw::FigureField field{.label = std::string(label_of(layer)),
                          .map = is_signed(layer) ? draw::ColourMap::diverging : draw::ColourMap::sequential,
                          .low = limits.low,
                          .high = limits.high,
                          .position = {},
                          .value = {}};
  std::vector<observe::CellScene> scenes;
  for (const std::size_t k : frames) {
    const observe::Frame& frame = run.film.frames[k];
    scenes.push_back(draw::frame_scene(run.film.head, frame, paths_until(run, frame.t)));
    field.position.push_back(draw::matrix_positions(run.film.head, frame));
    field.value.push_back(values_of(frame, layer));
  }
  write_file(folder / "panel.svg", draw::figure_panel(scenes, layer == Layer::degradation ? nullptr : &field));
}

} // namespace matrigrate::apps
