#include "parameters/read.hpp"

#include "fields/field.hpp"
#include "fields/file_words.hpp"
#include "fields/grids.hpp"
#include "parameters/assign.hpp"
#include "parameters/changes.hpp"
#include "parameters/document.hpp"
#include "parameters/laws/constants.hpp"
#include "parameters/nearest.hpp"
#include "parameters/schema.hpp"
#include "parameters/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace matrigrate {

namespace {

const std::string command_line = "--set";
constexpr std::string_view form_of_changes =
    "write [[changes]] and below it at = \"3 h\" and the parameters that change then";
constexpr std::string_view form_of_cells = "write [[cells]] and below it x and y, for each cell";
constexpr std::size_t max_changes = 1000;
constexpr std::size_t largest_file = std::size_t{1} << 20;
constexpr std::size_t longest_override = 4096;
const std::string all_constants = "laws.constants";

/// The key by which rules know a path: of a constant of the laws that of all, and so of a cell.
std::string rule_key(const std::string& path) {
  return path.starts_with("cells[") ? "cells" : constant_name(path).empty() ? path : all_constants;
}

/// Where a value was given.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// Where a time or a value of a change was given.
struct ChangePlace {
  std::string key; ///< "changes[1]."
  Place place;
};

/// Without a line on the command line.
Place place_of(const std::string& file, const toml::source_region& source) {
  if (file == command_line) return {file};
  return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

bool is_section(std::string_view path) {
  return std::ranges::any_of(sections(), [&](const Section& s) {
    return s.name == path || (s.name.starts_with(path) && s.name.substr(path.size()).starts_with('.'));
  });
}

/// Gathers values and faults, of files and overrides alike.
class Reader {
public:
  /// @param file  as it stands in faults
  Reader(const Parameters& defaults, std::string file)
      : m_parameters(defaults), m_start(defaults), m_faults(std::move(file)) {
    if (!m_parameters.grids) m_parameters.grids = std::make_shared<fields::Grids>();
  }

  void read_text(std::string_view text) {
    auto document = parse_document(text, m_faults.file());
    if (auto* fault = std::get_if<Fault>(&document)) return refuse(std::move(*fault));
    const toml::table& table = m_documents.emplace_back(std::move(std::get<toml::table>(document)));
    const toml::node* version = table.get("version"); // first, since what is unknown depends on it
    if (version != nullptr) take_version(*version, place_of(m_faults.file(), version->source()));
    m_resolved = version != nullptr || text.starts_with(resolved_head);
    if (m_resolved && m_faults.empty()) {
      const std::string writer = m_version.empty() ? std::string(last_without_key) : m_version;
      m_parameters.origin.version = has_this_model(writer) ? "" : writer;
    }
    if (is_study(table))
      return refuse({m_faults.file(), 0, 0, "",
                     fmt::format("is a study of many runs, and not a scenario; matrigrate study plan {0} shows what it "
                                 "takes, and matrigrate study run {0} computes it",
                                 m_faults.file())});
    visit(table, "", m_faults.file());
  }

  void override_with(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string key(trimmed(std::string_view(text).substr(0, equals)));
    const Place place{command_line};
    const auto complain = [&](const std::string& message) { add(place, excerpt(key, 80), message); };
    if (equals == std::string::npos || key.empty()) return complain("is not of the form key=value");
    if (text.size() > longest_override) return complain(fmt::format("is longer than {} characters", longest_override));
    const std::string value(trimmed(std::string_view(text).substr(equals + 1)));
    const std::string toml = "value = " + value;
    if (unreadable(toml, command_line)) return complain("is no text, or nested too deeply");
    try {
      const toml::table& table = m_documents.emplace_back(toml::parse(toml));
      if (const std::optional<Fault> fault = fault_of_texts(table, command_line)) return complain(fault->message);
      if (table.size() == 1) return take(key, *table.get("value"), place);
    } catch (const toml::parse_error&) { // not TOML: the bare form
    }
    take(key, toml::value<std::string>(value), place);
  }

  /// @param more  rules besides rules(); nothing: none are judged
  /// @throws ConfigurationError if there was any fault
  Parameters finish(const std::vector<std::string>& overrides, std::optional<std::span<const Rule>> more) {
    for (const std::string& text : overrides) override_with(text);
    if (!m_refused) follow();
    if (!m_refused && more) {
      check_cells();
      check_rules(rules());
      check_rules(*more);
      check_changes(*more);
      if (!more->empty()) check_gone();
    }
    m_faults.raise();
    return m_parameters;
  }

private:
  /// What the file means without saying it.
  void follow() {
    follow_earlier_version();
    follow_curvature_profile();
    follow_integrator();
    read_changes();
  }

  /// A resolved file without a key was written when there was no such key.
  void follow_earlier_version() {
    if (!m_resolved) return;
    for (const Gone& parameter : gone()) // the key `version` came later than these
      if (!parameter.before.empty() && m_version.empty() && !m_given.contains(parameter.path))
        keep_gone(parameter, std::string(parameter.before), {m_faults.file()});
    follow_laws();
    for (const Row& row : schema())
      if (row.before && !m_given.contains(row.path)) take_text(row.path, before_text(row, m_parameters));
  }

  /// A file with the one profile that is still read means its law, not today's default.
  void follow_curvature_profile() {
    const Row& law = *find_row("laws.curvature_factor");
    if (m_given.contains("actomyosin.curvature_profile") && !m_given.contains(law.path))
      take_text(law.path, before_text(law, m_parameters));
  }

  /// What parameters that have gone say is said by their laws, where the file does not give these; several biases are
  /// a product.
  void follow_laws() {
    std::map<std::string_view, std::string> laws;
    for (const Gone& parameter : gone()) {
      const auto said = m_gone.find(parameter.path);
      if (parameter.law.empty() || said == m_gone.end()) continue;
      std::string& law = laws[parameter.law];
      law += (law.empty() ? "" : "*") + *formula_of_gone(parameter, said->second);
    }
    for (const auto& [path, law] : laws)
      if (!m_given.contains(path)) take_text(path, fmt::format("\"{}\"", law));
  }

  /// Who computes is refused what the program does not compute any more.
  void check_gone() {
    for (const auto& [path, value] : m_parameters.origin.gone) {
      const auto given = m_given.find(path);
      add(given == m_given.end() ? Place{m_faults.file()} : given->second, path, gone_text(value, *find_gone(path)));
    }
  }

  /// A value in a file that a program wrote, of a parameter that has gone.
  void keep_gone(const Gone& parameter, std::string value, const Place& place) {
    if (value == parameter.left || parameter.is_drawing) return;
    if (parameter.law.empty())
      m_parameters.origin.gone.insert_or_assign(std::string(parameter.path), std::move(value));
    else if (formula_of_gone(parameter, value))
      m_gone.insert_or_assign(parameter.path, std::move(value));
    else
      complain(place, std::string(parameter.path), gone_text(value, parameter));
  }

  /// A usual step that nobody has named becomes that of the integrator.
  void follow_integrator() {
    const bool usual = m_start.run.time_step == usual_time_step(m_start.run.integrator);
    if (usual && !m_given.contains("run.time_step"))
      m_parameters.run.time_step = usual_time_step(m_parameters.run.integrator);
  }

  /// Nothing of the file was read.
  void refuse(Fault fault) {
    m_refused = true;
    m_faults.add(std::move(fault));
  }

  void add(const Place& place, std::string key, std::string message, FaultList::Hint hint = {}) {
    m_faults.add({place.file, place.line, place.column, std::move(key), std::move(message)}, std::move(hint));
  }

  /// @param path  within a change that of its parameter
  void complain(const Place& place, const std::string& path, std::string message, FaultList::Hint hint = {}) {
    const std::string key = m_within + path;
    m_blamed.insert(m_within.empty() ? rule_key(path) : key);
    add(place, excerpt(key, 80), std::move(message), std::move(hint));
  }

  void visit(const toml::table& table, const std::string& section, const std::string& file) {
    for (const auto& [name, node] : table) {
      const std::string key(name.str());
      const auto* nested = node.as_table();
      const std::string path = section.empty() ? key : fmt::format("{}.{}", section, key);
      const Place place = place_of(file, name.source());
      if (path == (m_within.empty() ? "version" : "at")) continue; // taken before
      if (find_row(path) != nullptr || find_gone(path) != nullptr || path == "cells" || path == "changes")
        take(path, node, place_of(file, node.source()));
      else if (nested != nullptr && is_section(path))
        visit(*nested, path, file);
      else if (is_section(path))
        complain(place, path,
                 fmt::format("is a section; write [{}] and its keys below, each on a line{}", path,
                             path == "cell" ? "; several cells are [[cells]], with x and y each" : ""));
      else
        unknown(path, nested != nullptr || node.is_array_of_tables(), place);
    }
  }

  void take_version(const toml::node& node, const Place& place) {
    const auto text = node.value_exact<std::string>();
    if (!text || text->empty() || text->size() > 40)
      return complain(place, "version",
                      fmt::format("is {}; a file that the program writes has its version there, such as \"{}\"",
                                  text ? "no version" : type_of(node), this_version));
    m_version = *text;
  }

  void unknown(const std::string& path, bool section, const Place& place) {
    const bool other = place.file == m_faults.file() && !m_version.empty() && m_version != this_version;
    complain(place, path,
             fmt::format("there is no such {}{}", section ? "section" : "parameter",
                         other ? fmt::format(" in version {}; the file was written by version {}", this_version,
                                             excerpt(m_version))
                               : ""),
             [path] { return parameter_hint(path); });
  }

  void take(const std::string& path, const toml::node& node, const Place& place) {
    if (path == "changes" || (path == "cells" && !m_within.empty())) return take_changes(path, node, place);
    if (path == "cells") return take_cells(node, place);
    const Row* row = find_row(path, m_parameters);
    const Gone* has_gone = find_gone(path);
    if (!m_within.empty() && path == all_constants && node.is_table()) { // a change sets one, and leaves the others
      for (const auto& [name, one] : *node.as_table())
        take(fmt::format("{}.{}", all_constants, name.str()), one, place_of(place.file, one.source()));
      return;
    }
    if (row == nullptr && !constant_name(path).empty())
      return complain(place, path, unknown_constant(path, m_parameters));
    if (row == nullptr && has_gone == nullptr) return unknown(path, false, place);
    m_given.insert_or_assign(m_within.empty() ? rule_key(path) : path, place);
    if (row != nullptr && !m_within.empty())
      if (std::string reason = fixed_in_run(*row, m_parameters); !reason.empty())
        return complain(place, path, std::move(reason));
    if (has_gone != nullptr) {
      if (m_resolved && m_within.empty() && place.file != command_line)
        return keep_gone(*has_gone, gone_value(node), place);
      if (std::string fault = fault_of_gone(*has_gone, node); !fault.empty()) complain(place, path, std::move(fault));
      return;
    }
    if (kind(*row) == Kind::constants && node.is_table()) return take_constants(*node.as_table(), place);
    std::string fault = assign(*row, given_by(node), m_parameters);
    if (fault.empty() && kind(*row) == Kind::field)
      fault = complete(*row, place.file == command_line ? "" : std::filesystem::path(place.file).parent_path());
    if (!fault.empty()) complain(place, path, std::move(fault));
  }

  /// What is wrong with the file that the text of a field names.
  std::string complete(const Row& field, const std::filesystem::path& folder) {
    std::string& text = std::get<Access<std::string>>(field.member)(m_parameters);
    if (std::string fault = complete_field(text, folder, *m_parameters.grids); !fault.empty()) return fault;
    const auto words = fields::file_words(text);
    const bool of_directions = words && words->options.contains("direction");
    return of_directions && field.unit != "deg"
               ? "direction= takes the direction of fibres from a picture, which is for fibres.field.direction_deg"
               : "";
  }

  /// All constants of the laws.
  void take_constants(const toml::table& table, const Place& place) {
    m_parameters.laws.constants.clear();
    for (const auto& [name, node] : table)
      if (std::string fault = define_constant(name.str(), node, m_parameters); !fault.empty())
        complain(place.file == command_line ? place : place_of(place.file, node.source()),
                 fmt::format("{}.{}", all_constants, name.str()), std::move(fault));
  }

  /// A value that the file means without saying it. @param value  as it stands in a scenario file
  void take_text(std::string_view path, const std::string& value) {
    take(std::string(path), *toml::parse("value = " + value).get("value"), {m_faults.file()});
  }

  /// [[cells]]; whether they have room, check_cells() tells.
  void take_cells(const toml::node& node, const Place& place) {
    m_given.insert_or_assign("cells", place);
    m_parameters.cells.clear();
    m_cell_places.clear();
    const toml::array* cells = array_at(node, "cells", form_of_cells, place);
    if (cells == nullptr) return;
    if (cells->empty())
      return complain(
          place, "cells",
          fmt::format("is empty; leave it out for one cell at cell.start_x, cell.start_y, or {}", form_of_cells));
    if (cells->size() > max_cells)
      return complain(place, "cells", fmt::format("has {} cells; allowed are 1 to {}", cells->size(), max_cells));
    for (std::size_t k = 0; k < cells->size(); ++k)
      if (const toml::table* table = table_at(*cells, k, "cells", form_of_cells, place.file))
        take_cell(*table, key_at("cells", k), place.file);
  }

  /// "cells[1]"
  static std::string key_at(std::string_view list, std::size_t k) { return fmt::format("{}[{}]", list, k + 1); }

  /// An array of tables; null, and a fault, if it is none.
  const toml::array* array_at(const toml::node& node, const std::string& path, std::string_view form,
                              const Place& place) {
    if (!node.is_array())
      complain(place, path, fmt::format("is {}, but an array of tables is expected; {}", type_of(node), form));
    return node.as_array();
  }

  /// One of them; the same.
  const toml::table* table_at(const toml::array& list, std::size_t k, std::string_view path, std::string_view form,
                              const std::string& file) {
    const toml::node& node = *list.get(k);
    if (!node.is_table())
      complain(place_of(file, node.source()), key_at(path, k),
               fmt::format("is {}, but a table is expected; {}", type_of(node), form));
    return node.as_table();
  }

  /// A cell, whose keys are those of cell_rows().
  void take_cell(const toml::table& table, const std::string& cell, const std::string& file) {
    Parameters one;
    std::vector<std::string> keys;
    for (const Row& row : cell_rows()) {
      const std::string& key = keys.emplace_back(key_of(row));
      const toml::node* node = table.get(key);
      std::string fault = node == nullptr ? fmt::format("has no {0}; write it like {0} = \"40 um\"", key)
                                          : assign(row, given_by(*node), one);
      if (!fault.empty())
        complain(place_of(file, (node == nullptr ? table : *node).source()),
                 node == nullptr ? cell : fmt::format("{}.{}", cell, key), std::move(fault));
    }
    for (const auto& [name, node] : table) {
      const std::string key(name.str());
      if (std::ranges::find(keys, key) != keys.end()) continue;
      const std::string hint = find_row("cell." + key) != nullptr
                                   ? fmt::format("; all cells are alike, with cell.{} of the section [cell]", key)
                                   : did_you_mean(nearest(key, keys));
      complain(place_of(file, name.source()), fmt::format("{}.{}", cell, excerpt(key, 60)),
               fmt::format("there is no such key; a cell has x and y{}", hint));
    }
    m_parameters.cells.push_back(one.cells.empty() ? CellStart{} : one.cells.front());
    m_cell_places.push_back(place_of(file, table.source()));
  }

  /// Keeps [[changes]] until all else is read: what they mean depends on it.
  void take_changes(const std::string& path, const toml::node& node, const Place& place) {
    if (!m_within.empty())
      return complain(place, path, "cannot stand in a change; write below `at` parameters with their new values");
    m_given.insert_or_assign(path, place);
    m_changes = array_at(node, path, form_of_changes, place);
    if (m_changes == nullptr) return;
    if (m_changes->size() <= max_changes) return;
    complain(place, path, fmt::format("has {} tables; allowed are up to {}", m_changes->size(), max_changes));
    m_changes = nullptr;
  }

  /// The tables in the order of their times, each set on what holds before it.
  void read_changes() {
    if (m_changes == nullptr) return;
    const std::string file = m_given.at("changes").file;
    std::multimap<double, std::size_t> order;
    for (std::size_t k = 0; k < m_changes->size(); ++k)
      if (const toml::table* table = table_at(*m_changes, k, "changes", form_of_changes, file))
        order.emplace(time_of_change(*table, key_at("changes", k), file), k);
    m_parameters.changes.clear();
    Parameters now = m_parameters;
    std::vector<TimedChange> changes;
    for (const auto& [at, k] : order) {
      m_within = key_at("changes", k) + ".";
      read_change(*m_changes->get(k)->as_table(), at, file, now, changes);
    }
    m_within.clear();
    m_parameters.changes = std::move(changes);
  }

  /// @return infinity, and a fault, if a table has no good time [s]
  double time_of_change(const toml::table& table, const std::string& key, const std::string& file) {
    const toml::node* at = table.get("at");
    Parameters one;
    std::string fault =
        at == nullptr ? "has no time; write it like at = \"3 h\"" : assign(change_time(), given_by(*at), one);
    if (fault.empty()) return one.changes.front().at;
    complain(place_of(file, (at == nullptr ? table : *at).source()), at == nullptr ? key : key + ".at",
             std::move(fault));
    return std::numeric_limits<double>::infinity();
  }

  /// @param now  what holds before the change, and then after it
  void read_change(const toml::table& table, double at, const std::string& file, Parameters& now,
                   std::vector<TimedChange>& changes) {
    const std::size_t faults = m_blamed.size();
    std::map<std::string, Place, std::less<>> given;
    std::swap(given, m_given);
    std::swap(now, m_parameters);
    visit(table, "", file);
    std::swap(now, m_parameters);
    std::swap(given, m_given);
    if (given.empty() && m_blamed.size() == faults)
      complain(place_of(file, table.source()), "at",
               "nothing changes then; write below it a parameter with its new value, such as "
               "ecm.youngs_modulus = \"100 Pa\"");
    for (const auto& entry : given) {
      const std::string& path = entry.first;
      const Place& place = entry.second;
      const Row* row = find_row(path, now);
      if (row == nullptr || m_blamed.contains(m_within + path) || !std::isfinite(at)) {
        m_blamed_later.insert(rule_key(path));
        continue;
      }
      const auto is_same = [&](const TimedChange& other) { return other.at == at && other.path == path; };
      if (std::ranges::any_of(changes, is_same))
        complain(place, path, "has two values at one time; leave one of them out");
      changes.push_back({at, path, value_text(*row, now)});
      m_change_places.push_back({m_within, place});
    }
    if (!std::isfinite(at)) return;
    m_times.push_back({at, {}, {}});
    m_time_places.push_back({m_within, place_of(file, table.get("at")->source())});
  }

  /// The faults of times, and the rules on the values from each of them on that these decide.
  void check_changes(std::span<const Rule> more) {
    const std::vector<TimedChange>& changes = m_parameters.changes;
    const auto blame = [&](const std::vector<ChangePlace>& places, std::size_t k, const std::string& key,
                           std::string message) { // those of a set of parameters have no place
      const ChangePlace given = k < places.size() ? places[k] : ChangePlace{"changes.", {}};
      add(given.place, given.key + key, std::move(message));
    };
    if (!m_blamed.contains("run.duration") && !m_blamed.contains("run.time_step")) {
      Parameters timed = m_parameters;
      if (!m_times.empty()) timed.changes = m_times;
      for (ChangeFault& fault : change_faults(timed))
        blame(m_time_places, fault.change, "at", std::move(fault.message));
    }
    Judgement judgement = m_judgement; // what rests on rules that are broken before is not judged
    std::size_t first = 0;
    for (const Period& period : periods(m_parameters)) {
      const auto later = std::find_if(changes.begin() + static_cast<std::ptrdiff_t>(first), changes.end(),
                                      [&](const TimedChange& c) { return c.at > period.from; });
      const auto end = static_cast<std::size_t>(later - changes.begin());
      for (const std::span<const Rule> which : {rules(), more})
        for (const Rule& rule : which) {
          std::size_t k = first;
          while (k < end && std::ranges::find(rule.keys, rule_key(changes[k].path)) == rule.keys.end()) ++k;
          if (k == end || m_broken.contains(rule.name)) continue;
          if (is_blamed(rule, m_blamed) || is_blamed(rule, m_blamed_later)) continue;
          const std::string fault = judgement(rule, period.p, [&](const Rule& r) { return r.broken(period.p); });
          if (fault.empty()) continue;
          blame(m_change_places, k, changes[k].path,
                fmt::format("from {} on: {}", period.when, said_of(rule, changes[k].path, fault)));
        }
      first = end;
    }
  }

  /// Only where each single value is good, as check_rules().
  void check_cells() {
    for (const std::string_view key : {"cells", "cell.radius", "ecm.radius", "contact.cells.repulsion_range"})
      if (m_blamed.contains(key)) return;
    if (m_cell_places.empty()) return;
    for (CellFault& fault : cell_faults(m_parameters))
      add(m_cell_places[fault.cell], key_at("cells", fault.cell), std::move(fault.message));
  }

  static bool is_blamed(const Rule& rule, const std::set<std::string, std::less<>>& keys) {
    return std::ranges::any_of(rule.keys, [&](std::string_view key) { return keys.contains(key); });
  }

  /// Only where each single value is good: otherwise the rule would judge a default that nobody chose.
  void check_rules(std::span<const Rule> which) {
    for (const Rule& rule : which) {
      const bool told = (rule.name == several_cells_rule && (!m_cell_places.empty() || m_blamed.contains("cells")))
                        || rule.name == change_rule; // by check_changes()
      if (told || is_blamed(rule, m_blamed)) continue;
      const std::string fault =
          m_judgement(rule, m_parameters, [this](const Rule& r) { return r.broken(m_parameters); });
      if (fault.empty()) continue;
      m_broken.insert(rule.name);
      const std::string key(key_to_blame(rule));
      const auto given = m_given.find(key);
      add(given == m_given.end() ? Place{} : given->second, key, said_of(rule, key, fault));
    }
  }

  /// The key of a broken rule that was chosen last: on the command line, else in the file, else the rule's first.
  std::string_view key_to_blame(const Rule& rule) const {
    if (rule.is_of_first && m_given.contains(rule.keys.front())) return rule.keys.front();
    std::string_view in_file;
    for (const std::string_view key : rule.keys) {
      const auto given = m_given.find(key);
      if (given == m_given.end()) continue;
      if (given->second.file == command_line) return key;
      if (in_file.empty()) in_file = key;
    }
    return in_file.empty() ? rule.keys.front() : in_file;
  }

  Parameters m_parameters;
  Parameters m_start; ///< before anything was given
  FaultList m_faults;
  bool m_refused = false;
  bool m_resolved = false; ///< the file holds every parameter of the version that wrote it
  std::string m_version;   ///< that wrote the file; empty if it does not say
  std::map<std::string, Place, std::less<>> m_given;
  std::map<std::string_view, std::string> m_gone; ///< what a resolved file says by parameters that laws have replaced
  std::vector<Place> m_cell_places;               ///< of the cells that were given
  std::set<std::string, std::less<>> m_blamed;    ///< keys with a fault of their own
  Judgement m_judgement;
  std::set<std::string, std::less<>> m_broken;       ///< names of rules that do not hold at the start
  std::deque<toml::table> m_documents;               ///< that were read
  const toml::array* m_changes = nullptr;            ///< the last [[changes]] of these
  std::string m_within;                              ///< "changes[1]." while that one is read
  std::vector<ChangePlace> m_change_places;          ///< of Parameters::changes, if they were given
  std::vector<TimedChange> m_times;                  ///< one of each table, whether its values can be read or not
  std::vector<ChangePlace> m_time_places;            ///< of these
  std::set<std::string, std::less<>> m_blamed_later; ///< paths with a fault of their own in a change
};

} // namespace

std::string complete_field(std::string& text, const std::filesystem::path& folder, fields::Grids& grids) {
  if (text.empty() || fields::names_one_file(text)) return {};
  try {
    text = fields::Field(text, folder, &grids).text();
  } catch (const std::invalid_argument& error) {
    return excerpt(error.what(), 300);
  } catch (const InputOutputError& error) {
    return excerpt(error.what(), 300);
  }
  return {};
}

Parameters read_parameters(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                           std::span<const Rule> more) {
  return parse_parameters(read_document(file, largest_file), file.string(), overrides, more);
}

Parameters read_unjudged(const std::filesystem::path& file) {
  Reader reader{Parameters{}, file.string()};
  reader.read_text(read_document(file, largest_file));
  return reader.finish({}, std::nullopt);
}

Parameters parse_parameters(std::string_view text, const std::string& name, const std::vector<std::string>& overrides,
                            std::span<const Rule> more) {
  Reader reader{Parameters{}, name};
  reader.read_text(text);
  return reader.finish(overrides, more);
}

Parameters apply_overrides(const Parameters& p, const std::vector<std::string>& overrides, std::span<const Rule> more) {
  return Reader{p, command_line}.finish(overrides, more);
}

} // namespace matrigrate
