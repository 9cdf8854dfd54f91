#include "apps/export/panel.hpp"

#include "apps/export/time_list.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/time_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace matrigrate::apps {

namespace {

/// The frame nearest to a time. Warns where it is not at that time.
/// @throws UsageError if there is none nearby
std::size_t frame_at(const run::FinishedRun& run, double t, std::string_view option) {
  const std::vector<observe::Frame>& frames = run.film.frames;
  const auto nearest = std::ranges::min_element(frames, {}, [&](const observe::Frame& f) { return std::abs(f.t - t); });
  if (std::abs(nearest->t - t) > 0.5 * run.p.output.field_interval + 1.0)
    throw UsageError(fmt::format("{}: there is no frame at {}: the frames of {} are from {} to {}, {} apart", option,
                                 time_text(t), run.folder.string(), time_text(frames.front().t),
                                 time_text(frames.back().t), time_text(run.p.output.field_interval)));
  constexpr double same = 0.5; // a frame of a run that was stopped may be a step off [s]
  if (std::abs(nearest->t - t) > same)
    print_warning(fmt::format("{}: there is no frame at {}; the nearest is taken, at {}", option, time_text(t),
                              time_text(nearest->t)));
  return static_cast<std::size_t>(nearest - frames.begin());
}

} // namespace

std::vector<double> panel_times(const run::FinishedRun& run, const std::string& times) {
  constexpr std::string_view example = "an example: --panel \"0 h, 1 h, 3 h, 6 h\"";
  std::vector<double> chosen;
  for (const std::string& text : items_of(times)) try {
      chosen.push_back(run.film.frames[frame_at(run, time_of(text), "--panel")].t);
    } catch (const std::invalid_argument& fault) {
      throw UsageError(fmt::format("--panel: \"{}\": {}; {}", text, fault.what(), example));
    }
  if (chosen.empty()) throw UsageError(fmt::format("--panel: names no time; {}", example));
  return chosen;
}

std::vector<std::size_t> frames_at(const run::FinishedRun& run, const exchange::Times& times) {
  const std::vector<observe::Frame>& frames = run.film.frames;
  std::vector<double> wanted = times.list;
  if (times.every)
    for (std::size_t k = 0; static_cast<double>(k) * *times.every <= frames.back().t; ++k)
      wanted.push_back(static_cast<double>(k) * *times.every);
  std::vector<std::size_t> chosen;
  for (const double t : wanted) chosen.push_back(frame_at(run, t, "--times"));
  if (wanted.empty())
    for (std::size_t k = 0; k < frames.size(); ++k) chosen.push_back(k);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

} // namespace matrigrate::apps
