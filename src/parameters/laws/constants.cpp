#include "parameters/laws/constants.hpp"

#include "parameters/assign.hpp"
#include "parameters/document.hpp"
#include "parameters/laws/law_names.hpp"
#include "parameters/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

namespace matrigrate {

namespace {

constexpr std::string_view head = "laws.constants.";
constexpr double any = std::numeric_limits<double>::infinity();

/// The row of a constant, with its texts.
std::shared_ptr<const Row> made_row(std::string_view name, std::string_view unit, const Range& range) {
  struct Kept {
    std::string path;
    std::string unit;
    Row row;
  };
  const auto kept = std::make_shared<Kept>(Kept{fmt::format("{}{}", head, name), std::string(unit), {}});
  const std::string_view path = kept->path;
  kept->row = {path,
               OneConstant{path.substr(head.size())},
               kept->unit,
               range,
               "",
               "this program",
               "Constant of the laws",
               Audience::optional};
  return {kept, &kept->row};
}

bool is_name(std::string_view name) {
  const auto letter = [](char c) { return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return !name.empty() && name.size() <= 40 && letter(name.front())
         && std::ranges::all_of(name, [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

/// "0.05 nN", in the unit of formulas.
std::string value_of(const LawConstant& constant) {
  const units::Dimension dimension = units::parse_unit(constant.row->unit).dimension;
  std::string number =
      units::from_internal(constant.value, {.dimension = dimension, .ten = -3 * pascals_in(dimension)});
  if (number.empty()) number = fmt::format("{}", in_formulas(constant));
  return constant.row->unit == "1" ? number : fmt::format("{} {}", number, constant.row->unit);
}

/// A constant without a range.   @param typed  "0.1 nN", "2"
/// @throws std::invalid_argument saying what is wrong with the name, or the value
LawConstant constant_of(std::string_view name, std::string_view typed) {
  if (!is_name(name)) refuse("\"{}\" is no name; allowed are letters, digits and _, at most 40 of them", excerpt(name));
  if (const std::string owner = owner_of_name(name); !owner.empty() && !came_later(name))
    refuse("{} is taken: it is {}; choose another name", name, owner);
  try {
    const units::Quantity quantity = units::parse_quantity(typed);
    const units::Unit unit = units::parse_unit(quantity.unit);
    const std::string of_formulas = formula_unit(unit.dimension, pascals_in(unit.dimension));
    return {std::string(name), units::to_internal(quantity.number, unit),
            made_row(name, of_formulas.empty() ? "1" : of_formulas, {-any, any})};
  } catch (const std::invalid_argument& error) {
    const auto* more = dynamic_cast<const units::Unreadable*>(&error);
    refuse("the value of {}, \"{}\"{} {}", name, excerpt(typed), more != nullptr && more->names_part ? ":" : "",
           excerpt(error.what(), 200));
  }
}

/// A value of a table as it is typed.   @throws std::invalid_argument if it is neither a text nor a number
std::string typed_at(std::string_view name, const toml::node& node) {
  const Given given = given_by(node);
  const auto* text = std::get_if<std::string>(&given.value);
  std::string typed = text == nullptr ? digits_of(given) : *text;
  if (text == nullptr && typed.empty())
    refuse("the value of {} is {}; write a number with its unit in quotes, such as \"0.1 nN\", or a plain number", name,
           given.type);
  return typed;
}

/// A bound of its range.   @throws std::invalid_argument saying what is wrong with it
LawConstant bound_of(const LawConstant& constant, const toml::node& node) {
  Parameters p;
  p.laws.constants = {constant};
  if (const std::string fault = assign(*constant.row, given_by(node), p); !fault.empty())
    refuse("the range of {}: {}", constant.name, fault);
  return p.laws.constants.front();
}

double number_in_unit(const LawConstant& constant) { return units::number_in(constant.value, unit_of(*constant.row)); }

/// @throws std::invalid_argument saying what is wrong with it
void set_range(const toml::node& node, LawConstant& constant) {
  const toml::array* list = node.as_array();
  if (list == nullptr || list->size() != 2)
    refuse("the range of {} is {}; write it like [\"0.1 nN\", \"1 nN\"], low and high", constant.name,
           list == nullptr ? std::string(type_of(node)) : fmt::format("of {} values", list->size()));
  const LawConstant low = bound_of(constant, *list->get(0));
  const LawConstant high = bound_of(constant, *list->get(1));
  if (!(low.value < high.value))
    refuse("the range of {} begins at {} and ends at {}; the lower bound comes first", constant.name, value_of(low),
           value_of(high));
  constant.row = made_row(constant.name, constant.row->unit, {number_in_unit(low), number_in_unit(high)});
  if (!in_range(*constant.row, number_in_unit(constant)))
    refuse("{} is out of its range; allowed is {}", text_of(constant), allowed_text(*constant.row));
}

LawConstant defined(std::string_view name, const toml::node& node) {
  const toml::table* table = node.as_table();
  if (table == nullptr) return constant_of(name, typed_at(name, node));
  for (const auto& [key, value] : *table)
    if (key.str() != "value" && key.str() != "range")
      refuse("there is no such key as {}; a constant has value and range", excerpt(key.str()));
  const toml::node* value = table->get("value");
  if (value == nullptr)
    throw std::invalid_argument("has no value; write it like { value = \"0.4 nN\", range = [\"0.1 nN\", \"1 nN\"] }");
  LawConstant constant = constant_of(name, typed_at(name, *value));
  if (const toml::node* range = table->get("range")) set_range(*range, constant);
  return constant;
}

/// Constants are kept by their names.
void put(LawConstant constant, std::vector<LawConstant>& all) {
  const auto at = std::ranges::lower_bound(all, constant.name, {}, &LawConstant::name);
  if (at != all.end() && at->name == constant.name)
    *at = std::move(constant);
  else
    all.insert(at, std::move(constant));
}

} // namespace

std::string_view constant_name(std::string_view path) {
  return path.starts_with(head) ? path.substr(head.size()) : std::string_view();
}

const LawConstant* find_constant(std::string_view name, const Parameters& p) {
  const auto found = std::ranges::find(p.laws.constants, name, &LawConstant::name);
  return found == p.laws.constants.end() ? nullptr : &*found;
}

double in_formulas(const LawConstant& constant) {
  return constant.value * formula_factor(units::parse_unit(constant.row->unit).dimension);
}

std::string text_of(const LawConstant& constant) { return fmt::format("{} = {}", constant.name, value_of(constant)); }

std::string constants_text(const Parameters& p) {
  std::string text;
  for (const LawConstant& constant : p.laws.constants) text += (text.empty() ? "" : ", ") + text_of(constant);
  return text;
}

std::string constants_table(const Parameters& p) {
  std::string text;
  for (const LawConstant& constant : p.laws.constants) {
    const Row& row = *constant.row;
    std::string value = value_text(row, p);
    const auto bound = [&row](double number) {
      return kind(row) == Kind::ratio ? fmt::format("{}", number) : fmt::format("\"{} {}\"", number, row.unit);
    };
    if (!std::isinf(row.range.low))
      value = fmt::format("{{ value = {}, range = [{}, {}] }}", value, bound(row.range.low), bound(row.range.high));
    text += fmt::format("{} = {}\n", constant.name, value);
  }
  return text;
}

std::vector<LawConstant> constants_in(std::string_view text) {
  std::vector<LawConstant> all;
  for (std::size_t begin = 0; !trimmed(text).empty() && begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view one = text.substr(begin, end - begin);
    const std::size_t equals = one.find('=');
    if (equals == std::string_view::npos)
      refuse("\"{}\" is not of the form name = value; write like \"F_c = 0.1 nN, n = "
             "2\", the decimal sign is a point",
             excerpt(trimmed(one)));
    LawConstant constant = constant_of(trimmed(one.substr(0, equals)), trimmed(one.substr(equals + 1)));
    if (std::ranges::find(all, constant.name, &LawConstant::name) != all.end())
      refuse("{} is given twice", constant.name);
    put(std::move(constant), all);
    begin = end + 1;
  }
  return all;
}

std::string define_constant(std::string_view name, const toml::node& node, Parameters& p) {
  const LawConstant* known = find_constant(name, p);
  if (known != nullptr && !node.is_table()) return assign(*known->row, given_by(node), p);
  try {
    put(defined(name, node), p.laws.constants);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

std::string unknown_constant(std::string_view path, const Parameters& p) {
  const std::string_view name = constant_name(path);
  std::vector<std::string> names;
  for (const LawConstant& constant : p.laws.constants) names.push_back(constant.name);
  return fmt::format("there is no such constant; {}{}; define it in the scenario, below [laws.constants]: {} = "
                     "\"0.1 nN\"",
                     names.empty() ? "there are none" : fmt::format("there are {}", fmt::join(names, ", ")),
                     did_you_mean(nearest(name, names)), is_name(name) ? name : "F_c");
}

} // namespace matrigrate
