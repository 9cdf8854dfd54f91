#include "parameters/read.hpp"

#include "fields/field.hpp"
#include "fields/file_words.hpp"
#include "fields/grids.hpp"
#include "parameters/assign.hpp"
#include "parameters/document.hpp"
#include "parameters/fault_list.hpp"
#include "parameters/gone.hpp"
#include "parameters/laws/constants.hpp"
#include "parameters/nearest.hpp"
#include "parameters/schema.hpp"
#include "parameters/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

namespace matrigrate {

namespace {

constexpr std::string_view form = "write [[cells]] and below it x and y, for each cell";

const Row* row_of(std::string_view key) {
  const auto row = std::ranges::find(cell_rows(), key, key_of);
  return row == cell_rows().end() ? nullptr : &*row;
}

std::vector<std::string> known_keys() {
  std::vector<std::string> keys;
  for (const Row& row : cell_rows()) keys.emplace_back(key_of(row));
  return keys;
}

void read_cell(const toml::table& table, const std::string& cell, CellsRead& read) {
  Parameters one;
  for (const auto& [name, node] : table) {
    const std::string key(name.str());
    const std::string path = fmt::format("{}.{}", cell, excerpt(key, 60));
    if (const Row* row = row_of(key)) {
      if (std::string fault = assign(*row, given_by(node), one); !fault.empty())
        read.faults.push_back({node.source(), path, std::move(fault)});
      continue;
    }
    const std::string hint = find_row("cell." + key) != nullptr
                                 ? fmt::format("; all cells are alike, with cell.{} of the section [cell]", key)
                                 : did_you_mean(nearest(key, known_keys()));
    read.faults.push_back({name.source(), path, fmt::format("there is no such key; a cell has x and y{}", hint)});
  }
  for (const Row& row : cell_rows())
    if (!table.contains(key_of(row)))
      read.faults.push_back(
          {table.source(), cell, fmt::format("has no {0}; write it like {0} = \"40 um\"", key_of(row))});
  read.starts.push_back(one.cells.empty() ? CellStart{} : one.cells.front());
  read.places.push_back(table.source());
}

} // namespace

std::string cell_key(std::size_t cell) { return fmt::format("cells[{}]", cell + 1); }

CellsRead read_cells(const toml::node& node) {
  CellsRead read;
  const auto refuse = [&](std::string message) {
    read.faults.push_back({node.source(), "cells", std::move(message)});
    return read;
  };
  const toml::array* cells = node.as_array();
  if (cells == nullptr)
    return refuse(fmt::format("is {}, but an array of tables is expected; {}", type_of(node), form));
  if (cells->empty())
    return refuse("is empty; leave it out for one cell at cell.start_x, cell.start_y, or " + std::string(form));
  if (cells->size() > max_cells)
    return refuse(fmt::format("has {} cells; allowed are 1 to {}", cells->size(), max_cells));
  for (std::size_t k = 0; k < cells->size(); ++k) {
    const toml::node& one = *cells->get(k);
    if (const toml::table* table = one.as_table())
      read_cell(*table, cell_key(k), read);
    else
      read.faults.push_back(
          {one.source(), cell_key(k), fmt::format("is {}, but a table is expected; {}", type_of(one), form)});
  }
  return read;
}

namespace {

/// True for a picture of which the directions are taken.
bool names_directions(const std::string& text) {
  const auto words = fields::file_words(text);
  return words && words->options.contains("direction");
}

constexpr std::size_t largest_file = std::size_t{1} << 20;
constexpr std::size_t longest_override = 4096;
const std::string command_line = "--set";
const std::string all_constants = "laws.constants";

/// Where a value was given.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

Place place_of(const std::string& file, const toml::source_region& source) {
  return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
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
    const auto& table = std::get<toml::table>(document);
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
    const std::string key = trimmed(text.substr(0, equals));
    const auto complain = [&](const std::string& message) {
      m_faults.add({command_line, 0, 0, excerpt(key, 80), message});
    };
    if (equals == std::string::npos || key.empty()) return complain("is not of the form key=value");
    if (text.size() > longest_override) return complain(fmt::format("is longer than {} characters", longest_override));
    const std::string value = trimmed(text.substr(equals + 1));
    const std::string toml = "value = " + value;
    if (unreadable(toml)) return complain("is no text, or nested too deeply");
    const Place place{command_line};
    try {
      const toml::table table = toml::parse(toml);
      if (const std::optional<Fault> fault = fault_of_texts(table, command_line)) return complain(fault->message);
      if (table.size() == 1) return take(key, *table.get("value"), place);
    } catch (const toml::parse_error&) { // not TOML: the bare form
    }
    take(key, toml::value<std::string>(value), place);
  }

  /// @throws ConfigurationError if there was any fault
  Parameters finish(std::span<const Rule> more) {
    if (!m_refused) {
      follow();
      check_cells();
      check_rules(rules());
      check_rules(more);
      if (!more.empty()) check_gone();
    }
    m_faults.raise();
    return m_parameters;
  }

