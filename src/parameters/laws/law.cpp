#include "parameters/laws/law.hpp"

#include "base/failure.hpp"
#include "parameters/document.hpp"
#include "parameters/laws/constants.hpp"
#include "parameters/laws/law_names.hpp"
#include "parameters/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>
#include <stdexcept>

namespace matrigrate {

namespace {

std::vector<std::string_view> names_of(std::span<const LawVariable> arguments) {
  std::vector<std::string_view> names;
  for (const LawVariable& argument : arguments) names.push_back(argument.name);
  return names;
}

/// What a law may name, in words: "F, f_mat, t, F_c, your constants and symbols of parameters".
std::string known_names(const Row& law, const Parameters& p) {
  std::string text;
  std::vector<std::string_view> names = names_of(law.arguments);
  std::ranges::copy(names_of(law.shared), std::back_inserter(names));
  for (const LawConstant& constant : p.laws.constants) names.emplace_back(constant.name);
  for (auto name = names.begin(); name != names.end(); ++name)
    if (std::find(names.begin(), name, *name) == name) text += fmt::format("{}, ", *name);
  return fmt::format("; names here are {}{}symbols of parameters; define others in [laws.constants]", text,
                     text.empty() ? "" : "and ");
}

/// The value in its unit: "0.3 nN".
std::string with_unit(double value, std::string_view unit) {
  if (std::isnan(value)) return "not a number";
  return fmt::format("{:.6g}{}{}", value, unit.empty() || unit == "1" ? "" : " ", unit == "1" ? "" : unit);
}

std::set<std::string, std::less<>> names_in(const Row& law, const Parameters& p) {
  std::set<std::string, std::less<>> names;
  fields::for_each_part(law_formula(law, p, text_of(law, p)).tree().whole, [&](const fields::Part& part) {
    if (part.kind == fields::Part::Kind::name) names.insert(part.text);
  });
  return names;
}

/// "time, your constant, which is also an argument of a law": the names in a law that came_later(), and are constants.
std::vector<std::string> names_of_two(const Row& law, const Parameters& p) {
  std::vector<std::string> found;
  for (const std::string& name : names_in(law, p))
    if (came_later(name) && find_constant(name, p) != nullptr)
      found.push_back(fmt::format("{}, your constant, which is also {}", name, owner_of_name(name)));
  return found;
}

/// The arguments that a law is drawn over: those that it depends on; else the first that the default depends on, or the
/// first of all.
std::vector<std::size_t> drawn_over(const std::vector<bool>& changed, const std::vector<bool>& usual) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < changed.size(); ++k)
    if (changed[k]) found.push_back(k);
  const auto first = std::ranges::find(usual, true);
  if (found.empty()) found.push_back(first == usual.end() ? 0 : static_cast<std::size_t>(first - usual.begin()));
  return found;
}

} // namespace

std::vector<LawVariable> law_variables(const Row& law, std::string_view text, const Parameters& p) {
  std::vector<LawVariable> found(law.arguments.begin(), law.arguments.end());
  const auto in_name = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (auto begin = std::ranges::find_if(text, in_name); begin != text.end();) {
    const auto end = std::find_if_not(begin, text.end(), in_name);
    const auto shared = std::ranges::find(
        law.shared, text.substr(static_cast<std::size_t>(begin - text.begin()), static_cast<std::size_t>(end - begin)),
        &LawVariable::name);
    if (shared != law.shared.end() && std::ranges::find(found, shared->name, &LawVariable::name) == found.end())
      found.push_back(*shared);
    begin = std::find_if(end, text.end(), in_name);
  }
  if (puts_constants_first(law))
    std::erase_if(found, [&](const LawVariable& one) { return find_constant(one.name, p) != nullptr; });
  return found;
}

