#include "apps/export/panel.hpp"

#include "apps/export/time_list.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/time_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace matrigrate::apps {

namespace {

/// A time of a list [s].
double panel_time(const std::string& text) {
  try {
    return time_of(text);
  } catch (const std::invalid_argument& fault) {
    throw UsageError(
        fmt::format("--panel: \"{}\": {}; an example: --panel \"0 h, 1 h, 3 h, 6 h\"", text, fault.what()));
  }
}

} // namespace

std::vector<double> frames_at(const run::FinishedRun& run, const std::string& times) {
  const std::vector<observe::Frame>& frames = run.film.frames;
  std::vector<double> chosen;
  for (const std::string& text : items_of(times)) {
    const double t = panel_time(text);
    const auto nearest =
        std::ranges::min_element(frames, {}, [&](const observe::Frame& f) { return std::abs(f.t - t); });
    if (std::abs(nearest->t - t) > 0.5 * run.p.output.field_interval + 1.0)
      throw UsageError(fmt::format("--panel: there is no frame at {}: the frames of {} are from {} to {}, {} apart",
                                   text, run.folder.string(), time_text(frames.front().t), time_text(frames.back().t),
                                   time_text(run.p.output.field_interval)));
    constexpr double same = 0.5; // a frame of a run that was stopped may be a step off [s]
    if (std::abs(nearest->t - t) > same)
      print_warning(
          fmt::format("--panel: there is no frame at {}; the nearest is taken, at {}", text, time_text(nearest->t)));
    chosen.push_back(nearest->t);
  }
  if (chosen.empty()) throw UsageError("--panel: names no time; an example: --panel \"0 h, 1 h, 3 h, 6 h\"");
  return chosen;
}

} // namespace matrigrate::apps
