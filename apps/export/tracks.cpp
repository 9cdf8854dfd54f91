#include "apps/export/exports.hpp"

#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/file.hpp"
#include "parameters/units.hpp"
#include "run/provenance.hpp"
#include "run/run_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace matrigrate::apps {

std::vector<std::string> items_of(const std::string& list) {
  std::vector<std::string> items;
  std::istringstream in(list.empty() ? list : list + ','); // so that nothing behind the last comma is a part, too
  for (std::string text; std::getline(in, text, ',');) {
    const std::size_t begin = text.find_first_not_of(' ');
    items.push_back(begin == std::string::npos ? std::string()
                                               : text.substr(begin, text.find_last_not_of(' ') + 1 - begin));
  }
  return items;
}

double time_of(const std::string& text) {
  if (text.empty()) throw std::invalid_argument("is no time: nothing stands between two commas, or behind the last");
  const units::Quantity quantity = units::parse_quantity(text);
  const bool zero = units::to_internal(quantity.number, units::parse_unit("1")) == 0.0;
  if (quantity.unit.empty() && !zero)
    throw std::invalid_argument(fmt::format("has no unit; write {0} s, {0} min or {0} h", quantity.number));
  const units::Unit unit = units::parse_unit(quantity.unit.empty() ? "s" : quantity.unit);
  if (unit.dimension != units::Dimension{.time = 1000}) throw std::invalid_argument("is no time");
  return units::to_internal(quantity.number, unit);
}

namespace {

constexpr std::string_view every = "every ";
constexpr std::string_view example = "an example: --times \"every 10 min\", or --times \"0 h, 1 h, 3 h\"";

/// The rows before the last time.
std::vector<TrackRow> without_last(std::vector<TrackRow> rows) {
  const double last = rows.back().t;
  std::erase_if(rows, [&](const TrackRow& row) { return row.t >= last; });
  return rows;
}

/// The day of "2026-01-31T12:00:00Z".
std::string day_of(const std::string& time) { return time.substr(0, 10); }

} // namespace

exchange::Times wanted_times(const std::string& text) {
  exchange::Times times;
  const bool regular = text.starts_with(every);
  std::vector<std::string> faults;
  for (const std::string& item : regular ? std::vector{text.substr(every.size())} : items_of(text)) try {
      const double t = time_of(item);
      if (t < 0.0 || (regular && t == 0.0)) throw std::invalid_argument(regular ? "is not above 0" : "is below 0");
      if (!times.list.empty() && t <= times.list.back())
        throw std::invalid_argument("does not come after the time before it");
      times.list.push_back(t);
    } catch (const std::invalid_argument& fault) {
      faults.push_back(fmt::format("\"{}\": {}", item, fault.what()));
    }
  if (!faults.empty()) throw UsageError(fmt::format("--times: {}; {}", fmt::join(faults, "; "), example));
  if (regular) times = {.every = times.list.front(), .list = {}};
  return times;
}

exchange::RunTracks single_run(const run::FinishedRun& run) {
  const std::string name = scenario_name(run.record, run.folder);
  return {.name = name, .condition = name, .replicate = 1, .seed = run.p.run.seed, .rows = run.memory.rows};
}

std::vector<exchange::RunTracks> at_times(std::vector<exchange::RunTracks> runs, const exchange::Times& times) {
  std::vector<std::string> faults;
  for (exchange::RunTracks& run : runs) try {
      run.rows = exchange::rows_at(run, times);
    } catch (const std::invalid_argument& fault) {
      faults.emplace_back(fault.what());
    }
  if (!faults.empty()) throw UsageError(fmt::format("--times: {}", fmt::join(faults, "\n")));
  return runs;
}

void write_tracks(const run::FinishedRun& run, const std::filesystem::path& to) {
  write_file(to / "tracks_celltrackr.csv", exchange::celltrackr_csv(run.memory.rows));
  std::vector<TrackRow> rows = run.memory.rows;
  const observe::EvenTimes times = observe::even_times(observe::times_of(rows));
  if (times.but_the_last()) {
    print_warning(fmt::format("the last position, at {:g} s, comes sooner than {:g} s after the one before it: the "
                              "files for TrackMate leave it out",
                              rows.back().t, times.interval));
    rows = without_last(rows);
  }
  write_file(to / "tracks_trackmate.csv", exchange::trackmate_csv(rows));
  if (times.is_even() || times.but_the_last())
    return write_file(to / "tracks_trackmate.xml", exchange::trackmate_xml(rows));
  print_warning(fmt::format("tracks_trackmate.xml is not written, and tracks_trackmate.csv has no FRAME: the positions "
                            "are {}, and TrackMate counts frames of one interval; {}",
                            times.text(), even_if("output.track_interval", run.p)));
}

std::vector<exchange::RunTracks> without_odd_ends(std::vector<exchange::RunTracks> runs) {
  std::size_t odd = 0, uneven = 0;
  for (exchange::RunTracks& run : runs) {
    const observe::EvenTimes times = observe::even_times(observe::times_of(run.rows));
    if (times.but_the_last()) {
      run.rows = without_last(run.rows);
      ++odd;
    } else if (!times.is_even()) {
      ++uneven;
    }
  }
  if (odd > 0)
    print_warning(fmt::format("the last positions of {} of {} runs come too soon after those before them: "
                              "tracks_spots.csv leaves them out",
                              odd, runs.size()));
  if (uneven > 0)
    print_warning(fmt::format("the positions of {} of {} runs are not evenly spaced: tracks_spots.csv has no FRAME, "
                              "which counts frames of one interval",
                              uneven, runs.size()));
  return runs;
}

std::string even_if(std::string_view interval, const Parameters& p) {
  return fmt::format("they are evenly spaced where {} is a multiple of run.time_step, {:g} s", interval,
                     p.run.time_step);
}

void write_openvt(const std::vector<exchange::RunTracks>& runs, exchange::OpenVtModel model,
                  const std::filesystem::path& to) {
  model.version = run::version_text();
  write_file(to / "openvt.csv", exchange::openvt_csv(runs));
  write_file(to / "openvt.json", exchange::openvt_record(model, runs));
  write_file(to / "openvt_simulator.json", exchange::openvt_simulator(model.version));
}

exchange::OpenVtModel openvt_model(const run::FinishedRun& run) {
  const std::string end = run::text_of(run.record, "end");
  return {.title = run::run_title(run.p, scenario_name(run.record, run.folder)),
          .version = {},
          .updated = day_of(end.empty() ? run::text_of(run.record, "start") : end),
          .base = run.p};
}

exchange::OpenVtModel openvt_model(const study::Study& study, const std::vector<study::Result>& results) {
  std::string last;
  for (const study::Result& result : results) last = std::max(last, result.standing.end);
  return {.title = study.title, .version = {}, .updated = day_of(last), .base = study.base};
}

} // namespace matrigrate::apps
