#include "parameters/write.hpp"

#include "parameters/changes.hpp"
#include "parameters/laws/constants.hpp"
#include "parameters/schema.hpp"
#include "parameters/version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace matrigrate {

namespace {

using Json = nlohmann::ordered_json;

/// Calls with_section(section) before, and with_row(row) for, the rows of each section.
template <class WithSection, class WithRow>
void for_each_section(const WithSection& with_section, const WithRow& with_row) {
  for (const Section& section : sections()) {
    with_section(section);
    for (const Row& row : schema())
      if (section_of(row) == section.name) with_row(row);
  }
}

/// "Young's modulus of the intact matrix (E); > 0 and <= 1e7 Pa"
std::string meaning(const Row& row) {
  const std::string symbol = row.symbol.empty() ? "" : fmt::format(" ({})", row.symbol);
  return fmt::format("{}{}; {}", description_of(row), symbol, allowed_text(row));
}

/// Whether a new scenario names the value, and does not only show it in a comment. A usual step is left to follow the
/// integrator.
bool is_open(const Row& row, const Parameters& p) {
  if (row.path == "run.time_step") return p.run.time_step != usual_time_step(p.run.integrator);
  return row.audience == Audience::usual || value_text(row, p) != value_text(row, {});
}

std::string assignment(const Row& row, const Parameters& p) {
  if (kind(row) == Kind::constants) return fmt::format("[{}]\n{}", row.path, constants_table(p));
  return fmt::format("{} = {}\n", key_of(row), value_text(row, p));
}

/// A string of a number and a unit; which unit, the program checks.
/// "20 1/nN" as well.
constexpr std::string_view quantity_pattern =
    R"(^\s*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?(\s*[^0-9\s.,].*|\s+1\s*/.*)$)";

Json number_schema(const Row& row) {
  const bool whole = kind(row) == Kind::integer;
  const auto bound = [whole](double value) { return whole ? Json(static_cast<std::int64_t>(value)) : Json(value); };
  return {{"type", whole ? "integer" : "number"},
          {row.range.low_allowed ? "minimum" : "exclusiveMinimum", bound(row.range.low)},
          {row.range.high_allowed ? "maximum" : "exclusiveMaximum", bound(row.range.high)}};
}

/// A constant of the laws: a number, or one with its range.
Json constant_schema() {
  const Json number{{"type", {"string", "number"}}};
  return {
      {"anyOf",
       {number,
        {{"type", "object"},
         {"additionalProperties", false},
         {"required", {"value"}},
         {"properties",
          {{"value", number}, {"range", {{"type", "array"}, {"items", number}, {"minItems", 2}, {"maxItems", 2}}}}}}}}};
}

Json type_schema(const Row& row) {
  switch (kind(row)) {
  case Kind::quantity:
  case Kind::angle:
    return {{"anyOf", {Json{{"type", "string"}, {"pattern", quantity_pattern}}, number_schema(row)}}};
  case Kind::ratio:
  case Kind::integer:
    return number_schema(row);
  case Kind::constants:
    return {{"type", {"string", "object"}}, {"additionalProperties", constant_schema()}};
  case Kind::law:
    return {{"type", {"string", "number"}}, {"x-law", true}};
  case Kind::choice: {
    const auto names = std::get<Choice>(row.member).names;
    return {{"enum", std::vector<std::string_view>(names.begin(), names.end())}};
  }
  default:
    return {{"type", kind(row) == Kind::field ? "string" : "boolean"}};
  }
}

Json row_schema(const Row& row) {
  const bool angle = kind(row) == Kind::angle;
  const std::string bare = angle || kind(row) == Kind::quantity
                               ? fmt::format(" A bare number is in {}{}.", row.unit,
                                             angle ? "; \"30 deg\", \"30°\" and \"0.5 rad\" are angles as well" : "")
                               : "";
  Json schema = type_schema(row);
  schema["description"] = fmt::format("{}. Default: {}.{}", meaning(row), row.source, bare);
  schema["default"] = Json::parse(value_text(row, {})); // all forms of value_text are JSON as well
  if (row.before)                                       // by a path, the value of that key
    schema["x-before"] = find_row(*row.before) != nullptr ? Json(*row.before) : Json::parse(before_text(row, {}));
  return schema;
}

/// The object of a section inside the schema of the file: "ecm.fibres" is a property of "ecm".
Json& section_schema(Json& file, std::string_view name) {
  Json* object = &file;
  while (!name.empty()) {
    const std::size_t dot = std::min(name.find('.'), name.size());
    Json& property = (*object)["properties"][std::string(name.substr(0, dot))];
    property["type"] = "object";
    property["additionalProperties"] = false;
    object = &property;
    name.remove_prefix(std::min(dot + 1, name.size()));
  }
  return *object;
}

/// [[cells]], an array of tables.
Json cells_schema() {
  Json table{{"type", "object"}, {"additionalProperties", false}};
  for (const Row& row : cell_rows()) {
    table["required"].push_back(key_of(row));
    table["properties"][std::string(key_of(row))] = row_schema(row);
  }
  return {{"type", "array"},
          {"description", cells_title},
          {"minItems", 1},
          {"maxItems", max_cells},
          {"items", std::move(table)}};
}

/// A table [[cells]] for each of several cells.
std::string cell_tables(const Parameters& p) {
  std::string text;
  Parameters one;
  for (const CellStart& start : p.cells) {
    one.cells.assign(1, start);
    text += "\n[[cells]]\n";
    for (const Row& row : cell_rows()) text += assignment(row, one);
  }
  return text;
}

/// [[changes]], an array of tables: its time, and what a section of a scenario may hold. The program says what cannot
/// change.
Json changes_schema() {
  Json table{{"type", "object"}, {"additionalProperties", false}, {"required", {"at"}}};
  table["properties"]["at"] = row_schema(change_time());
  for (const Section& section : sections())
    if (section.name.find('.') == std::string_view::npos && section.name != "run" && section.name != "output")
      table["properties"][std::string(section.name)] = {{"$ref", fmt::format("#/properties/{}", section.name)}};
  return {{"type", "array"}, {"description", changes_title}, {"items", std::move(table)}};
}

/// A table [[changes]] for each time of change.
std::string change_tables(const Parameters& p) {
  std::string text;
  for (const std::vector<std::string>& lines : lines_of_changes(p))
    text += fmt::format("\n[[changes]]\n{}\n", fmt::join(lines, "\n"));
  return text;
}

/// A source as the page of parameters has it: a table or section of the paper without the paper's name, nothing for
/// what was chosen for this program.
std::string_view short_source(std::string_view source) {
  constexpr std::string_view paper = "Heck et al. 2020, ";
  if (source == "this program") return {};
  return source.starts_with(paper) ? source.substr(paper.size()) : source;
}

/// Text of a cell of a table in Markdown.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped.append(c == '|' ? "\\" : "").push_back(c);
  return escaped;
}

} // namespace

