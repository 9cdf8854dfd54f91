#include "parameters/laws/law_curves.hpp"

#include "parameters/laws/law.hpp"

#include <algorithm>

namespace matrigrate {

namespace {

/// The arguments that a law is drawn over: those that it depends on; else the first that the default depends on, or the
/// first of all.
std::vector<std::size_t> drawn_over(const Row& law, const fields::Expression& changed,
                                    const fields::Expression& usual) {
  std::vector<std::size_t> found;
  for (const fields::Expression* formula : {&changed, &usual})
    for (std::size_t k = 0; k < law.arguments.size() && (formula == &changed || found.empty()); ++k)
      if (formula->uses(k)) found.push_back(k);
  if (found.empty()) found.push_back(0);
  return found;
}

} // namespace

std::vector<LawCurve> law_curves(const Parameters& p, const Row& law, std::size_t points) {
  const fields::Expression changed = law_formula(law, p, text_of(law, p));
  const fields::Expression usual = law_formula(law, p, usual_text(law));
  std::vector<LawCurve> curves;
  for (const std::size_t over : drawn_over(law, changed, usual)) {
    LawCurve curve{.over = law.arguments[over], .at = {}, .x = {}, .usual = {}, .changed = {}};
    std::vector<double> at;
    std::vector<bool> held;
    for (std::size_t k = 0; k < law.arguments.size(); ++k) {
      at.push_back(law.arguments[k].usual);
      held.push_back(k != over && (changed.uses(k) || usual.uses(k)));
    }
    if (std::ranges::find(held, true) != held.end()) curve.at = law_arguments(law, at, held);
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

} // namespace matrigrate
