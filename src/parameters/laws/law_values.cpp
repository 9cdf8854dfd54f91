#include "parameters/laws/law.hpp"

#include "parameters/laws/law_names.hpp"
#include "parameters/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace matrigrate {

namespace {

constexpr double most_points = 2e5; // of a grid; each takes 50 to 200 ns

/// " (1/kappa, at character 5, is infinite)": the innermost part of a formula that is not finite; empty if there is
/// none.
std::string place_of_fault(const Row& law, const Parameters& p, std::span<const LawVariable> variables,
                           const fields::FormulaTree& tree, std::span<const double> arguments) {
  std::string place;
  fields::for_each_part(tree.whole, [&](const fields::Part& part) {
    if (!place.empty() || part.parts.empty()) return;
    const double value = law_formula(law, p, fields::written(part), variables).at(arguments);
    if (!std::isfinite(value))
      place = fmt::format(" ({}, at character {}, is {})", fields::written(part), part.at,
                          std::isnan(value) ? "not a number" : "infinite");
  });
  return place;
}

/// The numbers of a formula: those written out, and those with a name.
std::vector<double> numbers_in(const fields::FormulaTree& tree, std::span<const fields::NamedNumber> names) {
  std::vector<double> numbers;
  fields::for_each_part(tree.whole, [&](const fields::Part& part) {
    if (part.kind == fields::Part::Kind::number) numbers.push_back(std::strtod(part.text.c_str(), nullptr));
    const auto named = std::ranges::find(names, part.text, &fields::NamedNumber::name);
    if (part.kind == fields::Part::Kind::name && named != names.end()) numbers.push_back(named->value);
  });
  return numbers;
}

/// Where a law is judged over one argument: evenly from bound to bound, at its usual value, and at the numbers of the
/// formula, where poles and jumps may be.
std::vector<double> axis(const LawVariable& argument, std::size_t points, const std::vector<double>& numbers) {
  std::vector<double> all{argument.usual};
  for (std::size_t k = 0; k < points; ++k)
    all.push_back(argument.low
                  + (argument.high - argument.low) * static_cast<double>(k) / static_cast<double>(points - 1));
  for (const double number : numbers)
    for (const double at : {number, -number})
      if (at >= argument.low && at <= argument.high) all.push_back(at);
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// Calls visit(arguments) at all points of a grid until it returns false.
template <class Visit>
void over_grid(const std::vector<std::vector<double>>& axes, const Visit& visit) {
  std::vector<std::size_t> at(axes.size(), 0);
  std::vector<double> arguments(axes.size());
  while (true) {
    for (std::size_t k = 0; k < axes.size(); ++k) arguments[k] = axes[k][at[k]];
    if (!visit(arguments)) return;
    std::size_t k = 0;
    while (k < axes.size() && ++at[k] == axes[k].size()) at[k++] = 0;
    if (k == axes.size()) return;
  }
}

/// The points of each variable at which a law is judged.
std::vector<std::vector<double>> grid(std::span<const LawVariable> variables, const std::vector<bool>& used,
                                      std::vector<double> numbers) {
  const auto count = static_cast<double>(std::ranges::count(used, true));
  if (count > 2) numbers.clear(); // the grid would be too large
  const auto points = 2 * static_cast<std::size_t>(0.4 * std::pow(most_points, 1.0 / std::max(1.0, count))) + 1;
  std::vector<std::vector<double>> axes;
  for (std::size_t k = 0; k < variables.size(); ++k)
    axes.push_back(used[k] ? axis(variables[k], points, numbers) : std::vector<double>{variables[k].usual});
  return axes;
}

} // namespace

std::vector<double> law_numbers(const Row& law, const Parameters& p) {
  std::vector<double> all = numbers_in(law_formula(law, p, text_of(law, p)).tree(), law_names(law, p));
  const std::size_t count = all.size();
  for (std::size_t k = 0; k < count; ++k) all.push_back(-all[k]);
  return all;
}

std::vector<std::string> steady_comparisons(const Parameters& p, const Row& law) {
  const std::vector<LawVariable> variables = law_variables(law, text_of(law, p), p);
  const fields::Expression whole = law_formula(law, p, text_of(law, p), variables);
  std::vector<std::string> found;
  fields::for_each_part(whole.tree().whole, [&](const fields::Part& part) {
    if (!fields::is_comparison(part)) return;
    const fields::Expression comparison = law_formula(law, p, fields::written(part), variables);
    const std::vector<bool> used = used_by(comparison, variables);
    if (std::ranges::find(used, true) == used.end()) return; // of constants alone
    bool some = false, all = true;
    over_grid(grid(variables, used, {}), [&](const std::vector<double>& arguments) {
      const bool holds = comparison.at(arguments) != 0.0;
      some = some || holds;
      all = all && holds;
      return all || !some;
    });
    if (some && !all) return;
    std::string where;
    for (std::size_t k = 0; k < used.size(); ++k)
      if (used[k])
        where += fmt::format("{}{} from {}", where.empty() ? "" : ", ", variables[k].name, range_text(variables[k]));
    found.push_back(fmt::format("{}, at character {}, {} wherever the law is judged ({}, on a grid)",
                                fields::written(part), part.at, all ? "holds" : "does not hold", where));
  });
  return found;
}

std::string fault_of_law_values(const Parameters& p, const Row& law) {
  const std::vector<LawVariable> variables = law_variables(law, text_of(law, p), p);
  const fields::Expression formula = law_formula(law, p, text_of(law, p), variables);
  if (!formula.tree().chained.empty()) return formula.tree().chained;
  const std::vector<bool> used = used_by(formula, variables);
  const std::vector<std::vector<double>> axes = grid(variables, used, numbers_in(formula.tree(), law_names(law, p)));
  const auto excess = [&](double value) { return std::max(law.range.low - value, value - law.range.high); };
  std::vector<double> worst; // its arguments
  double most = 0.0;
  over_grid(axes, [&](const std::vector<double>& arguments) {
    const double value = formula.at(arguments);
    if (!in_range(law, value) && (worst.empty() || !std::isfinite(value) || excess(value) > most)) {
      worst = arguments;
      most = excess(value);
    }
    return std::isfinite(value);
  });
  if (worst.empty())
    return fault_of_units(formula.tree().whole, law_dimensions(law, p), units::parse_unit(law.unit).dimension);
  const double value = formula.at(worst);
  const std::string place = std::isfinite(value) ? "" : place_of_fault(law, p, variables, formula.tree(), worst);
  return law_fault(law, value, law_arguments(variables, worst, used) + place);
}

std::string values_rule(const Row& row) { return fmt::format("the values of {} are allowed", row.path); }

std::vector<std::string_view> keys_of_law(const Row& law) {
  std::vector<std::string_view> keys{law.path, "laws.constants"};
  for (const Row& row : schema())
    if (!row.symbol.empty() && section_of(row) != "run") keys.push_back(row.path);
  return keys;
}

std::vector<Rule> rules_of_law_values() {
  std::vector<Rule> rules;
  for (const Row& law : law_rows())
    rules.push_back({values_rule(law),
                     keys_of_law(law),
                     [&law](const Parameters& p) { return fault_of_law_values(p, law); },
                     {readable_rule(law)},
                     [&law](const Parameters& p) { return is_changed(law, p); },
                     true});
  return rules;
}

} // namespace matrigrate
