#include "study_report/screening_data.hpp"

#include "study/comparison.hpp"
#include "study/design/designs.hpp"
#include "study/names.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
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

std::string bare(std::string value) {
  std::erase(value, '"');
  return value;
}

Json effect_json(const Study& study, const Names& names, const Effect& e) {
  Json json{{"design", name(e.design)},
            {"readout", e.readout},
            {"condition", e.condition ? study.conditions[*e.condition].label : ""},
            {"factor", e.factor},
            {"label", names.of(e.factor)},
            {"value", bare(e.value)},
            {"n", e.n}};
  if (e.design == Design::one_at_a_time) {
    json["effect"] = e.effect.value;
    json["interval"] = bounds(e.effect, has_interval(study, e));
    return json;
  }
  const statistics::ElementaryEffects& elementary = e.elementary;
  json["mu"] = elementary.mu.value;
  json["mu_star"] = elementary.mu_star.value;
  json["mu_star_interval"] = bounds(elementary.mu_star, has_interval(study, e));
  json["sigma"] = elementary.sigma.value;
  json["sigma_interval"] = bounds(elementary.sigma, has_interval(study, e));
  return json;
}

std::string interval_text(const statistics::Interval& i, bool enough) {
  return enough && std::isfinite(i.low) && std::isfinite(i.high)
             ? fmt::format("{:.3g} ({:.3g} to {:.3g})", i.value, i.low, i.high)
             : fmt::format("{:.3g}", i.value);
}

} // namespace

Json screening_json(const Study& study, const Screening& screening) {
  if (screening.discrepancies.empty() && screening.effects.empty()) return {};
  Json effects = Json::array();
  const Names names(study);
  for (const Effect& e : screening.effects) effects.push_back(effect_json(study, names, e));
  return {{"confidence", 1.0 - study.comparisons.alpha},
          {"paired", study.common_random_numbers},
          {"targets", targets_json(study)},
          {"sets", sets_json(study, screening.discrepancies)},
          {"effects", std::move(effects)}};
}

std::string screening_sentence(const Study& study, const Screening& screening) {
  std::string text;
  const std::vector<std::size_t> order = ranking(screening.discrepancies);
  if (!order.empty() && screening.discrepancies[order.front()].judged > 0) {
    const Discrepancy& best = screening.discrepancies[order.front()];
    text += fmt::format(" The discrepancy is least, {}, at {}.",
                        interval_text(best.value, study.replicates >= least_runs), set_text(study, best.set));
  }
  const auto first = std::ranges::find(screening.effects, 1U, &Effect::rank);
  if (first == screening.effects.end()) return text;
  const std::string value = bare(first->value);
  return text
         + fmt::format(" The largest effect on {}{} is that of {}{}: {}{}.", first->readout,
                       first->condition ? " at " + study.conditions[*first->condition].label : std::string(),
                       Names(study).of(first->factor), value.empty() ? "" : " " + value,
                       first->design == Design::morris ? "mu* " : "",
                       interval_text(first->ranked(), has_interval(study, *first)));
}

} // namespace matrigrate::study
