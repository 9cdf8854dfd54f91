#include "apps/export/movie.hpp"

#include "apps/export/browser.hpp"
#include "apps/export/tools.hpp"
#include "apps/shipped_pages.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "store/base64.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <sstream>
#include <thread>
#include <vector>

namespace matrigrate::apps {

namespace {

constexpr double pace = 900.0;   ///< of a movie of default length [s of the run in a second]
constexpr std::size_t pages = 2; ///< that draw side by side
constexpr std::size_t ahead = 4; ///< pictures that are asked for before the first of them is there
constexpr double quality = 0.95; ///< of the pictures that go to the encoder

/// ffmpeg, which reads JPEG pictures from a pipe.
class Encoder {
public:
  Encoder(const std::filesystem::path& folder, const std::filesystem::path& movie, double fps)
      : m_pipe(folder / "pictures"), m_child({"ffmpeg",
                                              "-loglevel",
                                              "error",
                                              "-y",
                                              "-f",
                                              "image2pipe",
                                              "-c:v",
                                              "mjpeg",
                                              "-framerate",
                                              fmt::format("{}", fps),
                                              "-i",
                                              m_pipe.path(),
                                              "-c:v",
                                              "libx264",
                                              "-preset",
                                              "veryfast",
                                              "-crf",
                                              "18",
                                              "-vf",
                                              "scale=in_range=pc:out_range=tv:out_color_matrix=bt709,format=yuv420p",
                                              "-colorspace",
                                              "bt709",
                                              "-color_primaries",
                                              "bt709",
                                              "-color_trc",
                                              "bt709",
                                              "-color_range",
                                              "tv",
                                              "-movflags",
                                              "+faststart",
                                              movie},
                                             STDERR_FILENO) {}

  void add(std::string_view picture) {
    if (!m_pipe.write(picture, m_child)) throw InputOutputError("ffmpeg ended too early");
  }

  void finish() {
    if (!m_pipe.finish(m_child)) throw InputOutputError("ffmpeg ended too early");
    std::optional<int> code;
    while (!(code = m_child.ended())) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (*code != 0) throw InputOutputError(fmt::format("ffmpeg ended with exit code {}", *code));
  }

private:
  NamedPipe m_pipe;
  Child m_child;
};

/// The times of the pictures: from the first frame to the last [s].
std::vector<double> times_of(const run::FinishedRun& run, const MovieOptions& options) {
  const double first = run.film.frames.front().t;
  const double last = run.film.frames.back().t;
  const double seconds = options.seconds.value_or((last - first) / pace);
  const auto n = static_cast<std::size_t>(std::max(2.0, std::round(seconds * options.fps)));
  std::vector<double> times;
  for (std::size_t k = 0; k < n; ++k)
    times.push_back(first + (last - first) * static_cast<double>(k) / static_cast<double>(n - 1));
  return times;
}

/// The bytes of a picture that the page gives as the address of its data.
std::string bytes_of(const nlohmann::json& picture) {
  const auto address = picture.is_string() ? picture.get<std::string>() : std::string();
  constexpr std::string_view before = "data:image/jpeg;base64,";
  if (!address.starts_with(before)) throw InputOutputError("the page of the run has drawn no picture");
  return store::from_base64(std::string_view(address).substr(before.size()));
}

} // namespace

void set_size(MovieOptions& options, const std::string& text) {
  std::istringstream in(text);
  char by = ' ';
  const bool read = static_cast<bool>(in >> options.width >> by >> options.height) && by == 'x' && in.eof();
  const auto fits = [](int side) { return side >= 240 && side <= 4096 && side % 2 == 0; };
  if (!read || !fits(options.width) || !fits(options.height))
    throw UsageError(
        fmt::format("--size: \"{}\" is not a size; write two even numbers from 240 to 4096, such as 1280x720", text));
}

void require_movie_tools() {
  std::vector<std::string> missing;
  if (installed_browser().empty()) missing.emplace_back("chromium");
  if (!is_installed("ffmpeg")) missing.emplace_back("ffmpeg");
  if (missing.empty()) return;
  throw InputOutputError(fmt::format("{0} {1} needed for a movie; Debian: apt-get install {2}",
                                     fmt::join(missing, " and "), missing.size() > 1 ? "are" : "is",
                                     fmt::join(missing, " ")));
}

void export_movie(const run::FinishedRun& run, const MovieOptions& options, const std::filesystem::path& folder) {
  const TemporaryFolder temporary(folder);
  const std::filesystem::path page = temporary.path / "page.html";
  write_file(page, report_of(run, run_page_template()));
  Browser browser(installed_browser(), temporary.path);
  std::vector<Browser::Page> drawing;
  const nlohmann::json wanted{{"width", options.width},
                              {"height", options.height},
                              {"layer", std::string(name_of(options.layer))},
                              {"follow", options.follow}};
  const std::vector<double> times = times_of(run, options);
  for (std::size_t i = 0; i < std::min(pages, times.size()); ++i)
    drawing.push_back(browser.open(page, options.width, options.height));
  for (const Browser::Page& one : drawing)
    browser.answer(browser.ask(one, fmt::format("matrigrate.ready.then(() => matrigrate.show({}))", wanted.dump())));
  const std::filesystem::path movie = temporary.path / "movie.mp4";
  Encoder encoder(temporary.path, movie, options.fps);
  std::deque<Browser::Question> asked;
  for (std::size_t k = 0; k < times.size() + ahead; ++k) {
    if (k >= ahead && k - ahead < times.size()) {
      encoder.add(bytes_of(browser.answer(asked.front())));
      asked.pop_front();
    }
    if (k < times.size())
      asked.push_back(browser.ask(drawing[k % drawing.size()],
                                  fmt::format("matrigrate.frame({}).toDataURL('image/jpeg', {})", times[k], quality)));
  }
  encoder.finish();
  rename_file(movie, folder / "movie.mp4");
}

} // namespace matrigrate::apps
