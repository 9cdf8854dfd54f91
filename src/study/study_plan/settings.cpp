#include "study_plan/settings.hpp"

#include "parameters/assign.hpp"
#include "parameters/laws/constants.hpp"
#include "parameters/nearest.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "parameters/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace matrigrate::study {

namespace {

constexpr std::string_view all_constants = "laws.constants";

bool is_section(std::string_view path) {
  return std::ranges::any_of(sections(), [&](const Section& s) { return s.name == path; });
}

void gather(const toml::table& table, const std::string& prefix, std::string_view section, std::string_view own,
            const Parameters& base, FaultList& faults, std::vector<Named>& found) {
  for (const auto& [name, node] : table) {
    const std::string path = prefix.empty() ? std::string(name.str()) : fmt::format("{}.{}", prefix, name.str());
    if (!own.empty() && path == own) continue;
    const std::string shown = fmt::format("{}.{}", section, path);
    const Row* row = find_row(path, base);
    if (path == "run.seed" || path == "run.threads")
      faults.add(name, shown,
                 path == "run.seed" ? "the seeds of the runs follow from the study's own `seed`"
                                    : "the runs of a study take one thread each, or what Slurm gives them");
    else if (path == "cells" || path == "changes")
      faults.add(name, shown, fmt::format("a study takes its {} from its scenario or preset", path));
    else if (node.is_table() && (is_section(path) || path == all_constants))
      gather(*node.as_table(), path, section, own, base, faults, found);
    else if (row != nullptr)
      found.push_back({row, &node});
    else if (!constant_name(path).empty())
      faults.add(name, shown, unknown_constant(path, base));
    else if (const Gone* has_gone = find_gone(path); has_gone != nullptr) {
      if (std::string fault = fault_of_gone(*has_gone, node); !fault.empty()) faults.add(name, shown, std::move(fault));
    } else
      faults.add(name, shown, "there is no such parameter", [path] { return parameter_hint(path); });
  }
}

/// The value that a point, or else its scenario, gives a parameter that has gone; the one that is left if neither does.
std::string value_in(const Gone& parameter, const toml::table& point, const toml::table& scenario) {
  if (const toml::node* node = point.get(parameter.path)) return gone_value(*node);
  const auto node = scenario.at_path(parameter.path);
  return node ? gone_value(*node.node()) : std::string(parameter.left);
}

/// The formula of a law with the values of a point; nothing if a value is none that any version knew.
std::optional<std::string> formula_of(std::string_view law, const toml::table& point, const toml::table& scenario) {
  std::string formula;
  for (const Gone& parameter : gone()) {
    if (parameter.law != law) continue;
    const std::string value = value_in(parameter, point, scenario);
    if (value == parameter.left) continue;
    const auto one = formula_of_gone(parameter, value);
    if (!one) return std::nullopt;
    formula += (formula.empty() ? "" : "*") + *one;
  }
  return formula.empty() ? std::string(*find_row(law)->before) : formula;
}

void say_by_laws(toml::table& point, const toml::table& scenario) {
  std::set<std::string_view> laws;
  for (const Gone& parameter : gone())
    if (!parameter.law.empty() && point.contains(parameter.path)) laws.insert(parameter.law);
  for (const std::string_view law : laws) {
    const auto formula = formula_of(law, point, scenario);
    if (!formula) continue; // the value is refused
    for (const Gone& parameter : gone())
      if (parameter.law == law) point.erase(parameter.path);
    point.insert(law, *formula);
  }
}

} // namespace

void complete_fields(toml::table& table, const std::filesystem::path& folder, fields::Grids& grids, FaultList& faults,
                     const std::string& prefix) {
  for (auto&& [name, node] : table) {
    const std::string path = prefix.empty() ? std::string(name.str()) : fmt::format("{}.{}", prefix, name.str());
    const auto complete = [&](toml::node& one) {
      if (toml::value<std::string>* text = one.as_string())
        if (std::string fault = complete_field(text->get(), folder, grids); !fault.empty())
          faults.add(one, path, std::move(fault));
    };
    const Row* row = find_row(path);
    if (row == nullptr && node.is_table() && is_section(path))
      complete_fields(*node.as_table(), folder, grids, faults, path);
    if (row == nullptr || kind(*row) != Kind::field) continue;
    complete(node);
    if (toml::array* list = node.as_array())
      for (toml::node& one : *list) complete(one);
  }
}