fields::Expression law_formula(const Row& law, const Parameters& p, const std::string& text,
                               std::span<const LawVariable> variables) {
  const std::vector<std::string_view> arguments = names_of(variables);
  std::vector<fields::NamedNumber> names = law_names(law, p);
  std::erase_if(names, [&](const fields::NamedNumber& one) {
    return std::ranges::find(variables, one.name, &LawVariable::name) != variables.end();
  });
  try {
    return {text, arguments, names};
  } catch (const fields::UnknownName& error) {
    std::vector<std::string> known(arguments.begin(), arguments.end());
    for (const LawVariable& shared : law.shared) known.emplace_back(shared.name);
    for (const fields::NamedNumber& name : names) known.push_back(name.name);
    constexpr std::size_t telling = 3; // letters: of fewer any other name is near
    const std::string meant = error.name.size() < telling ? "" : did_you_mean(nearest(error.name, known));
    refuse("{}{}", error.what(), meant.empty() ? known_names(law, p) : meant);
  }
}

fields::Expression law_formula(const Row& law, const Parameters& p, const std::string& text) {
  return law_formula(law, p, text, law_variables(law, text, p));
}

std::string law_arguments(std::span<const LawVariable> variables, std::span<const double> values,
                          const std::vector<bool>& named) {
  std::string text;
  for (std::size_t k = 0; k < variables.size(); ++k)
    if (named[k])
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", variables[k].name,
                          with_unit(values[k], variables[k].unit));
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

Law::Law(std::string_view path, const Parameters& p)
    : m_row(find_row(path)), m_judged(is_changed(*m_row, p)), m_variables(law_variables(*m_row, text_of(*m_row, p), p)),
      m_formula(law_formula(*m_row, p, text_of(*m_row, p), m_variables)) {
  constexpr std::array members{&LawPlace::x,        &LawPlace::y,      &LawPlace::time,      &LawPlace::density,
                               &LawPlace::pressure, &LawPlace::f_degr, &LawPlace::stiffness, &LawPlace::l,
                               &LawPlace::age,      &LawPlace::t_mat,  &LawPlace::f_mat};
  for (const LawVariable& variable : m_variables)
    if (std::ranges::find(m_row->arguments, variable.name, &LawVariable::name) == m_row->arguments.end())
      m_shared.push_back(
          members.at(std::ranges::find(m_row->shared, variable.name, &LawVariable::name) - m_row->shared.begin()));
}

bool Law::uses(std::string_view argument) const {
  const auto found = std::ranges::find(m_variables, argument, &LawVariable::name);
  return found != m_variables.end() && m_formula.uses(static_cast<std::size_t>(found - m_variables.begin()));
}

bool Law::varies() const {
  return std::ranges::any_of(m_variables, [&](const LawVariable& argument) { return uses(argument.name); });
}

bool Law::uses_matrix() const {
  return std::ranges::any_of(
      std::array{&LawPlace::density, &LawPlace::pressure, &LawPlace::f_degr, &LawPlace::stiffness},
      [&](auto member) { return std::ranges::find(m_shared, member) != m_shared.end(); });
}

double Law::operator()(std::initializer_list<double> own, const LawPlace& place) const {
  return at({own.begin(), own.size()}, place);
}

double Law::at(std::span<const double> own, const LawPlace& place) const {
  std::array<double, 20> values{}; // more than any law has
  std::ranges::copy(own, values.begin());
  for (std::size_t k = 0; k < m_shared.size(); ++k) values[own_count() + k] = place.*m_shared[k];
  const std::span<const double> all(values.data(), m_variables.size());
  const double value = m_formula.at(all);
  if (!m_judged || in_range(*m_row, value)) return value;
  const std::string where = law_arguments(m_variables, all, std::vector<bool>(all.size(), true));
  throw NumericalFailure(FailureCause::law, fmt::format("{} {}", m_row->path, law_fault(*m_row, value, where)));
}

double Law::fall(std::size_t argument, std::initializer_list<double> own, const LawPlace& place) const {
  if (argument >= own_count() || !m_formula.uses(argument)) return 0.0;
  constexpr double step = 1e-6; // of the range that cells usually have
  std::vector<double> there(own);
  const double further = step * (m_variables[argument].drawn_high - m_variables[argument].drawn_low);
  there[argument] += further;
  return std::max(0.0, (at({own.begin(), own.size()}, place) - at(there, place)) / further);
}

