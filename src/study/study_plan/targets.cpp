#include "parameters/assign.hpp"
#include "parameters/document.hpp"
#include "parameters/nearest.hpp"
#include "parameters/units.hpp"
#include "statistics/sample.hpp"
#include "study_plan/read_study.hpp"
#include "tables/cell_tracks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace matrigrate::study {

namespace {

/// How a file of tracks is to be read, beside `tracks = "FILE"`.
const std::vector<std::string> track_keys{"pixel",  "interval", "time_unit",   "columns", "layout",
                                          "splits", "jitter",   "recalibrate", "shortest"};

/// "interval = S", "columns = \"track=NAME\""; "interval".
std::string as_key(std::string_view option, std::string_view value) {
  std::string name(option);
  std::ranges::replace(name, '-', '_');
  if (value.empty()) return name;
  const bool text = name == "columns" || name == "time_unit" || name == "splits" || name == "layout";
  return text ? fmt::format("{} = \"{}\"", name, value) : fmt::format("{} = {}", name, value);
}

/// Reads these keys of a table.
class TrackKeys {
public:
  TrackKeys(const toml::table& table, FaultList& faults) : m_table(table), m_faults(faults) {}

  tracks::TrackOptions options() {
    tracks::TrackOptions options;
    options.wording = as_key;
    options.shortest = 2; // also of the copy in the folder of the study, which has all tracks that count
    options.pixel = quantity("pixel", "um");
    options.interval = quantity("interval", "s");
    if (const auto* node = m_table.get("time_unit")) options.time_unit = m_faults.text(*node, key("time_unit"));
    if (const auto* node = m_table.get("layout")) options.layout = m_faults.text(*node, key("layout"));
    if (const auto* node = m_table.get("columns")) read_columns(*node, options.columns);
    if (const auto* node = m_table.get("splits"))
      options.splits = static_cast<tracks::Splits>(m_faults.choice(*node, key("splits"), {"refuse", "cut", "drop"}));
    if (const auto* node = m_table.get("jitter"))
      options.jitter = m_faults.number(*node, key("jitter")).value_or(options.jitter);
    if (const auto* node = m_table.get("recalibrate")) m_faults.flag(*node, key("recalibrate")); // of 0.3.0
    if (const auto* node = m_table.get("shortest"))
      options.shortest = m_faults.whole(*node, key("shortest"), 2, 1'000'000);
    for (const std::string& fault : tracks::faults_of(options)) {
      const std::string name = fault.substr(0, fault.find(": "));
      const toml::node* node = m_table.get(name);
      m_faults.add(node != nullptr ? *node : m_table, key(name), fault.substr(name.size() + 2));
    }
    return options;
  }

private:
  static std::string key(std::string_view name) { return fmt::format("targets.{}", name); }

  /// A number in this unit, or a string with its own.
  std::optional<double> quantity(const std::string& name, const std::string& unit) {
    const toml::node* node = m_table.get(name);
    if (node == nullptr) return std::nullopt;
    const auto* text = node->as_string();
    if (text == nullptr) return m_faults.number(*node, key(name));
    try {
      const units::Quantity quantity = units::parse_quantity(text->get());
      const units::Unit own = units::parse_unit(quantity.unit.empty() ? unit : quantity.unit);
      if (own.dimension != units::parse_unit(unit).dimension)
        throw std::invalid_argument(fmt::format("is {}; write it in {}", units::to_string(own.dimension), unit));
      return units::to_internal(quantity.number, own);
    } catch (const std::invalid_argument& fault) {
      m_faults.add(*node, key(name), fmt::format("\"{}\": {}", excerpt(text->get()), fault.what()));
      return std::nullopt;
    }
  }

  /// columns = {track = "Track n°", x = "X"}, or "track=Track n°,x=X".
  void read_columns(const toml::node& node, tracks::ColumnNames& names) {
    const toml::table* table = node.as_table();
    try {
      if (table == nullptr) return tracks::add_columns(m_faults.text(node, key("columns")), names);
      for (const auto& [name, value] : *table)
        tracks::add_columns(fmt::format("{}={}", std::string_view(name.str()), m_faults.text(value, key("columns"))),
                            names);
    } catch (const std::invalid_argument& fault) {
      m_faults.add(node, key("columns"), fault.what());
    }
  }

  const toml::table& m_table;
  FaultList& m_faults;
};

class TargetReader {
public:
  TargetReader(const std::vector<Condition>& conditions, std::filesystem::path folder, FaultList& faults)
      : m_faults(faults), m_folder(std::move(folder)), m_readouts(all_readouts()), m_labels(all_labels(conditions)) {}

