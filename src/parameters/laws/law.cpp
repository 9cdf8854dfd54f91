#include "parameters/laws/law.hpp"

#include "base/failure.hpp"
#include "parameters/document.hpp"
#include "parameters/laws/law_units.hpp"
#include "parameters/laws/law_values.hpp"
#include "parameters/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace matrigrate {

namespace {

/// Whether forces stand over areas alone.
bool is_of_stresses(const units::Dimension& dimension) { return dimension.length == -2 * dimension.force; }

/// From internal units to those of formulas, where a stress is in Pa: of a force that stands over an area alone, as in
/// Pa, Pa s and 1/Pa/s.
double in_formulas(const units::Dimension& dimension) {
  constexpr double one = 1000.0; // an exponent of 1, in thousandths
  return is_of_stresses(dimension) ? std::pow(1000.0, dimension.force / one) : 1.0;
}

/// "r_off,min" as a formula writes it.
std::string name_of(std::string_view symbol) {
  std::string name(symbol);
  std::ranges::replace(name, ',', '_');
  return name;
}

/// The pull of both strands of a protrusion at full maturation, 2 F_am: F/(f_mat*F_both) is f_adh_rel.
constexpr const char* both_strands = "F_both";

bool is_variable(std::string_view name) {
  return std::ranges::any_of(law_rows(), [&](const Row& law) {
    const auto variables = law_variables(law);
    return std::ranges::find(variables, name, &LawVariable::name) != variables.end();
  });
}

/// Parameters with a symbol that stands for nothing else in a formula. A time step is no part of a law.
bool has_name(const Row& row) {
  return !row.symbol.empty() && section_of(row) != "run" && !is_variable(name_of(row.symbol));
}

double number_of(const Row& row, Parameters& p) {
  if (const auto* real = std::get_if<double& (*)(Parameters&)>(&row.member)) {
    const bool angle = kind(row) == Kind::angle;
    return (*real)(p) * (angle ? 1.0 : in_formulas(units::parse_unit(row.unit).dimension));
  }
  return std::get<int& (*)(Parameters&)>(row.member)(p);
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return std::string(first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

bool is_name(std::string_view name) {
  const auto letter = [](char c) { return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return !name.empty() && name.size() <= 40 && letter(name.front())
         && std::ranges::all_of(name, [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

/// Whom a name belongs to that a user cannot give; empty if to nobody.
std::string owner_of(const std::string& name) {
  if (is_variable(name)) return "an argument of a law";
  if (name == both_strands) return "2 F_am";
  if (fields::in_every_formula(name)) return "known to every formula";
  for (const Row& row : schema())
    if (has_name(row) && name_of(row.symbol) == name) return std::string(row.path);
  return {};
}

/// A constant of the user; without a dimension where its value has no unit.
struct Constant {
  fields::NamedNumber number;
  std::optional<units::Dimension> dimension;
};

/// "F_c = 0.1 nN".   @throws std::invalid_argument
Constant constant_of(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string name = trimmed(text.substr(0, equals));
  if (equals == std::string_view::npos)
    throw std::invalid_argument(
        fmt::format("\"{}\" is not of the form name = value; write like \"F_c = 0.1 nN, n = 2\", the decimal sign is a "
                    "point",
                    excerpt(trimmed(text))));
  if (!is_name(name))
    throw std::invalid_argument(
        fmt::format("\"{}\" is no name; allowed are letters, digits and _, at most 40 of them", excerpt(name)));
  if (const std::string owner = owner_of(name); !owner.empty())
    throw std::invalid_argument(fmt::format("{} is taken: it is {}; choose another name", name, owner));
  try {
    const units::Quantity quantity = units::parse_quantity(trimmed(text.substr(equals + 1)));
    const units::Unit unit = units::parse_unit(quantity.unit);
    if (quantity.unit.find("Pa") != std::string::npos && !is_of_stresses(unit.dimension))
      throw std::invalid_argument(
          "mixes Pa with another length or force; write it with nN and um: 1 Pa is 1e-3 nN/um^2");
    return {{name, units::to_internal(quantity.number, unit) * in_formulas(unit.dimension)},
            quantity.unit.empty() ? std::nullopt : std::optional(unit.dimension)};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("the value of {} {}", name, excerpt(error.what(), 200)));
  }
}

std::vector<Constant> constants_of(const std::string& text) {
  std::vector<Constant> all;
  for (std::size_t begin = 0; !trimmed(text).empty() && begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    Constant one = constant_of(std::string_view(text).substr(begin, end - begin));
    const std::string& name = one.number.name;
    if (std::ranges::any_of(all, [&](const Constant& other) { return other.number.name == name; }))
      throw std::invalid_argument(fmt::format("{} is given twice", name));
    all.push_back(std::move(one));
    begin = end + 1;
  }
  return all;
}

std::vector<std::string_view> names_of(std::span<const LawVariable> variables) {
  std::vector<std::string_view> names;
  for (const LawVariable& variable : variables) names.push_back(variable.name);
  return names;
}

/// Of lengths, times and forces; an angle counts as a number.
units::Dimension without_angle(units::Dimension dimension) {
  dimension.angle = 0;
  return dimension;
}

/// The dimensions of what a law may name.
DimensionOf dimensions(const Row& law, const Parameters& p) {
  return [&law, constants = constants_of(p.laws.constants)](std::string_view name) -> std::optional<units::Dimension> {
    for (const LawVariable& variable : law_variables(law))
      if (variable.name == name) return without_angle(units::parse_unit(variable.unit).dimension);
    for (const Constant& constant : constants)
      if (constant.number.name == name) return constant.dimension;
    if (name == both_strands) return units::Dimension{.force = 1000};
    for (const Row& row : schema())
      if (has_name(row) && name_of(row.symbol) == name) return without_angle(units::parse_unit(row.unit).dimension);
    return units::Dimension{}; // of pi and e
  };
}

/// What a law may name, in words: "F, f_mat, t, F_c, your constants and symbols of parameters".
std::string known_names(const Row& law, const Parameters& p) {
  std::string text;
  for (const LawVariable& variable : law_variables(law)) text += fmt::format("{}, ", variable.name);
  for (const Constant& constant : constants_of(p.laws.constants)) text += fmt::format("{}, ", constant.number.name);
  return fmt::format("; names here are {}{}symbols of parameters; define others in [laws.constants]", text,
                     text.empty() ? "" : "and ");
}

/// The value in its unit: "0.3 nN".
std::string with_unit(double value, std::string_view unit) {
  if (std::isnan(value)) return "not a number";
  return fmt::format("{:.6g}{}{}", value, unit.empty() || unit == "1" ? "" : " ", unit == "1" ? "" : unit);
}

} // namespace

fields::Expression law_formula(const Row& law, const Parameters& p, const std::string& text) {
  const std::vector<std::string_view> variables = names_of(law_variables(law));
  const std::vector<fields::NamedNumber> names = law_names(p);
  try {
    return {text, variables, names};
  } catch (const fields::UnknownName& error) {
    std::vector<std::string> known(variables.begin(), variables.end());
    for (const fields::NamedNumber& name : names) known.push_back(name.name);
    constexpr std::size_t telling = 3; // letters: of fewer any other name is near
    const std::string meant = error.name.size() < telling ? "" : did_you_mean(nearest(error.name, known));
    throw std::invalid_argument(fmt::format("{}{}", error.what(), meant.empty() ? known_names(law, p) : meant));
  }
}

std::string law_unit_fault(const Row& law, const Parameters& p, const fields::Expression& formula) {
  return fault_of_units(formula.tree().whole, dimensions(law, p), units::parse_unit(law.unit).dimension);
}

std::string law_arguments(const Row& law, std::span<const double> arguments, const std::vector<bool>& named) {
  const auto variables = law_variables(law);
  std::string text;
  for (std::size_t k = 0; k < variables.size(); ++k)
    if (named[k])
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", variables[k].name,
                          with_unit(arguments[k], variables[k].unit));
  return text.empty() ? "any argument" : text;
}

std::string law_fault(const Row& law, double value, const std::string& where) {
  std::string help;
  if (value < law.range.low) help = fmt::format("; max({:g}, ...) keeps it from falling below", law.range.low);
  if (value > law.range.high) help = fmt::format("; min({:g}, ...) keeps it from rising above", law.range.high);
  const std::string unit = law.unit == "1" ? "" : fmt::format(" {}", law.unit);
  return fmt::format("is {} at {}; allowed is >= {:g} and <= {:g}{}{}", with_unit(value, law.unit), where,
                     law.range.low, law.range.high, unit, help);
}

std::vector<fields::NamedNumber> law_names(const Parameters& p) {
  std::vector<fields::NamedNumber> names;
  for (const Constant& constant : constants_of(p.laws.constants)) names.push_back(constant.number);
  names.push_back({both_strands, 2.0 * p.actomyosin.force});
  Parameters q = p;
  for (const Row& row : schema())
    if (has_name(row)) names.push_back({name_of(row.symbol), number_of(row, q)});
  return names;
}

Law::Law(std::string_view path, const Parameters& p) : m_row(find_row(path)) {
  if (is_changed(*m_row, p)) m_formula.emplace(law_formula(*m_row, p, text_of(*m_row, p)));
}

bool Law::uses(std::string_view variable) const {
  if (!changed()) return false;
  const auto variables = law_variables(*m_row);
  const auto found = std::ranges::find(variables, variable, &LawVariable::name);
  return found != variables.end() && m_formula->uses(static_cast<std::size_t>(found - variables.begin()));
}

double Law::operator()(std::initializer_list<double> arguments) const {
  const double value = m_formula->at({arguments.begin(), arguments.size()});
  if (in_range(*m_row, value)) return value;
  const std::vector<bool> all(arguments.size(), true);
  throw NumericalFailure(
      FailureCause::law,
      fmt::format("{} {}", m_row->path,
                  law_fault(*m_row, value, law_arguments(*m_row, {arguments.begin(), arguments.size()}, all))));
}

std::string fault_of_constants(const Parameters& p) {
  try {
    constants_of(p.laws.constants);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

std::string fault_of_law(const Parameters& p, const Row& law) {
  if (!fault_of_constants(p).empty()) return {}; // said already
  try {
    const Law readable(law.path, p);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

std::vector<std::string> law_notes(const Parameters& p) {
  std::vector<std::string> notes;
  if (!fault_of_constants(p).empty()) return notes;
  std::vector<std::string> named;
  for (const Row* law : changed_laws(p)) {
    if (!fault_of_law(p, *law).empty()) return notes;
    const fields::Expression formula = law_formula(*law, p, text_of(*law, p));
    fields::for_each_part(formula.tree().whole, [&](const fields::Part& part) {
      if (part.kind == fields::Part::Kind::name) named.push_back(part.text);
    });
    for (const std::string& never : steady_comparisons(p, *law))
      notes.push_back(fmt::format("{}: {}", law->path, never));
  }
  for (const Constant& constant : constants_of(p.laws.constants))
    if (std::ranges::find(named, constant.number.name) == named.end())
      notes.push_back(
          fmt::format("laws.constants: {} stands in no law that differs from the default", constant.number.name));
  return notes;
}

const std::string& usual_text(const Row& law) {
  static const Parameters usual;
  return text_of(law, usual);
}

bool is_changed(const Row& law, const Parameters& p) { return text_of(law, p) != usual_text(law); }

std::vector<const Row*> changed_laws(const Parameters& p) {
  std::vector<const Row*> changed;
  for (const Row& law : law_rows())
    if (kind(law) == Kind::law && is_changed(law, p)) changed.push_back(&law);
  return changed;
}

} // namespace matrigrate
