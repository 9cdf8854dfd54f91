#include "parameters/laws/law.hpp"

#include "base/failure.hpp"
#include "parameters/laws/law_values.hpp"
#include "parameters/nearest.hpp"
#include "parameters/scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
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
  if (fields::in_every_formula(name)) return "known to every formula";
  for (const Row& row : schema())
    if (has_name(row) && name_of(row.symbol) == name) return std::string(row.path);
  return {};
}

/// "F_c = 0.1 nN".   @throws std::invalid_argument
fields::NamedNumber constant_of(std::string_view text) {
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
    return {name, units::to_internal(quantity.number, unit) * in_formulas(unit.dimension)};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("the value of {} {}", name, excerpt(error.what(), 200)));
  }
}

std::vector<fields::NamedNumber> constants_of(const std::string& text) {
  std::vector<fields::NamedNumber> all;
  for (std::size_t begin = 0; !trimmed(text).empty() && begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    fields::NamedNumber one = constant_of(std::string_view(text).substr(begin, end - begin));
    if (std::ranges::find(all, one.name, &fields::NamedNumber::name) != all.end())
      throw std::invalid_argument(fmt::format("{} is given twice", one.name));
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
    throw std::invalid_argument(fmt::format("{}{}", error.what(), did_you_mean(nearest(error.name, known))));
  }
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
  std::vector<fields::NamedNumber> names = constants_of(p.laws.constants);
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