std::string to_toml(const Parameters& p) {
  std::string text = fmt::format("{}version = \"{}\"\n", resolved_head, this_version);
  for_each_section([&](const Section& s) { text += fmt::format("\n# {}\n[{}]\n", s.title, s.name); },
                   [&](const Row& row) { text += fmt::format("# {}\n{}", meaning(row), assignment(row, p)); });
  return text + cell_tables(p) + change_tables(p);
}

std::string values_text(const Parameters& p) {
  std::string text;
  Parameters q = p;
  for (const Row& row : schema()) {
    if (counts(row, p))
      text += fmt::format("{} = {}\n", row.path,
                          row.unit == "rad" // as fingerprints have had it
                              ? fmt::format("{}", *real_of(row, q))
                              : meaning_text(row, p));
    for (const Gone& parameter : gone())
      if (parameter.behind == row.path) text += fmt::format("{} = {}\n", parameter.path, gone_value(parameter, p));
  }
  if (!p.cells.empty()) text += fmt::format("cells = {}\n", cells_text(p));
  const std::vector<Period> all = periods(p);
  auto period = all.begin();
  for (const TimedChange& change : p.changes) {
    while (std::next(period) != all.end() && std::next(period)->from <= change.at) ++period;
    text += fmt::format("from {} s: {} = {}\n", change.at, change.path,
                        meaning_text(*find_row(change.path, period->p), period->p));
  }
  return text;
}

std::string new_scenario(const Preset& preset, const std::string& schema) {
  if (!preset.text.empty()) return fmt::format("#:schema {}{}", schema, preset.text.substr(preset.text.find('\n')));
  const Parameters p = parameters_of(preset);
  std::string text =
      fmt::format("#:schema {}\n# {}.\n#\n"
                  "# A value has a unit: \"200 Pa\", \"0.2 kPa\", \"6 h\". A bare number is in the unit of the comment "
                  "above it.\n# A parameter that is left out or commented out has its default. Check the file with: "
                  "matrigrate check FILE\n",
                  schema, preset.description);
  Audience audience{};
  for_each_section(
      [&](const Section& s) {
        text += fmt::format("\n# ---- {} ----\n[{}]\n", s.title, s.name);
        audience = Audience::usual;
      },
      [&](const Row& row) {
        const bool open = is_open(row, p);
        if (audience != Audience::numerical && row.audience == Audience::numerical)
          text += "\n# Numerics; rarely changed.\n";
        audience = row.audience;
        text += fmt::format("# {}\n{}{}", meaning(row), open ? "" : "# ", assignment(row, p));
        if (kind(row) == Kind::constants && !open) text += "# F_c = \"0.1 nN\"\n"; // as an example
      });
  return text + cell_tables(p);
}

