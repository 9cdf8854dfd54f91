#include "apps/export/other_programs.hpp"
#include "apps/shipped_pages.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/platform.hpp"
#include "base/process.hpp"
#include "report/run_page.hpp"
#include "run/folder_lock.hpp"
#include "run/provenance.hpp"
#include "run/run_record.hpp"
#include "store/field_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

namespace matrigrate::apps {

namespace {

std::filesystem::path drawing_folder(const std::filesystem::path& in) {
  std::filesystem::path folder = std::filesystem::absolute(in / ".drawing");
  if (std::filesystem::is_symlink(folder)) // what it leads to is not ours to remove
    throw InputOutputError(fmt::format("{}: is a symbolic link; remove it", folder.string()));
  make_folder(folder);
  return folder;
}

/// A folder that is gone with all that is in it at the end of this object. What an export has left in it whose process
/// was killed goes before.
struct Scratch {
  std::filesystem::path path; ///< with a folder `made` in it
  run::FolderLock lock;

  explicit Scratch(const std::filesystem::path& in)
      : path(drawing_folder(in)), lock(path, run::FolderLock::Kind::alone) {
    for (const auto& left : std::filesystem::directory_iterator(path))
      if (left.path().filename() != ".lock") std::filesystem::remove_all(left.path());
    std::filesystem::create_directory(path / "made");
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

/// Runs a program to its end.   @param log  what it says   @return its exit code
int exit_code_of(const std::vector<std::string>& command, const std::filesystem::path& log) {
  const int output = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, S_IRUSR | S_IWUSR);
  Child child(command, output >= 0 ? output : STDERR_FILENO);
  if (output >= 0) ::close(output);
  while (!child.ended()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return *child.ended();
}

/// The same.
/// @throws InputOutputError with the last line that it says, if it fails
void call(const std::vector<std::string>& command, const Scratch& scratch) {
  const std::filesystem::path log = scratch.path / "said.txt";
  const int code = exit_code_of(command, log);
  if (code == 0) return;
  std::ifstream said(log);
  std::string last = fmt::format("{} ended with exit code {}", command.front(), code);
  for (std::string line; std::getline(said, line);)
    if (!line.empty()) last = line;
  throw InputOutputError(last);
}

/// Moves what was made to a folder.
void move_made(const Scratch& scratch, const std::filesystem::path& to) {
  for (const auto& file : std::filesystem::directory_iterator(scratch.path / "made"))
    rename_file(file.path(), to / file.path().filename());
}

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

/// Where the package lies beside this program: in a clone, in the package itself, in an installed tree; empty if it
/// does not.
std::string package_place() {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::canonical(platform::this_program(), error).parent_path();
  for (const char* way :
       {"../../../python", "../..", "../lib/python3/dist-packages", "../../lib/python3/dist-packages"})
    if (std::filesystem::exists(folder / way / "matrigrate" / "exchange.py", error))
      return (folder / way).lexically_normal().string();
  return {};
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

std::string python_for(const PythonKinds& kinds) {
  if (!kinds.any()) return {};
  if (const std::string place = package_place(); !place.empty()) {
    const char* given = std::getenv("PYTHONPATH");
    const std::string known = given != nullptr && *given != '\0' ? std::string(":") + given : std::string();
    ::setenv("PYTHONPATH", (place + known).c_str(), 1);
  }
  const char* named = std::getenv("PYTHON");
  const std::vector<std::string> candidates = named != nullptr && *named != '\0'
                                                  ? std::vector<std::string>{named}
                                                  : std::vector<std::string>{"python3", "/usr/bin/python3"};
  const std::string needed = fmt::format("import matrigrate.exchange, h5py{}", kinds.ome_tiff ? ", tifffile" : "");
  for (const std::string& python : candidates)
    if (exit_code_of({python, "-P", "-B", "-c", needed}, "/dev/null") == 0) return python;
  throw InputOutputError(fmt::format(
      "{0} by Python, which needs the package matrigrate and its libraries; Debian: apt-get install "
      "python3-pandas python3-h5py python3-xxhash{1}; PYTHON names another Python",
      kinds.ome_tiff ? "--ome-tiff is made" : "--simularium is made", kinds.ome_tiff ? " python3-tifffile" : ""));
}

void export_by_python(const run::FinishedRun& run, const PythonKinds& kinds, const std::string& python,
                      const std::string& title, const std::filesystem::path& folder) {
  if (!kinds.any()) return;
  const Scratch scratch(folder);
  store::write_field_files(scratch.path, run.film, run::field_origin(run.p, {}));
  constexpr const char* script = "import sys; from matrigrate import exchange; sys.exit(exchange.main(sys.argv[1:]))";
  const std::string made = (scratch.path / "made").string();
  std::vector<std::string> command{python, "-P", "-B", "-c", script}; // -P: nothing from the working directory
  command.insert(command.end(), {fmt::format("--fields={}", (scratch.path / "fields.h5").string()),
                                 fmt::format("--title={}", title), fmt::format("--program={}", run::version_text())});
  if (kinds.pixel) command.push_back(fmt::format("--pixel={}", *kinds.pixel));
  if (kinds.ome_tiff) command.push_back(fmt::format("--ome-tiff={}/fields.ome.tif", made));
  if (kinds.simularium) command.push_back(fmt::format("--simularium={}/run.simularium", made));
  command.insert(command.end(), {"--", run.folder.string()});
  call(command, scratch);
  move_made(scratch, folder);
}

} // namespace matrigrate::apps
