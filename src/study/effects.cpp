#include "study/effects.hpp"
#include "parameters/schema.hpp"
#include "parameters/units.hpp"
#include "study/comparison.hpp"
#include "study/names.hpp"
#include <fmt/format.h>

#include "statistics/bootstrap.hpp"
#include "statistics/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace matrigrate::study {

namespace {

using statistics::Interval;
using statistics::undefined;

constexpr Interval nothing{undefined, undefined, undefined};

/// Steps of Morris' design by factor.
using Trajectories = std::map<std::string, std::vector<const Step*>>;

class Effects {
public:
  Effects(const Study& study, const std::vector<Result>& results) : m_study(study), m_judge(study, results) {
    for (const Step& step : study.steps) {
      if (step.design != Design::morris) continue;
      m_morris[step.factor].push_back(&step);
      m_trajectories = std::max(m_trajectories, step.trajectory);
    }
  }

  std::vector<Effect> all() {
    std::vector<Effect> found;
    if (!m_study.targets.empty()) {
      take(one_at_a_time_of_discrepancy(), found);
      take(morris_of_discrepancy(), found);
    }
    for (const std::string& readout : m_study.readouts) {
      for (std::size_t c = 0; c < m_study.points_of_set(); ++c) take(one_at_a_time(readout, c), found);
      for (std::size_t c = 0; c < m_study.points_of_set(); ++c) take(morris(readout, c), found);
    }
    return found;
  }

private:
  /// Ranks effects that can be compared, and puts them behind the others.
  static void take(std::vector<Effect> some, std::vector<Effect>& all) {
    std::ranges::stable_sort(some, [](const Effect& a, const Effect& b) {
      const double x = std::abs(a.ranked().value);
      const double y = std::abs(b.ranked().value);
      return std::isnan(y) ? !std::isnan(x) : x > y;
    });
    for (std::size_t i = 0; i < some.size(); ++i) some[i].rank = std::isnan(some[i].ranked().value) ? 0 : i + 1;
    std::ranges::move(some, std::back_inserter(all));
  }

  std::optional<std::size_t> condition(std::size_t c) const {
    return m_study.conditions.empty() ? std::nullopt : std::optional(c);
  }

  std::string value_of(const Step& step) const {
    for (const Setting& s : m_study.sets[step.to].settings)
      if (s.key == step.factor) return s.value;
    return {};
  }

  Effect empty(const Step& step, const std::string& readout, std::optional<std::size_t> c) const {
    return {.design = step.design,
            .factor = step.factor,
            .value = step.design == Design::morris ? std::string() : value_of(step),
            .readout = readout,
            .condition = c};
  }

  std::vector<Effect> one_at_a_time(const std::string& readout, std::size_t c) const {
    const std::size_t column = readout_column(readout);
    std::vector<Effect> found;
    for (const Step& step : m_study.steps) {
      if (step.design != Design::one_at_a_time) continue;
      Effect effect = empty(step, readout, condition(c));
      const auto base = m_judge.replicates(m_study.point_at(step.from, c), column);
      const auto here = m_judge.replicates(m_study.point_at(step.to, c), column);
      effect.paired = m_study.common_random_numbers;
      if (effect.paired) {
        const std::vector<double> pairs = differences(base, here);
        effect.n = pairs.size();
        effect.effect = statistics::mean_interval(pairs, m_study.comparisons.alpha);
      } else {
        const std::vector<double> a = statistics::finite(base);
        const std::vector<double> b = statistics::finite(here);
        effect.n = std::min(a.size(), b.size());
        effect.effect = statistics::mean_difference(a, b, m_study.comparisons.alpha, false);
      }
      found.push_back(std::move(effect));
    }
    return found;
  }

  /// Over the replicates that have a value at both points.
  static std::vector<double> differences(const std::vector<double>& from, const std::vector<double>& to) {
    std::vector<double> all;
    for (std::size_t i = 0; i < std::min(from.size(), to.size()); ++i) all.push_back(to[i] - from[i]);
    return statistics::finite(all);
  }

  static bool judged_alike(const Discrepancy& a, const Discrepancy& b) {
    return a.judged > 0 && std::ranges::equal(a.terms, b.terms, [](const Judged& x, const Judged& y) {
             return std::isnan(x.z) == std::isnan(y.z);
           });
  }

