#include "tracks/options.hpp"

#include "parameters/document.hpp"
#include "parameters/nearest.hpp"
#include "tracks/layouts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace matrigrate::tracks {

namespace {

/// What a column may be named for, and where its name stands; a group may have several.
using Key = std::pair<std::string_view, std::string ColumnNames::*>;
constexpr Key column_keys[] = {{"track", &ColumnNames::track},
                               {"t", &ColumnNames::t},
                               {"frame", &ColumnNames::frame},
                               {"x", &ColumnNames::x},
                               {"y", &ColumnNames::y},
                               {"z", &ColumnNames::z},
                               {"group", nullptr},
                               {"made_up", &ColumnNames::made_up},
                               {"measured", &ColumnNames::measured}};

/// The key that stands at the start of a text, before "="; empty if none does.
std::string_view key_at(std::string_view text) {
  for (const auto& [key, place] : column_keys)
    if (text.starts_with(key) && text.substr(key.size()).starts_with('=')) return key;
  return {};
}

} // namespace

std::vector<std::pair<std::string, std::string>> column_pairs(std::string_view text) {
  std::vector<std::pair<std::string, std::string>> pairs;
  while (!text.empty()) {
    const std::string_view key = key_at(text);
    if (key.empty()) {
      const std::string typed(text.substr(0, text.find_first_of("=,")));
      std::vector<std::string> known;
      for (const auto& [name, place] : column_keys) known.emplace_back(name);
      throw std::invalid_argument(fmt::format("\"{}\" is no KEY=NAME; the keys are {}{}", excerpt(text),
                                              fmt::join(known, ", "), did_you_mean(nearest(typed, known))));
    }
    text.remove_prefix(key.size() + 1);
    std::size_t end = text.find(',');
    while (end != std::string_view::npos && end + 1 < text.size() && key_at(text.substr(end + 1)).empty())
      end = text.find(',', end + 1);
    pairs.emplace_back(key, text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return pairs;
}

void add_columns(std::string_view text, ColumnNames& names) {
  for (auto& [key, name] : column_pairs(text)) {
    if (name.empty()) throw std::invalid_argument(fmt::format("\"{}=\" names no column", key));
    const auto place = std::ranges::find(column_keys, std::string_view(key), &Key::first)->second;
    if (place == nullptr)
      names.group.push_back(std::move(name));
    else if (std::string& own = names.*place; own.empty())
      own = std::move(name);
    else
      throw std::invalid_argument(
          fmt::format("{} is named twice: \"{}\" and \"{}\"", key, excerpt(own), excerpt(name)));
  }
}

std::string as_record(std::string_view option, std::string_view value) {
  return fmt::format("{{{}{}{}}}", option, value.empty() ? "" : " ", value);
}

const std::vector<std::string>& time_units() {
  static const std::vector<std::string> units{"ms", "s", "min", "h", "d"};
  return units;
}

std::vector<std::string> layout_names() {
  std::vector<std::string> names;
  for (const Layout& layout : layouts())
    if (layout.name != "any") names.emplace_back(layout.name);
  return names;
}

std::vector<std::string> faults_of(const TrackOptions& options) {
  std::vector<std::string> faults;
  const auto positive = [&](const std::optional<double>& value, std::string_view name) {
    if (value && !(*value > 0.0 && *value <= 1e9))
      faults.push_back(
          fmt::format("{}: {:g} is out of range; allowed are numbers above 0 up to 1e9", options.say(name), *value));
  };
  const auto one_of = [&](const std::string& value, std::string_view name, const std::vector<std::string>& known) {
    if (!value.empty() && std::ranges::find(known, value) == known.end())
      faults.push_back(fmt::format("{}: there is no \"{}\"; there are {}{}", options.say(name), excerpt(value),
                                   fmt::join(known, ", "), did_you_mean(nearest(value, known))));
  };
  positive(options.pixel, "pixel");
  positive(options.interval, "interval");
  one_of(options.time_unit, "time-unit", time_units());
  one_of(options.layout, "layout", layout_names());
  if (!(options.jitter >= 0.0 && options.jitter < 0.5))
    faults.push_back(fmt::format("{}: {:g} is out of range; allowed is 0 to below 0.5 of the interval",
                                 options.say("jitter"), options.jitter));
  return faults;
}

std::vector<std::string> set_words(TrackOptions& options, const std::vector<std::string>& columns,
                                   std::string_view splits) {
  std::vector<std::string> faults;
  for (const std::string& one : columns) try {
      add_columns(one, options.columns);
    } catch (const std::invalid_argument& fault) {
      faults.push_back(fmt::format("{}: {}", options.say("columns"), fault.what()));
    }
  constexpr std::string_view ways[] = {"refuse", "cut", "drop"}; // in the order of Splits
  const auto* const way = std::ranges::find(ways, splits);
  options.splits = way == std::end(ways) ? Splits::refuse : static_cast<Splits>(way - ways);
  if (way == std::end(ways))
    faults.push_back(
        fmt::format("{}: there is no \"{}\"; there are refuse, cut and drop", options.say("splits"), excerpt(splits)));
  for (std::string& fault : faults_of(options)) faults.push_back(std::move(fault));
  return faults;
}

} // namespace matrigrate::tracks
