#include "study/judge.hpp"

#include "statistics/compare.hpp"
#include "statistics/correlation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matrigrate::study {

namespace {

constexpr double alpha = 0.05;

std::string_view word(Sign sign) { return sign == Sign::up ? "above" : "below"; }
bool has(Sign sign, double value) { return sign == Sign::up ? value > 0.0 : value < 0.0; }

} // namespace

std::vector<double> Judge::values(Group g, std::string_view readout) {
  const auto found = m_evidence.find(g.study);
  if (found == m_evidence.end() || g.point >= found->second.study.points.size()) return {};
  std::vector<double> x = sample(found->second.results, g.point, readout);
  tell(g, readout, x);
  return x;
}

std::vector<double> Judge::column(std::string_view study, std::string_view readout) {
  const auto found = m_evidence.find(study);
  if (found == m_evidence.end()) return {};
  const std::vector<std::string> names = all_readouts();
  const auto index = static_cast<std::size_t>(std::ranges::find(names, readout) - names.begin());
  std::vector<double> x;
  for (const Result& r : found->second.results) x.push_back(r.readouts.at(index));
  return x;
}

std::string Judge::label(Group g) const {
  const auto found = m_evidence.find(g.study);
  if (found == m_evidence.end()) return std::string(g.study);
  const std::string& label = found->second.study.points[g.point].label;
  return m_evidence.size() == 1 ? label : fmt::format("{}: {}", g.study, label);
}

void Judge::tell(Group g, std::string_view readout, const std::vector<double>& x) {
  const statistics::Interval mean = statistics::mean_interval(x, alpha);
  std::string text = fmt::format("{} at {} {:.3g} [{:.3g}, {:.3g}] (n = {})", readout, label(g), mean.value, mean.low,
                                 mean.high, x.size());
  if (std::ranges::find(m_ours, text) == m_ours.end()) m_ours.push_back(std::move(text));
}

void Judge::condition(std::string text, bool defined, bool met) {
  m_defined = m_defined && defined;
  m_met = m_met && met;
  m_conditions.push_back(fmt::format("{}: {}", std::move(text), !defined ? "too few runs" : met ? "met" : "not met"));
}

void Judge::compare(Group a, Group b, std::string_view readout, std::string_view wanted,
                    const std::function<bool(double, double)>& met) {
  const std::vector<double> x = values(a, readout);
  const std::vector<double> y = values(b, readout);
  const statistics::Interval d = statistics::mean_difference(x, y, alpha);
  const statistics::Interval g = statistics::hedges_g(x, y, alpha);
  const double p = statistics::t_test(x, y).p;
  condition(
      fmt::format("{} at {} {} that at {} (difference {:.3g} [{:.3g}, {:.3g}], p {:.2g}, g {:.2g} [{:.2g}, {:.2g}])",
                  readout, label(b), wanted, label(a), d.value, d.low, d.high, p, g.value, g.low, g.high),
      x.size() > 1 && y.size() > 1, met(d.value, p));
}

Judge& Judge::differs(Group a, Group b, std::string_view readout, Sign sign) {
  compare(a, b, readout, fmt::format("significantly {}", word(sign)),
          [&](double d, double p) { return has(sign, d) && p < alpha; });
  return *this;
}

Judge& Judge::same(Group a, Group b, std::string_view readout) {
  compare(a, b, readout, "not significantly different from", [](double, double p) { return !(p < alpha); });
  return *this;
}

Judge& Judge::leans(Group a, Group b, std::string_view readout, Sign sign) {
  compare(a, b, readout, word(sign), [&](double d, double) { return has(sign, d); });
  return *this;
}

Judge& Judge::not_beyond(Group a, Group b, std::string_view readout, Sign sign) {
  compare(a, b, readout, fmt::format("not significantly {}", word(sign)),
          [&](double d, double p) { return !(has(sign, d) && p < alpha); });
  return *this;
}

Judge& Judge::exceeds(Group g, std::string_view low, std::string_view high) {
  std::vector<double> differences;
  if (const auto found = m_evidence.find(g.study); found != m_evidence.end()) {
    values(g, low);
    values(g, high);
    const std::vector<std::string> names = all_readouts();
    const auto column = [&](std::string_view name) {
      return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    };
    for (const Result& r : found->second.results)
      if (r.run.point == g.point) differences.push_back(r.readouts.at(column(high)) - r.readouts.at(column(low)));
  }
  const std::vector<double> both = statistics::finite(differences);
  const statistics::Interval d = statistics::mean_interval(both, alpha);
  condition(fmt::format("{} above {} in the runs at {} (difference {:.3g} [{:.3g}, {:.3g}], n = {})", high, low,
                        label(g), d.value, d.low, d.high, both.size()),
            both.size() > 1, d.low > 0.0);
  return *this;
}