  Target read(const toml::table& table) {
    std::vector<std::string> keys{"readout", "value", "low", "high", "error", "weight", "at", "tracks"};
    keys.insert(keys.end(), track_keys.begin(), track_keys.end());
    m_faults.check_keys(table, "targets", keys);
    Target target;
    if (const auto* node = m_faults.wanted(table, "targets", "readout", "; write readout = \"v_migr_abs_um_per_h\""))
      target.readout = readout(*node);
    if (const auto* node = table.get("tracks"))
      read_tracks(*node, table, target);
    else
      read_value(table, target);
    if (const auto* node = table.get("weight")) target.weight = positive(*node, "targets.weight");
    if (const auto* node = table.get("at")) target.at = conditions(*node);
    check_twins(target, Place(table));
    return target;
  }

private:
  std::string readout(const toml::node& node) {
    const auto* typed = node.as_string();
    const std::size_t found = m_faults.choice(node, "targets.readout", m_readouts);
    return typed != nullptr && typed->get() == m_readouts[found] ? typed->get() : std::string();
  }

  void read_value(const toml::table& table, Target& target) {
    for (const std::string& key : track_keys)
      if (const auto* node = table.get(key))
        m_faults.add(*node, fmt::format("targets.{}", key),
                     "tells how tracks are read; there are none: write tracks = \"FILE\"");
    read_range(table, target);
    if (const auto* node =
            m_faults.wanted(table, "targets", "error", "; write error = 1.0, the standard error of what was measured"))
      target.error = positive(*node, "targets.error");
  }

  /// Mean and standard error over measured tracks.
  void read_tracks(const toml::node& node, const toml::table& table, Target& target) {
    for (const char* key : {"value", "low", "high", "error"})
      if (const auto* other = table.get(key))
        m_faults.add(*other, fmt::format("targets.{}", key), "stands beside tracks, which tell it");
    const std::string name = m_faults.text(node, "targets.tracks");
    if (name.empty() || target.readout.empty()) return;
    if (std::ranges::find(tracks::readouts_of_tracks(), target.readout) == tracks::readouts_of_tracks().end())
      return m_faults.add(
          node, "targets.tracks",
          fmt::format("tell no {}; they tell {}", target.readout, fmt::join(tracks::readouts_of_tracks(), ", ")));
    const auto tracks = tracks_of(m_folder / name, node, table, target);
    if (tracks == nullptr) return;
    target.tracks = tracks;
    std::vector<double> values;
    for (const tracks::CellTrack& track : *tracks) values.push_back(tracks::readout_of(track, target.readout));
    const statistics::Moments m = statistics::moments(statistics::finite(values));
    target.low = target.high = m.mean;
    target.error = m.sd / std::sqrt(static_cast<double>(m.n));
    if (m.n < 2)
      m_faults.add(node, "targets.tracks",
                   fmt::format("{} of {} tracks of \"{}\" have a {}: it may need longer tracks or a shorter interval",
                               m.n, values.size(), excerpt(name), target.readout));
    else if (!(target.error > 1e-9 * std::abs(m.mean))) // rounding is no scatter
      m_faults.add(node, "targets.tracks",
                   fmt::format("all tracks of \"{}\" have the same {}", excerpt(name), target.readout));
  }

  /// The tracks of a file, read once for each way in which it is to be read; null, and faults, if it cannot be.
  MeasuredTracks tracks_of(const std::filesystem::path& file, const toml::node& node, const toml::table& table,
                           Target& target) {
    std::ostringstream keys; // that tell how it is to be read
    for (const std::string& key : track_keys)
      if (const auto* given = table.get(key))
        given->visit([&](const auto& value) { keys << key << " = " << value << '\n'; });
    auto& tracks = m_tracks[{file, keys.str()}];
    if (tracks != nullptr) return tracks;
    try {
      FaultList wrong_keys(m_faults.file());
      tracks::TrackOptions options = TrackKeys(table, wrong_keys).options();
      wrong_keys.raise();
      // The copy in the folder of a study has been looked at for other movies, and its tracks all begin at 0.
      if (file.filename().string().starts_with("measured-")) options.columns.group.emplace_back("none");
      tracks = std::make_shared<const std::vector<tracks::CellTrack>>(
          tracks::measured_tracks(file, options, tracks::TracksFor::readouts, target.notes));
    } catch (const ConfigurationError& error) {
      m_faults.add(error.faults());
    } catch (const InputOutputError& error) {
      m_faults.add(node, "targets.tracks", error.what());
    }
    return tracks;
  }

  void read_range(const toml::table& table, Target& target) {
    const toml::node* value = table.get("value");
    const toml::node* low = table.get("low");
    const toml::node* high = table.get("high");
    if (value != nullptr && (low != nullptr || high != nullptr))
      return m_faults.add(*value, "targets.value",
                          "is given together with a range; a target is either a value or a range");
    if (value != nullptr) {
      target.low = target.high = measured(*value, "targets.value").value_or(0.0);
      return;
    }
    if (low == nullptr && high == nullptr)
      return m_faults.add(table, "targets.value", "is missing; write value = 12.1, or low and high of a range");
    if (low == nullptr || high == nullptr)
      return m_faults.add(table, low == nullptr ? "targets.low" : "targets.high",
                          "is missing; a range has low and high");
    const auto from = measured(*low, "targets.low");
    const auto to = measured(*high, "targets.high");
    if (!from || !to) return;
    if (!(*from < *to)) m_faults.add(*low, "targets.low", fmt::format("{} is not below high, {}", *from, *to));
    target.low = *from;
    target.high = *to;
  }

