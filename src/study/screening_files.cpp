#include "store/row_file.hpp"
#include "study/design/designs.hpp"
#include "study/effects.hpp"

#include <algorithm>

namespace matrigrate::study {

namespace {

using store::count;
using store::csv_line;
using store::Field;
using View = std::string_view;

/// A value as it stands in a scenario, without the quotes of a string.
std::string bare(std::string value) {
  std::erase(value, '"');
  return value;
}

void append(const statistics::Interval& i, std::vector<Field>& row) { row.insert(row.end(), {i.value, i.low, i.high}); }

} // namespace

std::string discrepancy_csv(const Study& study, const std::vector<Discrepancy>& all) {
  const std::vector<Term> judged_by = terms(study);
  std::vector<std::string> keys; // that differ between sets, of which conditions are no part
  for (const FactorSet& set : study.sets)
    for (const Setting& s : set.settings)
      if (std::ranges::find(keys, s.key) == keys.end()) keys.push_back(s.key);
  const std::vector<std::string> swept = swept_keys(study);
  const std::vector<std::string> columns = swept_columns(study);
  std::vector<std::string> names{"rank", "set"};
  for (std::size_t k = 0; k < swept.size(); ++k)
    if (std::ranges::find(keys, swept[k]) != keys.end()) names.push_back(columns[k]);
  for (const char* name :
       {"discrepancy", "discrepancy_low", "discrepancy_high", "targets_judged", "targets", "values_undefined"})
    names.emplace_back(name);
  for (const Term& term : judged_by) names.push_back("z_" + term_name(study, term));
  for (const Term& term : judged_by) names.push_back("mean_" + term_name(study, term));
  std::string text = csv_line({names.begin(), names.end()});
  std::size_t rank = 0;
  for (const std::size_t i : ranking(all)) {
    const Discrepancy& d = all[i];
    const std::vector<std::string> values = swept_values(study, study.points[study.point_at(d.set, 0)]);
    std::vector<Field> row{count(++rank), View(study.sets[d.set].label)};
    for (std::size_t k = 0; k < swept.size(); ++k)
      if (std::ranges::find(keys, swept[k]) != keys.end()) row.emplace_back(View(values[k]));
    append(d.value, row);
    std::size_t undefined = 0;
    for (const Judged& judged : d.terms) undefined += judged.undefined;
    row.insert(row.end(), {count(d.judged), count(judged_by.size()), count(undefined)});
    for (const Judged& judged : d.terms) row.emplace_back(judged.z);
    for (const Judged& judged : d.terms) row.emplace_back(judged.mean);
    text += csv_line(row);
  }
  return text;
}

std::string effects_csv(const Study& study, const std::vector<Effect>& effects) {
  std::string text =
      csv_line({View("design"),      View("readout"),      View("condition"), View("rank"),      View("factor"),
                View("value"),       View("paired"),       View("n"),         View("effect"),    View("effect_low"),
                View("effect_high"), View("mu"),           View("mu_low"),    View("mu_high"),   View("mu_star"),
                View("mu_star_low"), View("mu_star_high"), View("sigma"),     View("sigma_low"), View("sigma_high")});
  for (const Effect& e : effects) {
    const std::string design = name(e.design);
    const std::string value = bare(e.value);
    const std::string condition = e.condition ? study.conditions[*e.condition].label : std::string();
    std::vector<Field> row{View(design),
                           View(e.readout),
                           View(condition),
                           count(e.rank),
                           View(e.factor),
                           View(value),
                           View(e.paired ? "true" : "false"),
                           count(e.n)};
    append(e.effect, row);
    if (e.design == Design::morris) {
      append(e.elementary.mu, row);
      append(e.elementary.mu_star, row);
      append(e.elementary.sigma, row);
    } else {
      row.insert(row.end(), 9, View());
    }
    text += csv_line(row);
  }
  return text;
}

} // namespace matrigrate::study