  std::vector<Effect> one_at_a_time_of_discrepancy() {
    std::vector<Effect> found;
    std::map<std::size_t, std::vector<double>> bases; // draws
    for (const Step& step : m_study.steps) {
      if (step.design != Design::one_at_a_time) continue;
      Effect effect = empty(step, std::string(discrepancy_readout), std::nullopt);
      effect.effect = nothing;
      effect.paired = m_study.common_random_numbers;
      const Discrepancy& from = discrepancy(step.from);
      const Discrepancy& to = discrepancy(step.to);
      if (judged_alike(from, to)) {
        effect.n = to.judged;
        const auto [base, is_new] = bases.try_emplace(step.from);
        if (is_new) base->second = m_judge.draws(step.from);
        std::vector<double> draws = m_judge.draws(step.to);
        for (std::size_t i = 0; i < draws.size(); ++i) draws[i] -= base->second[i];
        effect.effect =
            statistics::percentile_interval(to.value.value - from.value.value, draws, m_study.comparisons.alpha);
      }
      found.push_back(std::move(effect));
    }
    return found;
  }

  /// The effects of each factor, from one number for each step.
  template <class Change>
  std::vector<Effect> of_trajectories(const std::string& readout, std::optional<std::size_t> c, Change change) {
    const std::uint64_t key = run_seed(m_study.seed, {{"trajectories", ""}}, 0);
    std::vector<Effect> found;
    for (const auto& [factor, steps] : m_morris) {
      Effect effect = empty(*steps.front(), readout, c);
      effect.effect = nothing;
      std::vector<double> each(m_trajectories, undefined);
      for (const Step* step : steps) each[step->trajectory - 1] = change(*step) / step->size;
      effect.elementary = statistics::elementary_effects(each, key, m_study.comparisons.alpha);
      effect.n = effect.elementary.n;
      effect.paired = m_study.common_random_numbers;
      found.push_back(std::move(effect));
    }
    return found;
  }

  std::vector<Effect> morris(const std::string& readout, std::size_t c) {
    const std::size_t column = readout_column(readout);
    return of_trajectories(readout, condition(c), [&](const Step& step) {
      const auto from = m_judge.replicates(m_study.point_at(step.from, c), column);
      const auto to = m_judge.replicates(m_study.point_at(step.to, c), column);
      if (m_study.common_random_numbers) return statistics::moments(differences(from, to)).mean;
      return statistics::moments(statistics::finite(to)).mean - statistics::moments(statistics::finite(from)).mean;
    });
  }

  std::vector<Effect> morris_of_discrepancy() {
    return of_trajectories(std::string(discrepancy_readout), std::nullopt, [&](const Step& step) {
      const Discrepancy& from = discrepancy(step.from);
      const Discrepancy& to = discrepancy(step.to);
      return judged_alike(from, to) ? to.value.value - from.value.value : undefined;
    });
  }

  const Discrepancy& discrepancy(std::size_t set) {
    const auto [found, is_new] = m_discrepancies.try_emplace(set);
    if (is_new) found->second = m_judge.discrepancy(set, false);
    return found->second;
  }

  const Study& m_study;
  TargetJudge m_judge;
  Trajectories m_morris;
  std::size_t m_trajectories = 0;
  std::map<std::size_t, Discrepancy> m_discrepancies;
};

} // namespace

std::vector<Effect> effects(const Study& study, const std::vector<Result>& results) {
  return study.steps.empty() ? std::vector<Effect>() : Effects(study, results).all();
}

Screening screening(const Study& study, const std::vector<Result>& results) {
  Screening found;
  found.effects = effects(study, results);
  if (study.targets.empty()) return found;
  const TargetJudge judge(study, results);
  for (std::size_t set = 0; set < study.sets.size(); ++set) found.discrepancies.push_back(judge.discrepancy(set));
  return found;
}

std::string set_text(const Study& study, std::size_t set) {
  const FactorSet& one = study.sets[set];
  const bool counted = one.label.starts_with("sample ") || one.label.starts_with("trajectory ");
  if (!counted || one.settings.empty()) return one.label;
  std::vector<Setting> rounded = one.settings;
  for (Setting& s : rounded) {
    if (kind(*find_row(s.key)) != Kind::quantity) continue;
    std::string bare = s.value;
    std::erase(bare, '"');
    const units::Quantity quantity = units::parse_quantity(bare);
    s.value = fmt::format("{:g} {}", std::stod(fmt::format("{:.3g}", std::stod(quantity.number))), quantity.unit);
  }
  return label_of(rounded, Names(study));
}

std::string point_text(const Study& study, std::size_t point) {
  const Point& one = study.points[point];
  const std::string text = set_text(study, one.set);
  if (text == study.sets[one.set].label) return one.label;
  return study.conditions.empty() ? text : fmt::format("{}: {}", study.conditions[one.condition].label, text);
}

bool has_interval(const Study& study, const Effect& effect) {
  const std::size_t n =
      effect.design == Design::morris || effect.readout != discrepancy_readout ? effect.n : study.replicates;
  return n >= least_runs;
}

} // namespace matrigrate::study
