#include "study_results/discrepancy.hpp"
#include "tables/table.hpp"

#include <algorithm>

namespace matrigrate::study {

namespace {

using store::count;
using store::csv_line;
using store::Field;
using View = std::string_view;

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
    row.insert(row.end(), {d.value.value, d.value.low, d.value.high});
    std::size_t undefined = 0;
    for (const Judged& judged : d.terms) undefined += judged.undefined;
    row.insert(row.end(), {count(d.judged), count(judged_by.size()), count(undefined)});
    for (const Judged& judged : d.terms) row.emplace_back(judged.z);
    for (const Judged& judged : d.terms) row.emplace_back(judged.mean);
    text += csv_line(row);
  }
  return text;
}

} // namespace matrigrate::study
