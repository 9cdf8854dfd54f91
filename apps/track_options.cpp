#include "apps/track_options.hpp"

#include "apps/verbs.hpp"
#include "parameters/document.hpp"
#include "parameters/units.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <string>

namespace matrigrate::apps {

void add_track_options(CLI::App& verb, TrackArguments& arguments) {
  tracks::TrackOptions& options = arguments.options;
  verb.add_option("--pixel", arguments.pixel,
                  "um per unit of length of the file of tracks, where it does not state um");
  verb.add_option("--interval", arguments.interval, "Time from frame to frame [s]");
  verb.add_option("--time-unit", options.time_unit,
                  "Unit of the column of time, where the file does not state it: ms, s, min, h or d");
  verb.add_option(
          "--columns", arguments.columns,
          "Which columns hold what, where the names are not known: KEY=NAME,... of track, t, frame, x, y, z, group "
          "(separates movies), made_up, measured; of a table without header their numbers from 1; may be repeated")
      ->allow_extra_args(false);
  verb.add_option(
      "--layout", options.layout,
      fmt::format("Take the names of columns of one program alone: {}", fmt::join(tracks::layout_names(), ", ")));
  verb.add_option("--splits", arguments.splits,
                  "Tracks with two positions at one time: refuse, cut (they end before) or drop (they are left out)");
  verb.add_option("--jitter", options.jitter, "By which a step of time may differ from the interval, as a share of it");
  verb.add_flag("--recalibrate")->group(""); // of 0.3.0: what is given counts now
}

double quantity_option(const std::string& text, const std::string& option, const std::string& unit) {
  try {
    const units::Quantity quantity = units::parse_quantity(text);
    const units::Unit own = units::parse_unit(quantity.unit.empty() ? unit : quantity.unit);
    const units::Unit wanted = units::parse_unit(unit);
    if (own.dimension != wanted.dimension)
      throw std::invalid_argument(fmt::format("is {}, but {} is expected", units::to_string(own.dimension),
                                              units::to_string(wanted.dimension)));
    return units::to_internal(quantity.number, own);
  } catch (const std::invalid_argument& fault) {
    throw UsageError(
        fmt::format("{}: \"{}\": {}; an example: {} \"120 {}\"", option, excerpt(text), fault.what(), option, unit));
  }
}

std::string as_option(std::string_view option, std::string_view value) {
  if (value.empty() || value == "true") return fmt::format("--{}", option);
  return option == "columns" ? fmt::format("--{} \"{}\"", option, value) : fmt::format("--{} {}", option, value);
}

tracks::TrackOptions track_options(const TrackArguments& arguments, const tracks::Wording& wording) {
  tracks::TrackOptions options = arguments.options;
  options.wording = wording;
  if (!arguments.pixel.empty()) options.pixel = quantity_option(arguments.pixel, "--pixel", "um");
  if (!arguments.interval.empty()) options.interval = quantity_option(arguments.interval, "--interval", "s");
  if (const auto faults = tracks::set_words(options, arguments.columns, arguments.splits); !faults.empty())
    throw UsageError(fmt::format("{}", fmt::join(faults, "\n")));
  return options;
}

} // namespace matrigrate::apps