  std::optional<double> measured(const toml::node& node, std::string_view key, double least = -1e30) {
    constexpr double most = 1e30; // squares of quotients are numbers
    const auto value = m_faults.number(node, key);
    if (value && !(*value >= least && *value <= most))
      m_faults.add(node, key, fmt::format("{} is out of range; allowed are {} to {}", *value, least, most));
    return value;
  }

  double positive(const toml::node& node, std::string_view key) { return measured(node, key, 1e-30).value_or(1.0); }

  std::vector<std::size_t> conditions(const toml::node& node) {
    std::vector<std::size_t> at;
    const toml::array* list = node.as_array();
    if (list == nullptr) {
      if (const auto c = condition(node)) at.push_back(*c);
      return at;
    }
    if (list->empty()) m_faults.add(node, "targets.at", "is empty; leave it out for all conditions");
    for (const toml::node& label : *list) {
      const auto c = condition(label);
      const bool twice = c && std::ranges::find(at, *c) != at.end();
      if (twice) m_faults.add(label, "targets.at", fmt::format("\"{}\" is listed twice", excerpt(m_labels[*c])));
      if (c && !twice) at.push_back(*c);
    }
    return at;
  }

  std::optional<std::size_t> condition(const toml::node& node) {
    const auto* label = node.as_string();
    if (label == nullptr) {
      m_faults.add(node, "targets.at",
                   fmt::format("is {}, but the label of a condition, or a list of them, is expected", type_of(node)));
      return std::nullopt;
    }
    const auto found = std::ranges::find(m_labels, label->get());
    if (found != m_labels.end()) return static_cast<std::size_t>(found - m_labels.begin());
    const std::string known =
        m_labels.empty() ? "the study has no [[conditions]]" : fmt::format("the labels are {}", quoted_list(m_labels));
    m_faults.add(node, "targets.at",
                 fmt::format("\"{}\" is not the label of a condition; {}", excerpt(label->get()), known),
                 [typed = label->get(), labels = m_labels] { return did_you_mean(nearest(typed, labels)); });
    return std::nullopt;
  }

  /// A read-out has one target at a condition.
  void check_twins(const Target& target, Place place) {
    if (target.readout.empty()) return;
    std::vector<std::size_t> at = target.at;
    if (at.empty())
      for (std::size_t c = 0; c < std::max<std::size_t>(1, m_labels.size()); ++c) at.push_back(c);
    bool twice = false;
    for (const std::size_t c : at) twice = !m_seen.emplace(target.readout, c).second || twice;
    if (twice) m_faults.add(place, "targets", fmt::format("{} has two targets at the same condition", target.readout));
  }

  FaultList& m_faults;
  std::filesystem::path m_folder;
  /// By their files, and by the keys that tell how these are read.
  std::map<std::pair<std::filesystem::path, std::string>, MeasuredTracks> m_tracks;
  std::vector<std::string> m_readouts;
  std::vector<std::string> m_labels;
  std::set<std::pair<std::string, std::size_t>> m_seen;
};

} // namespace

std::vector<Target> read_targets(const toml::array& list, const std::vector<Condition>& conditions,
                                 const std::filesystem::path& folder, FaultList& faults) {
  std::vector<Target> all;
  TargetReader reader(conditions, folder, faults);
  for (const toml::node& node : list)
    if (const toml::table* table = faults.table(node, "targets")) all.push_back(reader.read(*table));
  return all;
}

std::vector<Target> read_target_file(const std::filesystem::path& file) {
  const toml::table document = table_of(read_document(file, largest_file), file.string());
  FaultList faults(file.string());
  std::vector<Target> all;
  if (const toml::array* list = document["targets"].as_array(); list == nullptr || list->empty())
    faults.add({}, "targets", "there are none; write [[targets]], and readout, value and error below");
  else
    all = read_targets(*list, {}, file.parent_path(), faults);
  faults.raise();
  return all;
}

double distance(const Target& target, double value) {
  return (value - std::clamp(value, target.low, target.high)) / target.error;
}

double distance(const std::vector<Target>& targets, const std::vector<double>& z) {
  double squares = 0.0;
  double weights = 0.0;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    squares += targets[k].weight * z[k] * z[k];
    weights += targets[k].weight;
  }
  return std::sqrt(squares / weights);
}

} // namespace matrigrate::study
