#include "parameters/laws/law_names.hpp"

#include "parameters/laws/constants.hpp"
#include "parameters/laws/law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

namespace matrigrate {

namespace {

/// "r_off,min" as a formula writes it.
std::string name_of(std::string_view symbol) {
  std::string name(symbol);
  std::ranges::replace(name, ',', '_');
  return name;
}

/// The pull of both strands of a protrusion at full maturation, 2 F_am: F/(f_mat*F_both) is f_adh_rel.
constexpr const char* both_strands = "F_both";

/// What version 0.3.0 did not have: names of arguments, symbols and functions, and laws.
constexpr std::array later_names{"F_both",  "age",   "ceil",     "density", "f_curv", "f_degr", "floor",
                                 "m_mat",   "mod",   "pressure", "s_mat",   "speed",  "steps",  "stiffness",
                                 "stretch", "t_mat", "time",     "x",       "y"};
constexpr std::array later_laws{"laws.contraction", "laws.maturation_force", "laws.maturation",
                                "laws.adhesion_stiffness"};

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
  if (const double* real = real_of(row, p))
    return *real * (kind(row) == Kind::angle ? 1.0 : formula_factor(units::parse_unit(row.unit).dimension));
  return std::get<int& (*)(Parameters&)>(row.member)(p);
}

void number_by_value(fields::Part& part) {
  if (part.kind == fields::Part::Kind::number) part.text = fmt::format("{}", std::strtod(part.text.c_str(), nullptr));
  for (fields::Part& of : part.parts) number_by_value(of);
}

std::string formula_meaning(const Row& law, const Parameters& p) {
  const std::vector<LawVariable> variables = law_variables(law, text_of(law, p), p);
  fields::FormulaTree tree = fields::tree_of(text_of(law, p), [&](std::string_view name) {
    return std::ranges::find(variables, name, &LawVariable::name) != variables.end() || name == both_strands
           || row_of_symbol(name) != nullptr || find_constant(name, p) != nullptr;
  });
  number_by_value(tree.whole);
  return fields::written(tree.whole);
}

} // namespace

std::string owner_of_name(std::string_view name) {
  if (is_argument(name)) return "an argument of a law";
  if (name == both_strands) return "2 F_am";
  if (fields::in_every_formula(std::string(name))) return "known to every formula";
  const Row* row = row_of_symbol(name);
  return row == nullptr ? "" : std::string(row->path);
}

bool came_later(std::string_view name) { return std::ranges::find(later_names, name) != later_names.end(); }

bool puts_constants_first(const Row& law) { return std::ranges::find(later_laws, law.path) == later_laws.end(); }

std::vector<fields::NamedNumber> law_names(const Row& law, const Parameters& p) {
  std::vector<fields::NamedNumber> names{{both_strands, 2.0 * p.actomyosin.force}};
  Parameters q = p;
  for (const Symbol& symbol : symbols()) names.push_back({symbol.name, number_of(*symbol.row, q)});
  auto at = puts_constants_first(law) ? names.begin() : names.end();
  for (const LawConstant& constant : p.laws.constants)
    at = std::next(names.insert(at, {constant.name, in_formulas(constant)}));
  return names;
}

DimensionOf law_dimensions(const Row& law, const Parameters& p) {
  const auto of_unit = [](std::string_view unit) { // an angle counts as a number
    units::Dimension dimension = units::parse_unit(unit).dimension;
    dimension.angle = 0;
    return dimension;
  };
  return [&law, of_unit, p](std::string_view name) -> std::optional<units::Dimension> {
    for (const LawVariable& argument : law_variables(law, name, p))
      if (argument.name == name) return of_unit(argument.unit);
    if (const LawConstant* constant = find_constant(name, p))
      return constant->row->unit == "1" ? std::nullopt : std::optional(of_unit(constant->row->unit));
    if (name == both_strands) return units::Dimension{.force = 1000};
    const Row* row = row_of_symbol(name);
    return row == nullptr ? units::Dimension{} : of_unit(row->unit); // pi and e are numbers
  };
}

std::string law_meaning(const Row& law, const Parameters& p) {
  const std::string& text = text_of(law, p);
  try {
    return text == *law.before ? text : formula_meaning(law, p);
  } catch (const std::invalid_argument&) { // is refused
    return text;
  }
}

} // namespace matrigrate
