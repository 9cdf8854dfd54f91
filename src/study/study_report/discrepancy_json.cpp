#include "study_report/discrepancy_json.hpp"

#include "study_plan/names.hpp"
#include "study_results/comparison.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace matrigrate::study {

namespace {

using Json = nlohmann::ordered_json; // NaN is written as null

/// Null where there is too little behind it.
Json bounds(const statistics::Interval& i, bool enough) {
  return enough && std::isfinite(i.low) && std::isfinite(i.high) ? Json{i.low, i.high} : Json();
}

Json targets_json(const Study& study) {
  Json list = Json::array();
  for (const Term& term : terms(study)) {
    const Target& target = study.targets[term.target];
    list.push_back({{"readout", target.readout},
                    {"condition", study.conditions.empty() ? "" : study.conditions[term.condition].label},
                    {"target", target_text(target)},
                    {"weight", target.weight}});
  }
  return list;
}

Json sets_json(const Study& study, const std::vector<Discrepancy>& all) {
  Json list = Json::array();
  const Names names(study);
  for (const std::size_t i : ranking(all)) {
    Json z = Json::array();
    Json means = Json::array();
    std::size_t undefined = 0;
    for (const Judged& judged : all[i].terms) {
      z.push_back(judged.z);
      means.push_back(judged.mean);
      undefined += judged.undefined;
    }
    const FactorSet& set = study.sets[all[i].set];
    list.push_back({{"label", set.label},
                    {"settings", set.settings.empty() ? std::string() : label_of(set.settings, names)},
                    {"discrepancy", all[i].value.value},
                    {"interval", bounds(all[i].value, study.replicates >= least_runs)},
                    {"judged", all[i].judged},
                    {"undefined", undefined},
                    {"z", z},
                    {"means", means}});
  }
  return list;
}

std::string interval_text(const statistics::Interval& i, bool enough) {
  return enough && std::isfinite(i.low) && std::isfinite(i.high)
             ? fmt::format("{:.3g} ({:.3g} to {:.3g})", i.value, i.low, i.high)
             : fmt::format("{:.3g}", i.value);
}

} // namespace

Json discrepancy_json(const Study& study, const std::vector<Discrepancy>& all) {
  if (all.empty()) return {};
  return {
      {"confidence", 1.0 - study.comparisons.alpha}, {"targets", targets_json(study)}, {"sets", sets_json(study, all)}};
}

std::string discrepancy_sentence(const Study& study, const std::vector<Discrepancy>& all) {
  const std::vector<std::size_t> order = ranking(all);
  if (order.empty() || all[order.front()].judged == 0) return {};
  const Discrepancy& best = all[order.front()];
  return fmt::format(" The discrepancy is least, {}, at {}.", interval_text(best.value, study.replicates >= least_runs),
                     set_text(study, best.set));
}

} // namespace matrigrate::study
