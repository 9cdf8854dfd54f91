#include "apps/export_pictures.hpp"

#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/time_text.hpp"
#include "draw/cell_picture.hpp"
#include "draw/plot.hpp"
#include "report/film_json.hpp"
#include "study_runs/child.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <system_error>
#include <thread>

namespace matrigrate::apps {

namespace {

constexpr int width = 900; // [pixel]

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

void call(const std::vector<std::string>& command) {
  study::Child child(command, STDERR_FILENO);
  std::optional<int> code;
  while (!(code = child.ended())) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  if (*code != 0) throw InputOutputError(fmt::format("{} ended with exit code {}", command.front(), *code));
}

struct LayerOf {
  Layer layer;
  std::string_view name, label;
  const io::Floats& (*of)(const io::Frame&); ///< two components of displacement, one of the others
};
constexpr std::array<LayerOf, 4> layers{{
    {Layer::displacement, "displacement", "displacement [um]",
     [](const io::Frame& f) -> const io::Floats& { return f.matrix.displacement; }},
    {Layer::von_mises, "von_mises", "von Mises stress [Pa]",
     [](const io::Frame& f) -> const io::Floats& { return f.matrix.von_mises; }},
    {Layer::pressure, "pressure", "pressure [Pa]",
     [](const io::Frame& f) -> const io::Floats& { return f.matrix.pressure; }},
    {Layer::fibre_von_mises, "fibre_von_mises", "von Mises stress of the fibres [Pa]",
     [](const io::Frame& f) -> const io::Floats& { return f.matrix.fibre_von_mises; }},
}};

const LayerOf& row_of(Layer layer) { return *std::ranges::find(layers, layer, &LayerOf::layer); }

/// A layer's value of each particle, NaN in the fluid.
std::vector<double> values_of(const io::Frame& frame, Layer layer) {
  const io::Floats& field = row_of(layer).of(frame);
  std::vector<double> values(frame.matrix.f_degr.size(), never);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (frame.matrix.f_degr[i] <= 0.0F) continue;
    values[i] = layer == Layer::displacement ? std::hypot(field[2 * i], field[2 * i + 1]) : field[i];
  }
  return values;
}

/// The range of a layer that all but one in a thousand values of the film lie in.
io::Limits limits_of(const io::Film& film, Layer layer) {
  if (layer != Layer::displacement) return io::usual_limits(film, row_of(layer).of);
  std::vector<double> all;
  for (const io::Frame& frame : film.frames)
    for (const double value : values_of(frame, layer))
      if (std::isfinite(value)) all.push_back(value);
  if (all.empty()) return {};
  const auto place = all.begin() + static_cast<std::ptrdiff_t>((all.size() - 1) * 999 / 1000);
  std::nth_element(all.begin(), place, all.end());
  return {0.0, *place > 0.0 ? *place : 1.0};
}

std::vector<Vec2> vectors(const io::Floats& x) {
  std::vector<Vec2> all;
  for (std::size_t i = 0; i + 1 < x.size(); i += 2) all.emplace_back(x[i], x[i + 1]);
  return all;
}

/// The line around each cell.
std::vector<std::vector<Vec2>> outlines(const io::OutlineFrame& outline) {
  const std::vector<Vec2> x = vectors(outline.x);
  std::vector<std::vector<Vec2>> all;
  auto first = x.begin();
  for (const std::size_t end : io::outline_ends(outline)) {
    const auto last = x.begin() + static_cast<std::ptrdiff_t>(end);
    all.emplace_back(first, last);
    first = last;
  }
  return all;
}

std::string picture(const FinishedRun& run, const io::Frame& frame, Layer layer, const io::Limits& limits) {
  io::Floats x = frame.matrix.displacement;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += run.film.head.reference[i];
  return io::to_svg({.title = time_text(frame.t),
                     .value_label = std::string(row_of(layer).label),
                     .position = vectors(x),
                     .value = values_of(frame, layer),
                     .particle_size = run.film.head.spacing,
                     .value_min = limits.low,
                     .value_max = limits.high,
                     .outlines = outlines(frame.outline)},
                    width);
}

/// A folder that is gone with all that is in it at the end of this object.
struct TemporaryFolder {
  explicit TemporaryFolder(const std::filesystem::path& in) {
    std::string name = (in / ".movie.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw InputOutputError(
          fmt::format("{}: cannot be written: {}", in.string(), std::generic_category().message(errno)));
    path = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  std::filesystem::path path;
};

} // namespace

Layer layer_of(const std::string& name) {
  const auto found = std::ranges::find(layers, name, &LayerOf::name);
  if (found != layers.end()) return found->layer;
  throw UsageError(fmt::format(
      "there is no layer \"{}\"; the layers are: displacement, von_mises, pressure, fibre_von_mises", name));
}

void require_layer(const FinishedRun& run, Layer layer) {
  for (const io::Frame& frame : run.film.frames)
    if (row_of(layer).of(frame).empty())
      throw UsageError(fmt::format("the run has no layer \"{}\": its matrix has no fibres", row_of(layer).name));
}

void require_tools(bool movie) {
  if (!is_installed("rsvg-convert"))
    throw InputOutputError("rsvg-convert is needed for pictures of pixels; Debian: apt-get install librsvg2-bin");
  if (movie && !is_installed("ffmpeg"))
    throw InputOutputError("ffmpeg is needed for a movie; Debian: apt-get install ffmpeg");
}

void export_svg(const FinishedRun& run, const std::filesystem::path& folder) {
  write_file(folder / "contact_sheet.svg", io::contact_sheet(run.memory.scenes));
  std::vector<io::Series> paths;
  for (const CellResult& cell : run.cells) {
    const bool single = run.cells.size() == 1;
    io::Series& path = paths.emplace_back();
    path.label = single ? "centre of mass" : fmt::format("cell {}", number_of(cell.cell));
    for (const TrackRow& row : cell.rows) {
      path.x.push_back(row.centre.x());
      path.y.push_back(row.centre.y());
    }
  }
  write_file(folder / "path.svg",
             io::to_svg(io::Plot{
                 .title = "Path", .x_label = "x [um]", .y_label = "y [um]", .series = paths, .equal_axes = true}));
}

void export_pictures(const FinishedRun& run, Layer layer, const std::filesystem::path& folder) {
  const io::Limits limits = limits_of(run.film, layer);
  for (std::size_t k = 0; k < run.film.frames.size(); ++k) {
    const std::string name = (folder / fmt::format("frame_{:04}", k)).string();
    write_file(name + ".svg", picture(run, run.film.frames[k], layer, limits));
    call({"rsvg-convert", "--output", name + ".png", name + ".svg"});
  }
}

void export_movie(const FinishedRun& run, Layer layer, const std::filesystem::path& folder) {
  const TemporaryFolder pictures(folder);
  export_pictures(run, layer, pictures.path);
  // with even sides, which H.264 wants
  call({"ffmpeg", "-loglevel", "error", "-y", "-framerate", "10", "-i", (pictures.path / "frame_%04d.png").string(),
        "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-pix_fmt", "yuv420p", (folder / "movie.mp4").string()});
}

} // namespace matrigrate::apps
