#include "study_plan/track_keys.hpp"

#include "parameters/assign.hpp"
#include "parameters/document.hpp"
#include "parameters/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace matrigrate::study {

namespace {

/// "interval = S", "columns = \"track=NAME\""; "interval".
std::string as_key(std::string_view option, std::string_view value) {
  std::string name(option);
  std::ranges::replace(name, '-', '_');
  if (value.empty()) return name;
  const bool text = name == "columns" || name == "time_unit" || name == "splits" || name == "layout";
  return text ? fmt::format("{} = \"{}\"", name, value) : fmt::format("{} = {}", name, value);
}

/// Reads the keys of one table.
class TrackKeys {
public:
  TrackKeys(const toml::table& table, const std::string& section, FaultList& faults)
      : m_table(table), m_section(section), m_faults(faults) {}

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
      m_faults.add(node != nullptr ? place_of(*node) : place_of(m_table), key(name), fault.substr(name.size() + 2));
    }
    return options;
  }

private:
  std::string key(std::string_view name) const { return fmt::format("{}.{}", m_section, name); }

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
      m_faults.add(place_of(*node), key(name), fmt::format("\"{}\": {}", excerpt(text->get()), fault.what()));
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
      m_faults.add(place_of(node), key("columns"), fault.what());
    }
  }

  const toml::table& m_table;
  const std::string& m_section;
  FaultList& m_faults;
};

} // namespace

const std::vector<std::string>& track_keys() {
  static const std::vector<std::string> keys{"pixel",  "interval", "time_unit",   "columns", "layout",
                                             "splits", "jitter",   "recalibrate", "shortest"};
  return keys;
}

tracks::TrackOptions read_track_keys(const toml::table& table, const std::string& section, FaultList& faults) {
  return TrackKeys(table, section, faults).options();
}

} // namespace matrigrate::study