Laws::Laws(const Parameters& p)
    : curvature_factor("laws.curvature_factor", p), contraction("laws.contraction", p),
      maturation_force("laws.maturation_force", p), maturation("laws.maturation", p),
      adhesion_stiffness("laws.adhesion_stiffness", p), disassembly_rate("laws.disassembly_rate", p),
      growth_force("laws.growth_force", p), initiation_rate("laws.initiation_rate", p),
      initiation_bias("laws.initiation_bias", p), polarization_rate("laws.polarization_rate", p),
      degradation_tip("laws.degradation_tip", p), degradation_protrusion("laws.degradation_protrusion", p),
      degradation_body("laws.degradation_body", p) {}

std::vector<bool> used_by(const fields::Expression& formula, std::span<const LawVariable> variables) {
  std::vector<bool> used;
  for (std::size_t k = 0; k < variables.size(); ++k) used.push_back(formula.uses(k));
  return used;
}

std::string fault_of_law(const Parameters& p, const Row& law) {
  try {
    const std::vector<std::string> shared = names_of_two(law, p);
    const bool clear = shared.empty() || puts_constants_first(law) || !is_changed(law, p);
    return clear ? "" : fmt::format("names {}; give the constant another name", shared.front());
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

const std::string& usual_text(const Row& law) {
  static const Parameters usual;
  return text_of(law, usual);
}

bool is_changed(const Row& law, const Parameters& p) {
  return text_of(law, p) != usual_text(law) && law_meaning(law, p) != usual_text(law);
}

std::vector<const Row*> changed_laws(const Parameters& p) {
  std::vector<const Row*> changed;
  for (const Row& law : law_rows())
    if (is_changed(law, p)) changed.push_back(&law);
  return changed;
}

std::string constants_of(const Row& law, const Parameters& p) {
  const auto named = names_in(law, p);
  std::string text;
  for (const LawConstant& constant : p.laws.constants)
    if (named.contains(constant.name)) text += (text.empty() ? "" : ", ") + text_of(constant);
  return text;
}

std::vector<LawCurve> law_curves(const Parameters& p, const Row& law, std::size_t points) {
  const std::vector<LawVariable> variables = law_variables(law, text_of(law, p), p);
  const fields::Expression changed = law_formula(law, p, text_of(law, p), variables);
  const fields::Expression usual = law_formula(law, p, usual_text(law), variables);
  const std::vector<bool> by_changed = used_by(changed, variables), by_usual = used_by(usual, variables);
  std::vector<LawCurve> curves;
  for (const std::size_t over : drawn_over(by_changed, by_usual)) {
    LawCurve curve{.over = variables[over], .at = {}, .x = {}, .usual = {}, .changed = {}};
    std::vector<double> at;
    std::vector<bool> held;
    for (std::size_t k = 0; k < variables.size(); ++k) {
      at.push_back(variables[k].usual);
      held.push_back(k != over && (by_changed[k] || by_usual[k]));
    }
    if (std::ranges::find(held, true) != held.end()) curve.at = law_arguments(variables, at, held);
    for (std::size_t k = 0; k < points; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(points - 1);
      at[over] = curve.over.drawn_low + (curve.over.drawn_high - curve.over.drawn_low) * share;
      curve.x.push_back(at[over]);
      curve.usual.push_back(usual.at(at));
      curve.changed.push_back(changed.at(at));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<std::string> law_notes(const Parameters& p) {
  std::vector<std::string> notes;
  std::set<std::string, std::less<>> named;
  for (const Row* law : changed_laws(p)) {
    named.merge(names_in(*law, p));
    for (const std::string& both : names_of_two(*law, p))
      notes.push_back(fmt::format("{} names {}; to use that, give the constant another name", law->path, both));
    for (const std::string& never : steady_comparisons(p, *law))
      notes.push_back(fmt::format("{}: {}", law->path, never));
  }
  for (const LawConstant& constant : p.laws.constants)
    if (!named.contains(constant.name))
      notes.push_back(fmt::format("laws.constants: {} stands in no law that differs from the default", constant.name));
  return notes;
}

} // namespace matrigrate
