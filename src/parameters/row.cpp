#include "parameters/changes.hpp"
#include "parameters/laws/constants.hpp"
#include "parameters/laws/law_names.hpp"
#include "parameters/schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace matrigrate {

namespace {

/// Overloaded lambdas, to visit a Member with.
template <class... Cases>
struct Match : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Match(Cases...) -> Match<Cases...>;

std::string quantity_text(const Row& row, double value) {
  if (row.unit == "rad")
    if (const std::string degrees = units::from_internal(value, units::parse_unit("deg")); !degrees.empty())
      return fmt::format("\"{} deg\"", degrees);
  if (kind(row) != Kind::quantity) return fmt::format("{}", value);
  const std::string number = units::from_internal(value, units::parse_unit(row.unit));
  if (!number.empty()) return fmt::format("\"{} {}\"", number, row.unit);
  if (std::holds_alternative<OneConstant>(row.member)) { // um, s and nN hold every double
    const units::Unit internal{.dimension = units::parse_unit(row.unit).dimension};
    return fmt::format("\"{} {}\"", units::from_internal(value, internal), formula_unit(internal.dimension, 0));
  }
  // Hours and the like do not hold every double; seconds do.
  return fmt::format("\"{} s\"", units::from_internal(value, units::parse_unit("s")));
}

/// "a formula in F, f_mat and t of values ".
std::string formula_text(const Row& law) {
  std::string text = "a formula in ";
  for (std::size_t k = 0; k < law.arguments.size(); ++k)
    text += fmt::format("{}{}", k == 0 ? "" : k + 1 < law.arguments.size() ? ", " : " and ", law.arguments[k].name);
  return text + " of values ";
}

/// 1e7 rather than 10000000 or 1e+07.
std::string short_number(double value) {
  std::string text = fmt::format("{:g}", value);
  if (units::to_internal(text, {}) != value) return fmt::format("{}", value);
  const std::size_t plus = text.find("e+0");
  return plus == std::string::npos ? text : text.erase(plus + 1, 2);
}

} // namespace

const Row* find_row(std::string_view path) {
  const auto row = std::ranges::find(schema(), path, &Row::path);
  return row == schema().end() ? nullptr : &*row;
}

const Row* find_row(std::string_view path, const Parameters& p) {
  if (const Row* row = find_row(path)) return row;
  const LawConstant* constant = find_constant(constant_name(path), p);
  return constant == nullptr ? nullptr : constant->row.get();
}

double* real_of(const Row& row, Parameters& p) {
  if (const auto* real = std::get_if<Access<double>>(&row.member)) return &(*real)(p);
  const auto* one = std::get_if<OneConstant>(&row.member);
  const auto found = std::ranges::find(p.laws.constants, one == nullptr ? "" : one->name, &LawConstant::name);
  return found == p.laws.constants.end() ? nullptr : &found->value;
}

Kind kind(const Row& row) {
  const bool angle = row.unit == "deg" || row.unit == "rad";
  const Kind real = angle ? Kind::angle : row.unit == "1" ? Kind::ratio : Kind::quantity;
  return std::visit(Match{[&](Access<double>) { return real; }, [](Access<bool>) { return Kind::boolean; },
                          [&](Access<std::string>) { return section_of(row) == "laws" ? Kind::law : Kind::field; },
                          [](const Choice&) { return Kind::choice; },
                          [](Access<std::vector<LawConstant>>) { return Kind::constants; },
                          [&](const OneConstant&) { return real; }, [](auto /*whole*/) { return Kind::integer; }},
                    row.member);
}

units::Unit unit_of(const Row& row) { return kind(row) == Kind::angle ? units::Unit{} : units::parse_unit(row.unit); }

std::string_view section_of(const Row& row) { return row.path.substr(0, row.path.rfind('.')); }

std::string_view key_of(const Row& row) { return row.path.substr(row.path.rfind('.') + 1); }

std::string in_quotes(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    const auto code = static_cast<unsigned char>(c);
    quoted += code < 0x20 || code == 0x7f ? fmt::format("\\u{:04x}", code) : std::string(1, c);
  }
  return quoted + '"';
}

std::string value_text(const Row& row, const Parameters& parameters) {
  Parameters p = parameters; // the table's accessors give access to write
  return std::visit(Match{[&](Access<double> member) { return quantity_text(row, member(p)); },
                          [&](Access<std::string> member) { return in_quotes(member(p)); },
                          [&](const Choice& c) { return fmt::format("\"{}\"", c.names[c.index(p)]); },
                          [&](Access<std::vector<LawConstant>>) { return in_quotes(constants_text(p)); },
                          [&](const OneConstant&) {
                            const double* value = real_of(row, p); // of none an example
                            return quantity_text(row,
                                                 value == nullptr ? units::to_internal(1.0, unit_of(row)) : *value);
                          },
                          [&](auto member) { return fmt::format("{}", member(p)); }},
                    row.member);
}

