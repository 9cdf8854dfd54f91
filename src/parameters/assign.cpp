#include "parameters/assign.hpp"

#include "parameters/changes.hpp"
#include "parameters/document.hpp"
#include "parameters/laws/constants.hpp"
#include "parameters/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <stdexcept>
#include <utility>

namespace matrigrate {

namespace {

/// The default, as an example of what can be written.
std::string example(const Row& row) { return value_text(row, Parameters{}); }

std::string quoted_excerpt(std::string_view text) { return fmt::format("\"{}\"", excerpt(text)); }

std::string wrong_type(const Row& row, const Given& given) {
  return fmt::format("is {}, but {} is expected, such as {}", given.type,
                     kind(row) == Kind::quantity ? "a number with its unit" : "a number without quotes", example(row));
}

std::string out_of_range(const Row& row, std::string_view shown) {
  const std::string unit = row.unit == "deg" ? fmt::format(" {}", row.unit) : "";
  return fmt::format("{} is out of range; allowed is {}{}", shown, allowed_text(row), unit);
}

/// A real number and its unit, as typed.
struct Typed {
  std::string number;
  units::Unit unit;
  std::string shown; ///< for a message
};

/// @throws std::invalid_argument saying what is wrong with a string
Typed typed_string(const Row& row, const std::string& text) {
  if (kind(row) == Kind::ratio) {
    const std::string such = fmt::format("such as {}", example(row));
    if (text.find_first_of("0123456789") == std::string::npos)
      refuse("{} is no number; allowed is {}, {}", quoted_excerpt(text), allowed_text(row), such);
    refuse("is a string; write a bare number without quotes, {}", such);
  }
  const bool angle = kind(row) == Kind::angle;
  const std::string such = fmt::format("write it like {}", angle ? "\"30 deg\"" : example(row));
  units::Quantity quantity;
  Typed typed;
  try {
    quantity = units::parse_quantity(text);
    typed = {quantity.number, units::parse_unit(quantity.unit), quoted_excerpt(text)};
  } catch (const std::invalid_argument& error) {
    const auto* more = dynamic_cast<const units::Unreadable*>(&error);
    const char* link = more != nullptr && more->names_part ? ": " : " ";
    if (more != nullptr && more->advises) refuse("{}{}{}", quoted_excerpt(text), link, error.what());
    refuse("{}{}{}; {}", quoted_excerpt(text), link, excerpt(error.what(), 120), such);
  }
  if (quantity.unit.empty())
    refuse("{} has no unit; {}, or as a bare number in {}", quoted_excerpt(text), such, row.unit);
  const units::Dimension expected = units::parse_unit(row.unit).dimension;
  if (typed.unit.dimension != expected)
    refuse("{} is {}, but {} is expected; {}", quoted_excerpt(text), to_string(typed.unit.dimension),
           to_string(expected), such);
  if (angle) typed.unit = units::quotient(typed.unit, units::parse_unit(row.unit));
  return typed;
}

/// @throws std::invalid_argument saying what is wrong
Typed typed(const Row& row, const Given& given) {
  if (const auto* text = std::get_if<std::string>(&given.value)) return typed_string(row, *text);
  const std::string number = digits_of(given);
  if (number.empty()) throw std::invalid_argument(wrong_type(row, given));
  if (const auto* real = std::get_if<double>(&given.value); real != nullptr && !std::isfinite(*real))
    refuse("{} is not a finite number", number);
  return {number, unit_of(row), row.unit == "1" ? number : fmt::format("{} {}", number, row.unit)};
}

std::string set(const Row& row, const Given& given, double& parameter) {
  try {
    const Typed t = typed(row, given);
    double value = 0.0;
    try {
      value = units::to_internal(t.number, t.unit);
    } catch (const std::invalid_argument&) {
      return out_of_range(row, t.shown); // beyond any double
    }
    Row internal = row;
    if (!std::isinf(row.range.low))
      for (double* bound : {&internal.range.low, &internal.range.high})
        *bound = units::to_internal(*bound, unit_of(row));
    if (!in_range(internal, value)) return out_of_range(row, t.shown);
    parameter = value;
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// Why a text stands for no whole number. An option of the command line has no quotes that one could leave out.
std::string not_whole(const Row& row, const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos)
    return fmt::format("{} is no whole number; allowed is {}, such as {}", quoted_excerpt(text), allowed_text(row),
                       example(row));
  if (text.size() > 18) return out_of_range(row, text);
  return fmt::format("is a string; write a whole number without quotes, such as {}", example(row));
}

template <std::integral Whole>
std::string set(const Row& row, const Given& given, Whole& parameter) {
  if (std::holds_alternative<double>(given.value))
    return fmt::format("has a decimal point or an exponent; write a whole number, such as {}", example(row));
  if (const auto* text = std::get_if<std::string>(&given.value)) return not_whole(row, *text);
  const auto* value = std::get_if<std::int64_t>(&given.value);
  if (value == nullptr) return wrong_type(row, given);
  if (!in_range(row, static_cast<double>(*value))) return out_of_range(row, fmt::format("{}", *value));
  parameter = static_cast<Whole>(*value);
  return {};
}

std::string set(const Row& row, const Given& given, bool& parameter) {
  const auto* value = std::get_if<bool>(&given.value);
  if (value == nullptr) return fmt::format("is {}; write {}, without quotes", given.type, allowed_text(row));
  parameter = *value;
  return {};
}

std::string set(const Row& row, const Given& given, std::string& parameter) {
  const auto* text = std::get_if<std::string>(&given.value);
  const std::string formula = kind(row) == Kind::law ? digits_of(given) : std::string(); // a number is one
  if (text == nullptr && formula.empty())
    return fmt::format("is {}; write {}, in quotes", given.type, allowed_text(row));
  parameter = text == nullptr ? formula : *text;
  return {};
}

std::string set(const Row& row, const Given& given, std::vector<LawConstant>& constants) {
  const auto* text = std::get_if<std::string>(&given.value);
  if (text == nullptr) return fmt::format("is {}; write {}, in quotes", given.type, allowed_text(row));
  try {
    constants = constants_in(*text);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

std::string set_choice(const Row& row, const Given& given, const Choice& choice, Parameters& p) {
  const auto* name = std::get_if<std::string>(&given.value);
  if (name == nullptr) return fmt::format("is {}; write {}", given.type, allowed_text(row));
  for (std::size_t i = 0; i < choice.names.size(); ++i)
    if (*name == choice.names[i]) {
      choice.set(p, i);
      return {};
    }
  const std::vector<std::string> names(choice.names.begin(), choice.names.end());
  return fmt::format("{} is not known; allowed is {}{}", quoted_excerpt(*name), allowed_text(row),
                     did_you_mean(nearest(*name, names)));
}

} // namespace

std::string digits_of(const Given& given) {
  if (const auto* whole = std::get_if<std::int64_t>(&given.value)) return fmt::format("{}", *whole);
  if (const auto* real = std::get_if<double>(&given.value)) return fmt::format("{}", *real);
  return {};
}

std::string assign(const Row& row, const Given& given, Parameters& p) {
  if (double* real = real_of(row, p)) return set(row, given, *real);
  if (const auto* choice = std::get_if<Choice>(&row.member)) return set_choice(row, given, *choice, p);
  return std::visit(
      [&](const auto& member) {
        if constexpr (requires { member(p); })
          return set(row, given, member(p));
        else
          return unknown_constant(row.path, p);
      },
      row.member);
}

std::string_view type_of(const toml::node& node) {
  switch (node.type()) {
  case toml::node_type::table:
    return "a table";
  case toml::node_type::array:
    return "an array";
  case toml::node_type::string:
    return "a string";
  case toml::node_type::boolean:
    return "a flag";
  case toml::node_type::integer:
  case toml::node_type::floating_point:
    return "a number";
  default:
    return "a date or time";
  }
}

Given given_by(const toml::node& node) {
  Given given{{}, type_of(node)};
  if (const auto* flag = node.as_boolean())
    given.value = flag->get();
  else if (const auto* whole = node.as_integer())
    given.value = whole->get();
  else if (const auto* real = node.as_floating_point())
    given.value = real->get();
  else if (const auto* text = node.as_string())
    given.value = text->get();
  return given;
}

Judged judged(std::string_view path, const Given& value) {
  constexpr std::string_view change = "changes.";
  const bool changes = path.starts_with(change) && path != change_time().path;
  if (changes) path.remove_prefix(change.size());
  const auto of_cells = std::ranges::find(cell_rows(), path, &Row::path);
  const Row* row = path == change_time().path      ? &change_time()
                   : of_cells == cell_rows().end() ? find_row(path)
                                                   : &*of_cells;
  if (row == nullptr) return {unknown_name(path, false)};
  Parameters p;
  if (std::string reason = changes ? fixed_in_run(*row, p) : ""; !reason.empty()) return {std::move(reason)};
  std::string fault = assign(*row, value, p);
  const double* real = real_of(*row, p);
  if (!fault.empty() || real == nullptr) return {std::move(fault)};
  return {{}, units::number_in(*real, unit_of(*row))};
}

std::string unknown_name(std::string_view path, bool section) {
  return fmt::format("there is no such {}{}", section ? "section" : "parameter", parameter_hint(path));
}

} // namespace matrigrate
