#include "parameters/laws/law_names.hpp"

#include "parameters/document.hpp"
#include "parameters/laws/constants.hpp"
#include "parameters/laws/law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
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
  return std::get<Access<int>>(row.member)(p);
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

namespace {

using fields::Part;
using units::Dimension;

/// The dimension of a part, as far as it is certain: a plain number may stand for a quantity.
struct Known {
  Dimension dimension;
  bool certain = true;
  int pascals = 0; ///< the exponent of Pa in the unit of its number, in thousandths
};

constexpr std::array same_as_argument{"abs", "rint", "floor", "ceil"};
constexpr std::array alike{"min", "max", "sum", "avg", "mod"};

bool is_one_of(const auto& names, const std::string& name) { return std::ranges::find(names, name) != names.end(); }

Known power(const Known& of, double exponent) {
  const auto times = [exponent](int thousandths) { return static_cast<int>(exponent * thousandths); };
  const Dimension& d = of.dimension;
  return {{times(d.length), times(d.time), times(d.force), times(d.angle)}, of.certain, times(of.pascals)};
}

Known product(const Known& of, const Known& with, int sign) {
  const Dimension& a = of.dimension;
  const Dimension& b = with.dimension;
  return {{a.length + sign * b.length, a.time + sign * b.time, a.force + sign * b.force, a.angle + sign * b.angle},
          of.certain && with.certain,
          of.pascals + sign * with.pascals};
}

std::string said(const Dimension& dimension) {
  return dimension == Dimension{} ? "a number without a unit" : units::to_string(dimension);
}

/// The unit of a number in a formula.
std::string unit_of(const Known& known) {
  const std::string unit = formula_unit(known.dimension, known.pascals);
  return unit.empty() ? "a number without a unit" : "in " + unit;
}

constexpr const char* factor = "; 1 Pa is 1e-3 nN/um^2: write the factor out";

class Units {
public:
  explicit Units(const DimensionOf& of_name) : m_of_name(of_name) {}

  /// @throws std::invalid_argument saying which parts do not agree, and where
  Known of(const Part& part) const {
    switch (part.kind) {
    case Part::Kind::number:
      return {{}, false};
    case Part::Kind::name: {
      const std::optional<Dimension> named = m_of_name(part.text);
      return named ? Known{*named, true, pascals_in(*named)} : Known{{}, false};
    }
    case Part::Kind::prefix:
      return part.text == "-" ? of(part.parts[0]) : Known{};
    case Part::Kind::infix:
      return of_infix(part);
    case Part::Kind::choice:
      of(part.parts[0]);
      return agreeing(part, part.parts[1], part.parts[2]);
    default:
      return of_call(part);
    }
  }

private:
  Known agreeing(const Part& whole, const Part& a, const Part& b) const {
    const Known first = of(a), second = of(b);
    if (first.certain && second.certain && first.dimension != second.dimension)
      refuse("at character {}: {} is {}, but {} is {}", whole.at, written(a), said(first.dimension), written(b),
             said(second.dimension));
    if (first.certain && second.certain && first.pascals != second.pascals)
      refuse("at character {}: {} is {}, but {} is {}{}", whole.at, written(a), unit_of(first), written(b),
             unit_of(second), factor);
    return first.certain ? first : second;
  }

  void require_number(const Part& of_part, std::string_view taken_by) const {
    const Known known = of(of_part);
    if (known.certain && known.dimension != Dimension{})
      refuse("at character {}: {} is {}, but {} takes a number without a unit", of_part.at, written(of_part),
             said(known.dimension), taken_by);
    if (known.certain && known.pascals != 0)
      refuse("at character {}: {} is {}, but {} takes a number without a unit{}", of_part.at, written(of_part),
             unit_of(known), taken_by, factor);
  }

  Known of_infix(const Part& part) const {
    const Part& a = part.parts[0];
    const Part& b = part.parts[1];
    if (part.text == "^") return of_power(a, b);
    if (part.text == "+" || part.text == "-") return agreeing(part, a, b);
    if (part.text == "*" || part.text == "/") return product(of(a), of(b), part.text == "*" ? 1 : -1);
    if (is_comparison(part)) {
      agreeing(part, a, b);
    } else {
      of(a);
      of(b);
    }
    return {};
  }

  Known of_power(const Part& base, const Part& exponent) const {
    require_number(exponent, "an exponent");
    const Known known = of(base);
    if (known.dimension == Dimension{} && known.pascals == 0) return known;
    const bool negative = exponent.kind == Part::Kind::prefix && exponent.text == "-";
    const Part& size = negative ? exponent.parts[0] : exponent;
    if (size.kind != Part::Kind::number) return {{}, false};
    const double number = std::strtod(size.text.c_str(), nullptr);
    return power(known, negative ? -number : number);
  }

  Known of_call(const Part& part) const {
    if (part.text == "sqrt") return power(of(part.parts[0]), 0.5);
    if (is_one_of(same_as_argument, part.text)) return of(part.parts[0]);
    if (is_one_of(alike, part.text)) {
      Known found = of(part.parts[0]);
      for (std::size_t k = 1; k < part.parts.size(); ++k) {
        const Known both = agreeing(part, part.parts[0], part.parts[k]);
        if (!found.certain) found = both;
      }
      return found;
    }
    for (const Part& argument : part.parts)
      if (part.text == "sign" || part.text == "atan2")
        of(argument);
      else
        require_number(argument, part.text);
    return {};
  }

  const DimensionOf& m_of_name;
};

} // namespace

int pascals_in(const Dimension& dimension) { return dimension.length == -2 * dimension.force ? dimension.force : 0; }

double formula_factor(const Dimension& dimension) {
  constexpr double one = 1000.0; // an exponent of 1, in thousandths
  return std::pow(1000.0, pascals_in(dimension) / one);
}

std::string formula_unit(const Dimension& dimension, int pascals) {
  constexpr int one = 1000;
  std::string over, under;
  const auto add = [&](std::string_view symbol, int exponent) {
    if (exponent == 0) return;
    const int size = std::abs(exponent);
    const std::string with = size == one ? std::string(symbol) : fmt::format("{}^{:g}", symbol, size / 1000.0);
    if (exponent < 0)
      under += "/" + with;
    else
      over += (over.empty() ? "" : " ") + with;
  };
  add("Pa", pascals);
  add("nN", dimension.force - pascals);
  add("um", dimension.length + 2 * pascals);
  add("s", dimension.time);
  add("rad", dimension.angle);
  return over.empty() && !under.empty() ? "1" + under : over + under;
}

std::string fault_of_units(const Part& whole, const DimensionOf& of_name, const Dimension& wanted) {
  try {
    const Known known = Units(of_name).of(whole);
    if (!known.certain) return {};
    if (known.dimension != wanted) return fmt::format("is {}, but {} is wanted", said(known.dimension), said(wanted));
    const Known right{wanted, true, pascals_in(wanted)};
    if (known.pascals == right.pascals) return {};
    return fmt::format("is {}, but is to be {}{}", unit_of(known), unit_of(right), factor);
  } catch (const std::invalid_argument& error) {
    return fmt::format("mixes units {}", error.what());
  }
}

} // namespace matrigrate