  /// The same without rules.
  Parameters finish() {
    if (!m_refused) follow();
    m_faults.raise();
    return m_parameters;
  }

private:
  /// What the file means without saying it.
  void follow() {
    follow_earlier_version();
    follow_curvature_profile();
    follow_integrator();
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
    for (Fault& fault : faults_of_gone(m_parameters, m_faults.file())) {
      if (const auto given = m_given.find(fault.key); given != m_given.end())
        std::tie(fault.file, fault.line, fault.column) =
            std::tie(given->second.file, given->second.line, given->second.column);
      m_faults.add(std::move(fault));
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

  void complain(const Place& place, const std::string& key, std::string message, FaultList::Hint hint = {}) {
    m_blamed.insert(constant_name(key).empty() ? key : all_constants);
    m_faults.add({place.file, place.line, place.column, excerpt(key, 80), std::move(message)}, std::move(hint));
  }

  void visit(const toml::table& table, const std::string& section, const std::string& file) {
    for (const auto& [name, node] : table) {
      const std::string key(name.str());
      const auto* nested = node.as_table();
      const std::string path = section.empty() ? key : fmt::format("{}.{}", section, key);
      const Place place = place_of(file, name.source());
      if (path == "version") continue; // taken before
      if (find_row(path) != nullptr || find_gone(path) != nullptr || path == "cells")
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
    if (path == "cells") return take_cells(node, place);
    const Row* row = find_row(path, m_parameters);
    const Gone* has_gone = find_gone(path);
    if (row == nullptr && !constant_name(path).empty())
      return complain(place, path, unknown_constant(path, m_parameters));
    if (row == nullptr && has_gone == nullptr) return unknown(path, false, place);
    m_given.insert_or_assign(constant_name(path).empty() ? path : all_constants, place);
    if (has_gone != nullptr) {
      if (m_resolved && place.file != command_line) return keep_gone(*has_gone, gone_value(node), place);
      if (std::string fault = fault_of_gone(*has_gone, node); !fault.empty()) complain(place, path, std::move(fault));
      return;
    }
    if (kind(*row) == Kind::constants && node.is_table()) return take_constants(*node.as_table(), place);
    std::string fault = assign(*row, given_by(node), m_parameters);
    if (fault.empty() && kind(*row) == Kind::field)
      fault = complete_field(std::get<std::string& (*)(Parameters&)>(row->member)(m_parameters),
                             place.file == command_line ? "" : std::filesystem::path(place.file).parent_path(),
                             *m_parameters.grids);
    if (fault.empty() && kind(*row) == Kind::field && row->unit != "deg"
        && names_directions(std::get<std::string& (*)(Parameters&)>(row->member)(m_parameters)))
      fault = "direction= takes the direction of fibres from a picture, which is for fibres.field.direction_deg";
    if (!fault.empty()) complain(place, path, fault);
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

  void take_cells(const toml::node& node, const Place& place) {
    CellsRead read = read_cells(node);
    m_parameters.cells = std::move(read.starts);
    m_given.insert_or_assign("cells", place);
    m_cell_places.clear();
    const auto within = [&](const toml::source_region& source) {
      return place.file == command_line ? place : place_of(place.file, source);
    };
    for (const toml::source_region& source : read.places) m_cell_places.push_back(within(source));
    for (CellsRead::Fault& fault : read.faults) {
      m_blamed.insert("cells");
      complain(within(fault.place), fault.key, std::move(fault.message));
    }
  }

  /// Only where each single value is good, as check_rules().
  void check_cells() {
    for (const std::string_view key : {"cells", "cell.radius", "ecm.radius", "contact.cells.repulsion_range"})
      if (m_blamed.contains(key)) return;
    if (m_cell_places.empty()) return;
    for (CellFault& fault : cell_faults(m_parameters)) {
      const Place& place = m_cell_places[fault.cell];
      m_faults.add({place.file, place.line, place.column, cell_key(fault.cell), std::move(fault.message)});
    }
  }

  /// Only where each single value is good: otherwise the rule would judge a default that nobody chose.
  void check_rules(std::span<const Rule> which) {
    for (const Rule& rule : which) {
      const auto blamed = [&](std::string_view key) { return m_blamed.contains(key); };
      const bool told = rule.name == several_cells_rule && (!m_cell_places.empty() || m_blamed.contains("cells"));
      if (told || std::ranges::any_of(rule.keys, blamed)) continue;
      const std::string fault =
          m_judgement(rule, m_parameters, [this](const Rule& r) { return r.broken(m_parameters); });
      if (fault.empty()) continue;
      const std::string key(key_to_blame(rule));
      const auto given = m_given.find(key);
      const Place place = given == m_given.end() ? Place{} : given->second;
      m_faults.add({place.file, place.line, place.column, key, said_of(rule, key, fault)});
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
  Reader reader{Parameters{}, file.string()};
  reader.read_text(read_document(file, largest_file));
  for (const std::string& text : overrides) reader.override_with(text);
  return reader.finish(more);
}

Parameters read_unjudged(const std::filesystem::path& file) {
  Reader reader{Parameters{}, file.string()};
  reader.read_text(read_document(file, largest_file));
  return reader.finish();
}

Parameters parse_parameters(std::string_view text, const std::string& name, const std::vector<std::string>& overrides,
                            std::span<const Rule> more) {
  Reader reader{Parameters{}, name};
  reader.read_text(text);
  for (const std::string& text_of_override : overrides) reader.override_with(text_of_override);
  return reader.finish(more);
}

Parameters apply_overrides(const Parameters& p, const std::vector<std::string>& overrides, std::span<const Rule> more) {
  Reader reader{p, command_line};
  for (const std::string& text : overrides) reader.override_with(text);
  return reader.finish(more);
}

} // namespace matrigrate