std::string meaning_text(const Row& row, const Parameters& p) {
  return kind(row) == Kind::law ? in_quotes(law_meaning(row, p)) : value_text(row, p);
}

bool differs(const Row& row, const Parameters& a, const Parameters& b) {
  return meaning_text(row, a) != meaning_text(row, b);
}

std::string description_of(const Row& row) {
  std::string text(row.description);
  for (const LawVariable& argument : row.arguments)
    text += fmt::format("{}{}: {}, {}", &argument == row.arguments.data() ? ". Arguments: " : "; ", argument.name,
                        argument.meaning, range_text(argument));
  for (const LawVariable& argument : row.shared)
    text += fmt::format("{}{}", &argument == row.shared.data() ? ". Besides: " : ", ", argument.name);
  return text;
}

std::string range_text(const LawVariable& argument) {
  const std::string unit = argument.unit.empty() ? "" : fmt::format(" {}", argument.unit);
  return fmt::format("{:g} to {:g}{}", argument.low, argument.high, unit);
}

const std::string& text_of(const Row& row, const Parameters& p) {
  return std::get<Access<std::string>>(row.member)(const_cast<Parameters&>(p)); // the accessor only finds it
}

std::string before_text(const Row& row, const Parameters& p) {
  if (!row.before) return {};
  if (const Row* other = find_row(*row.before)) return value_text(*other, p);
  const Kind k = kind(row);
  const bool bare = k == Kind::ratio || k == Kind::integer || k == Kind::boolean;
  return bare ? std::string(*row.before) : in_quotes(*row.before);
}

bool counts(const Row& row, const Parameters& p) {
  if (row.of_part != nullptr && !row.of_part(p)) return false;
  return !row.before || meaning_text(row, p) != before_text(row, p);
}

std::string allowed_text(const Row& row) {
  const Kind k = kind(row);
  if (k == Kind::boolean) return "true or false";
  if (k == Kind::choice) return fmt::format("\"{}\"", fmt::join(std::get<Choice>(row.member).names, "\" or \""));
  if (k == Kind::constants) return "names with their values, such as \"F_c = 0.1 nN, n = 2\"";
  const Range& range = row.range;
  if (std::isinf(range.low)) return row.unit == "1" ? "any number" : fmt::format("any number of {}", row.unit);
  const bool rad = row.unit == "rad"; // people think in degrees
  const auto bound = [rad](double value) {
    return rad ? fmt::format("{:g}", value * 180.0 / std::numbers::pi) : short_number(value);
  };
  const bool bare = row.unit == "1" || k == Kind::angle;
  return fmt::format("{}{} {} and {} {}{}",
                     k == Kind::law     ? formula_text(row)
                     : k == Kind::field ? "a formula in x and y, or a file (.csv, .png, .tif), of values "
                                        : "",
                     range.low_allowed ? ">=" : ">", bound(range.low), range.high_allowed ? "<=" : "<",
                     bound(range.high),
                     rad    ? " deg"
                     : bare ? ""
                            : fmt::format(" {}", row.unit));
}

bool in_range(const Row& row, double value) {
  const Range& range = row.range;
  return (range.low_allowed ? value >= range.low : value > range.low)
         && (range.high_allowed ? value <= range.high : value < range.high);
}

bool same(const Parameters& a, const Parameters& b) {
  return std::ranges::none_of(schema(), [&](const Row& row) { return differs(row, a, b); })
         && cells_text(a) == cells_text(b) && changes_text(a) == changes_text(b) && a.origin.gone == b.origin.gone;
}

std::vector<CellStart> cell_starts(const Parameters& p) {
  if (!p.cells.empty()) return p.cells;
  return {{p.cell.start_x, p.cell.start_y}};
}

std::string cells_text(const Parameters& p) {
  std::vector<std::string> cells;
  Parameters one;
  for (const CellStart& start : p.cells) {
    one.cells.assign(1, start);
    std::vector<std::string> keys;
    for (const Row& row : cell_rows()) keys.push_back(fmt::format("{} = {}", key_of(row), value_text(row, one)));
    cells.push_back(fmt::format("{{ {} }}", fmt::join(keys, ", ")));
  }
  return fmt::format("[{}]", fmt::join(cells, ", "));
}

} // namespace matrigrate
