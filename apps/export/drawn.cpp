#include "apps/export/exports.hpp"
#include "apps/shipped_pages.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "report/run_page.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <utility>

namespace matrigrate::apps {

namespace {

using nlohmann::json;

constexpr double pace = 900.0; ///< of a movie of default length [s of the run in a second]
constexpr std::array<std::string_view, 5> layers{"degradation", "displacement", "von_mises", "pressure",
                                                 "fibre_von_mises"};

std::pair<int, int> size_of(const std::string& text) {
  int width = 0;
  int height = 0;
  char by = ' ';
  std::istringstream in(text);
  const bool read = static_cast<bool>(in >> width >> by >> height) && by == 'x' && in.eof();
  const auto fits = [](int side) { return side >= 240 && side <= 4096 && side % 2 == 0; };
  if (!read || !fits(width) || !fits(height))
    throw UsageError(fmt::format("--size: \"{}\" is no size of a picture or movie; an example: 1280x720; allowed are "
                                 "even numbers from 240 to 4096",
                                 text));
  return {width, height};
}

bool is_installed(const std::string& program) {
  if (program.find('/') != std::string::npos) return ::access(program.c_str(), X_OK) == 0;
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

/// The browser to call: $CHROMIUM, or the first of chromium, chromium-browser and google-chrome that is installed;
/// empty if none is.
std::string installed_browser() {
  if (const char* named = std::getenv("CHROMIUM"); named != nullptr && *named != '\0') {
    if (is_installed(named)) return named;
    throw InputOutputError(fmt::format("CHROMIUM is {}, which is not a program; unset it, or name a browser", named));
  }
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
    if (is_installed(name)) return name;
  return {};
}

json movie(const run::FinishedRun& run, const DrawnOptions& options) {
  const double first = run.film.frames.front().t;
  const double last = run.film.frames.back().t;
  const double seconds = options.movie_seconds.value_or((last - first) / pace);
  return {{"first", first},
          {"last", last},
          {"count", std::max(2.0, std::round(seconds * options.fps))},
          {"fps", options.fps}};
}

/// Number and time of each frame.
json numbered(const run::FinishedRun& run, const std::vector<std::size_t>& frames) {
  json times = json::array();
  for (const std::size_t k : frames) times.push_back({k, run.film.frames[k].t});
  return times;
}

/// What viewer/drive.mjs is called with for one kind.
json job(const DrawnOptions& options, std::string_view layer, std::string_view kind, json what) {
  const auto [width, height] = size_of(options.size);
  return {{"show",
           {{"width", width},
            {"height", height},
            {"layer", options.layer.empty() ? layer : options.layer},
            {"whole", options.whole},
            {"follow", options.follow || (kind == "frames" && !options.whole)}}},
          {"scale", kind == "panel" ? 2 : 1}, // of its images of the matrix
          {kind, std::move(what)}};
}

/// Has viewer/drive.mjs do a job.
/// @throws InputOutputError with the last line that it says, if it fails
void drive(const Scratch& scratch, const json& job) {
  write_file(scratch.path / "job.json", job.dump());
  call({"node", scratch.path / "drive.mjs", scratch.path / "job.json"}, scratch);
}

} // namespace

void require_drawable(const run::FinishedRun& run, const DrawnOptions& options) {
  size_of(options.size);
  if (options.layer.empty()) return;
  std::vector<std::string_view> known(layers.begin(), layers.end());
  for (std::size_t k = 0; k < run.film.head.layers.size(); ++k)
    if (!run.film.head.layers[k].empty()) known.push_back(observe::matrix_layers()[k].layer);
  const auto diffuses = [](const observe::Frame& frame) { return !frame.matrix.attractant.empty(); };
  if (std::ranges::any_of(run.film.frames, diffuses)) known.emplace_back("attractant");
  if (std::ranges::find(known, options.layer) == known.end())
    throw UsageError(
        fmt::format("there is no layer \"{}\"; the layers are: {}", options.layer, fmt::join(known, ", ")));
  const auto lacks = [](const observe::Frame& frame) { return frame.matrix.fibre_von_mises.empty(); };
  if (options.layer == layers.back() && std::ranges::any_of(run.film.frames, lacks))
    throw UsageError(fmt::format("the run has no layer \"{}\": its matrix has no fibres", options.layer));
}

void require_drawing_tools(const DrawnKinds& kinds) {
  temporary_folder(); // the browser works there
  std::vector<std::string> missing;
  std::vector<std::string> packages;
  const auto need = [&](bool there, const std::string& program, const std::string& package) {
    if (there) return;
    missing.push_back(program);
    packages.push_back(package);
  };
  need(!installed_browser().empty(), "chromium", "chromium");
  need(is_installed("node"), "node", "nodejs");
  need(!kinds.movie || is_installed("ffmpeg"), "ffmpeg", "ffmpeg");
  if (missing.empty()) return;
  throw InputOutputError(fmt::format("{} {} needed for {}; Debian: apt-get install {}", fmt::join(missing, " and "),
                                     missing.size() > 1 ? "are" : "is",
                                     kinds.movie ? "a movie" : "pictures of the player", fmt::join(packages, " ")));
}

void export_drawn(const run::FinishedRun& run, const DrawnKinds& kinds, const DrawnOptions& options,
                  const std::filesystem::path& folder) {
  if (!kinds.any()) return;
  const Scratch scratch(folder);
  write_file(scratch.path / "drive.mjs", drive_script());
  write_file(scratch.path / "page.html", report::filled_page(run_page_template(), page_data(run)));
  std::vector<json> jobs;
  if (kinds.frames) jobs.push_back(job(options, "displacement", "frames", numbered(run, options.frames)));
  if (kinds.panel) jobs.push_back(job(options, "displacement", "panel", options.panel_times));
  if (kinds.movie) jobs.push_back(job(options, "degradation", "movie", movie(run, options)));
  for (json& one : jobs) {
    one.update({{"browser", installed_browser()}, {"folder", scratch.path}});
    drive(scratch, one);
  }
  move_made(scratch, folder);
}

} // namespace matrigrate::apps