Judge& Judge::agrees(Group g, std::string_view readout, double published, double n_published) {
  const std::vector<double> x = values(g, readout);
  const double p = statistics::published_mean_test(x, published, n_published).p;
  condition(fmt::format("{} at {} agrees with {:.3g} (mean {:.3g}, p {:.2g})", readout, label(g), published,
                        statistics::moments(x).mean, p),
            x.size() > 1, p >= alpha);
  return *this;
}

Judge& Judge::extreme_agrees(std::string_view study, std::size_t points, std::string_view readout, Sign which,
                             double published, double n_published) {
  Group extreme{study, 0};
  double best = statistics::moments(values(extreme, readout)).mean;
  for (std::size_t i = 1; i < points; ++i) {
    const double mean = statistics::moments(values({study, i}, readout)).mean;
    if (!has(which, mean - best)) continue;
    best = mean;
    extreme.point = i;
  }
  return agrees(extreme, readout, published, n_published);
}

Judge& Judge::within(Group g, std::string_view readout, double low, double high) {
  const double mean = statistics::moments(values(g, readout)).mean;
  condition(fmt::format("mean {} at {} is {:.3g}, wanted {:.3g} to {:.3g}", readout, label(g), mean, low, high),
            std::isfinite(mean), mean >= low && mean <= high);
  return *this;
}

Judge& Judge::below(Group g, std::string_view readout, double bound) {
  const statistics::Interval mean = statistics::mean_interval(values(g, readout), alpha);
  condition(
      fmt::format("{} at {} lies below {:.3g} with its interval (up to {:.3g})", readout, label(g), bound, mean.high),
      std::isfinite(mean.high), mean.high < bound);
  return *this;
}

Judge& Judge::ratio_below(Group a, Group b, std::string_view readout, double bound) {
  const double ratio = statistics::moments(values(b, readout)).mean / statistics::moments(values(a, readout)).mean;
  condition(
      fmt::format("{} at {} over that at {} is {:.3g}, wanted below {:.3g}", readout, label(b), label(a), ratio, bound),
      std::isfinite(ratio), ratio < bound);
  return *this;
}

void Judge::correlate(std::string_view study, std::string_view x, std::string_view y, std::string_view wanted,
                      const std::function<bool(double, double)>& met) {
  const statistics::Correlation c = statistics::pearson(column(study, x), column(study, y));
  m_ours.push_back(fmt::format("r of {} and {} {:.2g} (n = {})", x, y, c.r, c.n));
  condition(fmt::format("{} and {} {} over the runs of {} (r {:.2g}, p {:.2g})", x, y, wanted, study, c.r, c.p),
            std::isfinite(c.p), met(c.r, c.p));
}

Judge& Judge::correlates(std::string_view study, std::string_view x, std::string_view y, Sign sign) {
  correlate(study, x, y, sign == Sign::up ? "rise together" : "go against each other",
            [&](double r, double p) { return has(sign, r) && p < alpha; });
  return *this;
}

Judge& Judge::uncorrelated(std::string_view study, std::string_view x, std::string_view y) {
  correlate(study, x, y, "do not correlate", [](double, double p) { return p >= alpha; });
  return *this;
}

Judge& Judge::mean_above(std::string_view study, std::string_view readout, double bound) {
  const std::vector<double> x = statistics::finite(column(study, readout));
  const double mean = statistics::moments(x).mean;
  m_ours.push_back(fmt::format("mean {} {:.3g} (n = {})", readout, mean, x.size()));
  condition(fmt::format("mean {} over the runs of {} is {:.3g}, wanted above {:.3g}", readout, study, mean, bound),
            x.size() > 1, mean > bound);
  return *this;
}

Judge& Judge::none_above(std::string_view study, std::string_view readout, double bound) {
  const std::vector<double> x = statistics::finite(column(study, readout));
  const double most = x.empty() ? NAN : *std::ranges::max_element(x);
  m_ours.push_back(fmt::format("largest {} {:.3g} (n = {})", readout, most, x.size()));
  condition(fmt::format("largest {} over the runs of {} is {:.3g}, wanted at most {:.3g}", readout, study, most, bound),
            x.size() > 1, most <= bound);
  return *this;
}

Finding Judge::finding() const {
  const Verdict verdict = !m_defined || m_conditions.empty() ? Verdict::undecided
                          : m_met                            ? Verdict::holds
                                                             : Verdict::does_not_hold;
  return {verdict, m_ours, m_conditions};
}

std::string to_string(Verdict verdict) {
  return verdict == Verdict::holds ? "holds" : verdict == Verdict::does_not_hold ? "does not hold" : "undecided";
}

} // namespace matrigrate::study
