#include "parameters/laws/law_names.hpp"

#include "parameters/document.hpp"
#include "parameters/laws/law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace matrigrate {

namespace {

/// From internal units to those of formulas, where a stress is in Pa.
double in_formulas(const units::Dimension& dimension) {
  constexpr double one = 1000.0; // an exponent of 1, in thousandths
  return std::pow(1000.0, pascals_in(dimension) / one);
}

/// "r_off,min" as a formula writes it.
std::string name_of(std::string_view symbol) {
  std::string name(symbol);
  std::ranges::replace(name, ',', '_');
  return name;
}

/// The pull of both strands of a protrusion at full maturation, 2 F_am: F/(f_mat*F_both) is f_adh_rel.
constexpr const char* both_strands = "F_both";

bool is_argument(std::string_view name) {
  const auto shared = shared_arguments();
  if (std::ranges::find(shared, name, &LawVariable::name) != shared.end()) return true;
  return std::ranges::any_of(law_rows(), [&](const Row& law) {
    return std::ranges::find(law.arguments, name, &LawVariable::name) != law.arguments.end();
  });
}

struct Symbol {
  std::string name;
  const Row* row;
};

/// Parameters with a symbol that stands for nothing else in a formula. A time step is no part of a law.
const std::vector<Symbol>& symbols() {
  static const std::vector<Symbol> all = [] {
    std::vector<Symbol> found;
    for (const Row& row : schema())
      if (!row.symbol.empty() && section_of(row) != "run" && !is_argument(name_of(row.symbol)))
        found.push_back({name_of(row.symbol), &row});
    return found;
  }();
  return all;
}

const Row* row_of_symbol(std::string_view name) {
  const auto found = std::ranges::find(symbols(), name, &Symbol::name);
  return found == symbols().end() ? nullptr : found->row;
}

double number_of(const Row& row, Parameters& p) {
  if (const auto* real = std::get_if<double& (*)(Parameters&)>(&row.member)) {
    const bool angle = kind(row) == Kind::angle;
    return (*real)(p) * (angle ? 1.0 : in_formulas(units::parse_unit(row.unit).dimension));
  }
  return std::get<int& (*)(Parameters&)>(row.member)(p);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool is_name(std::string_view name) {
  const auto letter = [](char c) { return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return !name.empty() && name.size() <= 40 && letter(name.front())
         && std::ranges::all_of(name, [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

/// Whom a name belongs to that a user cannot give; empty if to nobody.
std::string owner_of(const std::string& name) {
  if (is_argument(name)) return "an argument of a law";
  if (name == both_strands) return "2 F_am";
  if (fields::in_every_formula(name)) return "known to every formula";
  const Row* row = row_of_symbol(name);
  return row == nullptr ? "" : std::string(row->path);
}

/// "50 pN" as "0.05 nN".
std::string in_formula_unit(double internal, const units::Dimension& dimension) {
  const int pascals = pascals_in(dimension);
  std::string number = units::from_internal(internal, {.dimension = dimension, .ten = -3 * pascals});
  if (number.empty()) number = fmt::format("{}", internal * in_formulas(dimension));
  const std::string unit = formula_unit(dimension, pascals);
  return unit.empty() ? number : fmt::format("{} {}", number, unit);
}

/// "F_c = 0.1 nN".   @throws std::invalid_argument
LawConstant constant_of(std::string_view text) {
  const std::size_t equals = text.find('=');
  std::string name(trimmed(text.substr(0, equals)));
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
    const double internal = units::to_internal(quantity.number, unit);
    std::string written = fmt::format("{} = {}", name, in_formula_unit(internal, unit.dimension));
    return {{std::move(name), internal * in_formulas(unit.dimension)},
            quantity.unit.empty() ? std::nullopt : std::optional(unit.dimension),
            std::move(written)};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("the value of {} {}", name, excerpt(error.what(), 200)));
  }
}

void number_by_value(fields::Part& part) {
  if (part.kind == fields::Part::Kind::number) part.text = fmt::format("{}", std::strtod(part.text.c_str(), nullptr));
  for (fields::Part& of : part.parts) number_by_value(of);
}

std::string formula_meaning(const Row& law, const Parameters& p) {
  const std::vector<LawConstant> constants = law_constants(p);
  const std::vector<LawVariable> variables = law_variables(law, text_of(law, p));
  fields::FormulaTree tree = fields::tree_of(text_of(law, p), [&](std::string_view name) {
    return std::ranges::find(variables, name, &LawVariable::name) != variables.end() || name == both_strands
           || row_of_symbol(name) != nullptr
           || std::ranges::any_of(constants, [&](const LawConstant& c) { return c.number.name == name; });
  });
  number_by_value(tree.whole);
  return fields::written(tree.whole);
}

std::string constants_meaning(const Parameters& p) {
  std::vector<LawConstant> constants = law_constants(p);
  std::ranges::sort(constants, {}, [](const LawConstant& c) { return c.number.name; });
  std::string text;
  for (const LawConstant& constant : constants) text += fmt::format("{}{}", text.empty() ? "" : ", ", constant.text);
  return text;
}

} // namespace

std::vector<LawConstant> law_constants(const Parameters& p) {
  const std::string& text = p.laws.constants;
  std::vector<LawConstant> all;
  for (std::size_t begin = 0; !trimmed(text).empty() && begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    LawConstant one = constant_of(std::string_view(text).substr(begin, end - begin));
    const std::string& name = one.number.name;
    if (std::ranges::any_of(all, [&](const LawConstant& other) { return other.number.name == name; }))
      throw std::invalid_argument(fmt::format("{} is given twice", name));
    all.push_back(std::move(one));
    begin = end + 1;
  }
  return all;
}

std::string fault_of_constants(const Parameters& p) {
  try {
    law_constants(p);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

std::vector<fields::NamedNumber> law_names(const Parameters& p) {
  std::vector<fields::NamedNumber> names;
  for (LawConstant& constant : law_constants(p)) names.push_back(std::move(constant.number));
  names.push_back({both_strands, 2.0 * p.actomyosin.force});
  Parameters q = p;
  for (const Symbol& symbol : symbols()) names.push_back({symbol.name, number_of(*symbol.row, q)});
  return names;
}

DimensionOf law_dimensions(const Row& law, const Parameters& p) {
  const auto of_unit = [](std::string_view unit) { // an angle counts as a number
    units::Dimension dimension = units::parse_unit(unit).dimension;
    dimension.angle = 0;
    return dimension;
  };
  return [&law, of_unit, constants = law_constants(p)](std::string_view name) -> std::optional<units::Dimension> {
    for (const std::span<const LawVariable> some : {law.arguments, law.shared})
      for (const LawVariable& argument : some)
        if (argument.name == name) return of_unit(argument.unit);
    for (const LawConstant& constant : constants)
      if (constant.number.name == name) return constant.dimension;
    if (name == both_strands) return units::Dimension{.force = 1000};
    const Row* row = row_of_symbol(name);
    return row == nullptr ? units::Dimension{} : of_unit(row->unit); // pi and e are numbers
  };
}

std::string law_meaning(const Row& row, const Parameters& p) {
  const std::string& text = text_of(row, p);
  try {
    if (kind(row) == Kind::constants) return text.empty() ? text : constants_meaning(p);
    return text == *row.before ? text : formula_meaning(row, p);
  } catch (const std::invalid_argument&) { // is refused
    return text;
  }
}

} // namespace matrigrate
