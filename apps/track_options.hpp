#pragma once

#include "tracks/options.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

/// The options that say how a file of measured tracks is to be read. Test: tests/apps/tracks_test.cpp
namespace matrigrate::apps {

/// What was typed.
struct TrackArguments {
  std::string pixel;
  std::string interval;
  std::vector<std::string> columns;
  std::string splits = "refuse";
  tracks::TrackOptions options; ///< those that need no reading
};

/// Adds --pixel, --interval, --time-unit, --columns, --layout, --splits and --jitter to a verb.
void add_track_options(CLI::App& verb, TrackArguments& arguments);

/// "--interval S", "--columns \"track=NAME\"", "--drift".
std::string as_option(std::string_view option, std::string_view value);

/// @throws UsageError with what is wrong with them
tracks::TrackOptions track_options(const TrackArguments& arguments, const tracks::Wording& wording = as_option);

/// A length [um] or a time [s] with or without its unit: "0.65", "650 nm", "2 min".
/// @param unit  "um" or "s"
/// @throws UsageError naming the option
double quantity_option(const std::string& text, const std::string& option, const std::string& unit);

} // namespace matrigrate::apps