std::string without_folder(const std::string& value) {
  const std::size_t hash = value.find(" hash=");
  if (hash == std::string::npos) return value;
  std::string text = value.substr(0, hash);
  std::string lower = text;
  std::ranges::transform(lower, lower.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  std::size_t ending = 0;
  for (const char* known : {".csv", ".png", ".tif"})
    if (const std::size_t at = lower.rfind(known); at != std::string::npos) ending = std::max(ending, at);
  text = text.substr(text.rfind('/', ending) + 1); // npos + 1 is 0
  std::erase_if(text, [](char c) { return c == '"' || c == '\\'; });
  return text;
}

std::vector<Named> named_parameters(const toml::table& table, std::string_view section, std::string_view own,
                                    const Parameters& base, FaultList& faults) {
  std::vector<Named> found;
  gather(table, "", section, own, base, faults, found);
  const auto all = std::ranges::find(found, all_constants, [](const Named& n) { return n.row->path; });
  if (all != found.end()
      && std::ranges::any_of(found, [](const Named& n) { return !constant_name(n.row->path).empty(); })) {
    faults.add(*all->node, fmt::format("{}.{}", section, all_constants),
               "stands beside a constant alone; write each constant alone, or all of them in one text");
    found.erase(all);
  }
  std::ranges::sort(found, {}, [](const Named& n) { return Place(*n.node); });
  return found;
}

std::vector<Setting> meant(std::vector<Setting> settings, const Parameters& p) {
  for (Setting& s : settings) {
    if (!constant_name(s.key).empty()) s.key = all_constants;
    if (const Row* row = find_row(s.key); row != nullptr && section_of(*row) == "laws") s.value = meaning_text(*row, p);
  }
  std::ranges::sort(settings, {}, &Setting::key);
  settings.erase(std::unique(settings.begin(), settings.end()), settings.end()); // several constants
  return settings;
}

std::string meaning_of(const std::vector<Setting>& settings, const Parameters& p) {
  std::string text;
  for (const Setting& s : meant(settings, p)) text += fmt::format("{} = {}\n", s.key, s.value);
  return text;
}

bool overlap(std::string_view path, std::string_view other) {
  return path == other || (path == all_constants && !constant_name(other).empty())
         || (other == all_constants && !constant_name(path).empty());
}

std::optional<double> number_in_unit(const Row& row, Parameters p) { // NOLINT: members are asked of no const ones
  using Integer = int& (*)(Parameters&);
  if (const double* real = real_of(row, p)) return *real / units::to_internal(1.0, unit_of(row));
  if (const auto* integer = std::get_if<Integer>(&row.member)) return (*integer)(p);
  return std::nullopt;
}

std::optional<Setting> assigned(const Row& row, const toml::node& node, Parameters& p, FaultList& faults) {
  const std::string fault = assign(row, given_by(node), p);
  if (!fault.empty()) {
    faults.add(node, row.path, fault);
    return std::nullopt;
  }
  // constants as typed: an earlier version had its seeds from that
  return Setting{std::string(row.path),
                 kind(row) == Kind::constants ? in_quotes(node.value_or(std::string())) : value_text(row, p)};
}

bool is_written_out(std::string_view text) { return text.starts_with("# A study with all its points written out"); }

GoneValues follow_gone(toml::table& study, const toml::table& scenario) {
  GoneValues said;
  for (const std::string_view key : {"points", "conditions"}) {
    toml::array* list = study[key].as_array();
    if (list == nullptr) continue;
    list->for_each([&](toml::table& point) {
      if (key == "points")
        for (const Gone& parameter : gone())
          if (const toml::node* value = point.get(parameter.path))
            said[Place(point)].emplace(parameter.path, gone_value(*value));
      say_by_laws(point, scenario);
      if (key == "points")
        for (const Gone& parameter : gone())
          if (parameter.law.empty()) point.erase(parameter.path);
    });
  }
  return said;
}

} // namespace matrigrate::study
