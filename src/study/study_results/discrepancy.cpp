#include "study_results/discrepancy.hpp"

#include "statistics/bootstrap.hpp"
#include "statistics/distributions.hpp"
#include "statistics/sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace matrigrate::study {

using statistics::undefined;

std::vector<Term> terms(const Study& study) {
  std::vector<Term> all;
  for (std::size_t t = 0; t < study.targets.size(); ++t)
    for (std::size_t c = 0; c < study.points_of_set(); ++c) {
      const std::vector<std::size_t>& at = study.targets[t].at;
      if (at.empty() || std::ranges::find(at, c) != at.end()) all.push_back({t, c});
    }
  return all;
}

std::string term_name(const Study& study, const Term& term) {
  const std::string& readout = study.targets[term.target].readout;
  return study.conditions.empty() ? readout : fmt::format("{}_at_{}", readout, study.conditions[term.condition].label);
}

std::string target_text(const Target& t) {
  return t.low == t.high ? fmt::format("{} +- {}", t.low, t.error)
                         : fmt::format("{} to {} +- {}", t.low, t.high, t.error);
}

double distance(const Target& target, double mean, double standard_error) {
  const double off = mean - std::clamp(mean, target.low, target.high);
  return off / std::sqrt(target.error * target.error + standard_error * standard_error);
}

double distance(const Target& target, statistics::Values sample) {
  const statistics::Moments m = statistics::moments(sample);
  return m.n < 2 ? undefined : distance(target, m.mean, m.sd / std::sqrt(static_cast<double>(m.n)));
}

double distance_of_run(const std::vector<Target>& targets, const std::vector<double>& z) {
  double squares = 0.0;
  double weights = 0.0;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    squares += targets[k].weight * z[k] * z[k];
    weights += targets[k].weight;
  }
  return std::sqrt(squares / weights);
}

TargetJudge::TargetJudge(const Study& study, const std::vector<Result>& results)
    : m_study(study), m_terms(terms(study)) {
  for (const Term& term : m_terms) m_columns.push_back(readout_column(study.targets[term.target].readout));
  m_results.resize(study.points.size());
  for (const Result& r : results) {
    std::vector<const Result*>& there = m_results.at(r.run.point);
    if (there.size() < r.run.replicate) there.resize(r.run.replicate, nullptr);
    there[r.run.replicate - 1] = &r;
  }
}

std::vector<double> TargetJudge::replicates(std::size_t point, std::size_t readout) const {
  std::vector<double> values;
  for (const Result* r : m_results[point])
    values.push_back(r != nullptr && r->standing.done() ? r->readouts[readout] : undefined);
  return values;
}

double TargetJudge::combined(const std::vector<double>& z) const {
  double squares = 0.0;
  double weights = 0.0;
  for (std::size_t k = 0; k < z.size(); ++k) {
    if (std::isnan(z[k])) continue;
    const double weight = m_study.targets[m_terms[k].target].weight;
    squares += weight * z[k] * z[k];
    weights += weight;
  }
  return weights > 0.0 ? std::sqrt(squares / weights) : undefined;
}

Discrepancy TargetJudge::discrepancy(std::size_t set) const {
  Discrepancy d{set, {undefined, undefined, undefined}, 0, {}};
  std::vector<double> z;
  for (std::size_t k = 0; k < m_terms.size(); ++k) {
    const std::size_t point = m_study.point_at(set, m_terms[k].condition);
    const std::vector<double> values = statistics::finite(replicates(point, m_columns[k]));
    const auto finished = static_cast<std::size_t>(
        std::ranges::count_if(m_results[point], [](const Result* r) { return r != nullptr && r->standing.done(); }));
    z.push_back(distance(m_study.targets[m_terms[k].target], values));
    d.terms.push_back({values.size(), finished - values.size(), statistics::moments(values).mean, z.back()});
    d.judged += std::isnan(z.back()) ? 0 : 1;
  }
  d.value.value = combined(z);
  if (d.judged > 0) d.value = statistics::percentile_interval(d.value.value, draws(set), m_study.comparisons.alpha);
  return d;
}

std::vector<double> TargetJudge::draws(std::size_t set) const {
  struct Sample {
    const Target& target;
    std::vector<double> values;
    double standard_error;
    std::uint64_t key;
    bool judged;
  };
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < m_terms.size(); ++k) {
    const std::size_t point = m_study.point_at(set, m_terms[k].condition);
    const Target& target = m_study.targets[m_terms[k].target];
    const std::vector<double> values = replicates(point, m_columns[k]);
    const statistics::Moments m = statistics::moments(statistics::finite(values));
    const auto settings = m_study.common_random_numbers ? std::vector<Setting>() : m_study.points[point].settings;
    samples.push_back({target, values, m.sd / std::sqrt(static_cast<double>(m.n)),
                       run_seed(m_study.seed, settings, 0), // replicate 0 is that of no run
                       m.n >= 2});
  }
  std::vector<double> all;
  for (std::size_t draw = 0; draw < statistics::bootstrap_draws; ++draw) {
    std::vector<double> z;
    bool complete = true;
    for (const Sample& s : samples) {
      z.push_back(undefined);
      if (!s.judged) continue;
      const auto indices = statistics::resampled(s.values.size(), s.key, draw);
      const auto drawn = statistics::finite(statistics::picked(s.values, indices));
      z.back() = distance(s.target, statistics::moments(drawn).mean, s.standard_error);
      complete = complete && !std::isnan(z.back());
    }
    all.push_back(complete ? combined(z) : undefined);
  }
  return all;
}

std::vector<Discrepancy> discrepancies(const Study& study, const std::vector<Result>& results) {
  std::vector<Discrepancy> all;
  if (study.targets.empty()) return all;
  const TargetJudge judge(study, results);
  for (std::size_t set = 0; set < study.sets.size(); ++set) all.push_back(judge.discrepancy(set));
  return all;
}

std::vector<std::size_t> ranking(const std::vector<Discrepancy>& all) {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    if (all[a].judged != all[b].judged) return all[a].judged > all[b].judged;
    return all[a].value.value < all[b].value.value;
  });
  return order;
}

} // namespace matrigrate::study