std::string json_schema() {
  Json file{{"$schema", "http://json-schema.org/draft-07/schema#"},
            {"title", "Matrigrate scenario"},
            {"type", "object"},
            {"additionalProperties", false}};
  for_each_section([&](const Section& s) { section_schema(file, s.name)["description"] = s.title; },
                   [&](const Row& row) {
                     section_schema(file, section_of(row))["properties"][std::string(key_of(row))] = row_schema(row);
                   });
  file["properties"]["cells"] = cells_schema();
  file["properties"]["changes"] = changes_schema();
  file["properties"]["version"] = {
      {"type", "string"},
      {"description", "In files that the program writes: its version. A parameter that such a file lacks has the value "
                      "that stands for what was done before there was such a parameter."}};
  for (const Gone& parameter : gone())
    file["x-gone"][std::string(parameter.path)] = {
        {"left", Json::parse(parameter.left)}, {"any", parameter.is_drawing}, {"fate", gone_text("{}", parameter)}};
  return file.dump(2) + "\n";
}

std::string parameters_markdown() {
  std::string text =
      "# Parameters\n\n"
      "Made from the table in `src/parameters/schema.cpp` by `matrigrate list --parameters`; do not edit.\n\n"
      "A quantity is a string with its unit: `youngs_modulus = \"200 Pa\"`. A bare number is in the unit of the "
      "column *allowed*. Times may be words and sums: `\"90 minutes\"`, `\"1 hour\"`, `\"6 h 30 min\"`. An angle is a "
      "string, `\"30 deg\"`, `\"30°\"` or `\"0.5 rad\"`, or a bare number in the unit that its meaning names. The "
      "decimal sign is a point.\n\n"
      "A file has at most 1 MiB, 50,000 dotted keys and brackets 32 deep. A syntax error of TOML is reported alone. "
      "All other faults are reported together, the first 200 of them in full.\n\n"
      "Fibres lie on bonds. A bond joins a matrix particle to a neighbour closer than 2 h. So `uniaxial` fibres have "
      "the directions of lattice bonds within `half_angle_deg` of `direction_deg`, not `direction_deg` itself. "
      "`matrigrate explain` prints their number and mean direction. A direction without any bond is refused. A "
      "hexagonal lattice with bonds exactly `half_angle_deg` off is refused too: such bonds would make the matrix "
      "stiff across its fibres.\n\n"
      "The first line of a scenario, `#:schema PATH`, names a JSON schema. Editors that know the line (Even Better "
      "TOML, taplo) complete and check the scenario with it. `matrigrate new FILE` names `scenario.schema.json` and "
      "writes it beside the file; `matrigrate new FILE --schema PATH` names another one and writes none. "
      "`scenarios/baseline.toml` names `docs/scenario.schema.json`. The line changes no result.\n\n"
      "*Table 1* and *Methods* mean Heck et al. 2020; a default without a source was chosen for this "
      "program.\n";
  for_each_section(
      [&](const Section& s) {
        text += fmt::format("\n## [{}] {}\n\n| key | default | allowed | symbol | meaning | source of the default |\n"
                            "|---|---|---|---|---|---|\n",
                            s.name, s.title);
      },
      [&](const Row& row) {
        text += fmt::format("| `{}` | `{}` | {} | {} | {} | {} |\n", key_of(row), value_text(row, {}),
                            cell(allowed_text(row)), cell(row.symbol), cell(description_of(row)),
                            cell(short_source(row.source)));
      });
  text += fmt::format("\n## [[cells]] {}\n\n"
                      "1 to {} tables. Their order numbers the cells, from 1. No key may be left out.\n\n"
                      "| key | allowed | meaning |\n|---|---|---|\n",
                      cells_title, max_cells);
  for (const Row& row : cell_rows())
    text += fmt::format("| `{}` | {} | {} |\n", key_of(row), cell(allowed_text(row)), cell(row.description));
  return text
         + fmt::format(
             "\n## [[changes]] {}\n\n"
             "Up to 1000 tables, in any order. Below `at` stand parameters as `section.key = value`; those of "
             "`[run]` and `[output]`, fields, and what the bodies are made with cannot change: "
             "[Parameters in time](how-to/treatment-in-time.md).\n\n"
             "| key | allowed | meaning |\n|---|---|---|\n| `at` | {} | {} |\n",
             changes_title, cell(allowed_text(change_time())), cell(change_time().description));
}

} // namespace matrigrate
