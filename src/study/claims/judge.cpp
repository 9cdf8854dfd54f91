#include "claims/judge.hpp"

#include "observe/readout_table.hpp"
#include "statistics/compare.hpp"
#include "statistics/correlation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matrigrate::study {

namespace {

constexpr double alpha = 0.05;
constexpr double tenth = 0.1; // of a published mean: as near as it is read off a figure, whatever the scatter

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
  const std::size_t index = readout_column(readout);
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
  std::string text = x.empty()       ? fmt::format("{} at {}: no runs", readout, label(g))
                     : x.size() == 1 ? fmt::format("{} at {} {:.3g} (n = 1)", readout, label(g), mean.value)
                                     : fmt::format("{} at {} {:.3g} [{:.3g}, {:.3g}] (n = {})", readout, label(g),
                                                   mean.value, mean.low, mean.high, x.size());
  if (std::ranges::find(m_ours, text) != m_ours.end()) return;
  m_ours.push_back(std::move(text));
  if (!x.empty())
    m_means.push_back({g, std::string(readout), label(g),
                       x.size() == 1 ? fmt::format("{:.3g}", mean.value)
                                     : fmt::format("{:.3g} [{:.3g}, {:.3g}]", mean.value, mean.low, mean.high)});
}

/// Without what a table has no room for: units of read-outs, the name of the parameter that varies, effect sizes.
std::string Judge::shortened(std::string text) const {
  const auto replace = [&](std::string_view what, std::string_view with) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
      text.replace(at, what.size(), with);
  };
  for (const ReadOutSpec& readout : readout_table()) replace(readout.name, readout.label);
  for (const auto& [name, ensemble] : m_evidence)
    for (const std::string& key : swept_keys(ensemble.study)) replace(key.substr(key.rfind('.') + 1) + " ", "");
  for (std::size_t at; (at = text.find(", g ")) != std::string::npos;) text.erase(at, text.find(']', at) + 1 - at);
  return text;
}

/// All means if they are few, else the first and the last of each read-out, in the order of its points.
std::string Judge::brief() const {
  constexpr std::size_t few = 5;
  std::vector<std::string> parts;
  std::vector<std::string> readouts;
  for (const Mean& m : m_means)
    if (std::ranges::find(readouts, m.readout) == readouts.end()) readouts.push_back(m.readout);
  for (const std::string& readout : readouts) {
    std::vector<const Mean*> of;
    for (const Mean& m : m_means)
      if (m.readout == readout) of.push_back(&m);
    std::ranges::stable_sort(of, {}, [](const Mean* m) { return std::pair(m->group.study, m->group.point); });
    if (m_means.size() > few && of.size() > 2) of = {of.front(), of.back()};
    std::vector<std::string> values;
    for (const Mean* m : of) values.push_back(fmt::format("{} ({})", m->value, shortened(m->label)));
    parts.push_back(fmt::format("{} {}", shortened(readout), fmt::join(values, ", ")));
  }
  for (const std::string& other : m_others) parts.push_back(shortened(other));
  return fmt::format("{}", fmt::join(parts, "; "));
}

void Judge::condition(const std::string& wanted, const std::string& measured, bool defined, bool met, Reading reading) {
  if (m_second) m_again.push_back({shortened(fmt::format("{} ({})", wanted, measured)), defined, met, reading});
  if (!m_first) return;
  m_defined = m_defined && defined;
  m_met = m_met && met;
  m_conditions.push_back(defined ? fmt::format("{} ({}): {}", wanted, measured, met ? "met" : "not met")
                                 : fmt::format("{}: too few runs", wanted));
  constexpr const char* too_few = "too few runs";
  if (defined && !met)
    m_unmet.push_back(shortened(fmt::format("{} ({})", wanted, measured)));
  else if (!defined && std::ranges::find(m_unmet, too_few) == m_unmet.end())
    m_unmet.emplace_back(too_few);
}

void Judge::compare(Group a, Group b, std::string_view readout, std::string_view wanted,
                    const std::function<bool(double, double)>& met,
                    const std::function<Reading(double, double)>& reading) {
  const std::vector<double> x = values(a, readout);
  const std::vector<double> y = values(b, readout);
  const statistics::Interval d = statistics::mean_difference(x, y, alpha);
  const statistics::Interval g = statistics::hedges_g(x, y, alpha);
  const double p = statistics::t_test(x, y).p;
  condition(fmt::format("{} at {} {} that at {}", readout, label(b), wanted, label(a)),
            fmt::format("difference {:.3g} [{:.3g}, {:.3g}], p {:.2g}, g {:.2g} [{:.2g}, {:.2g}]", d.value, d.low,
                        d.high, p, g.value, g.low, g.high),
            x.size() > 1 && y.size() > 1, met(d.value, p), reading(d.value, p));
}

Judge& Judge::differs(Group a, Group b, std::string_view readout, Sign sign) {
  compare(
      a, b, readout, fmt::format("significantly {}", word(sign)),
      [&](double d, double p) { return has(sign, d) && p < alpha; },
      [&](double d, double) { return Reading{.direction = has(sign, d)}; });
  return *this;
}

Judge& Judge::same(Group a, Group b, std::string_view readout) {
  compare(
      a, b, readout, "not significantly different from", [](double, double p) { return !(p < alpha); },
      [](double, double p) { return Reading{.family = Family::no_difference, .p = p}; });
  return *this;
}

Judge& Judge::leans(Group a, Group b, std::string_view readout, Sign sign) {
  compare(
      a, b, readout, word(sign), [&](double d, double) { return has(sign, d); },
      [&](double d, double) { return Reading{.direction = has(sign, d)}; });
  return *this;
}

Judge& Judge::not_beyond(Group a, Group b, std::string_view readout, Sign sign) {
  compare(
      a, b, readout, fmt::format("not significantly {}", word(sign)),
      [&](double d, double p) { return !(has(sign, d) && p < alpha); },
      [&](double d, double p) { return Reading{.family = Family::no_difference, .p = has(sign, d) ? p : 1.0}; });
  return *this;
}

Judge& Judge::exceeds(Group g, std::string_view low, std::string_view high) {
  std::vector<double> differences;
  if (const auto found = m_evidence.find(g.study); found != m_evidence.end()) {
    values(g, low);
    values(g, high);
    for (const Result& r : found->second.results)
      if (r.run.point == g.point)
        differences.push_back(r.readouts.at(readout_column(high)) - r.readouts.at(readout_column(low)));
  }
  const std::vector<double> both = statistics::finite(differences);
  const statistics::Interval d = statistics::mean_interval(both, alpha);
  condition(fmt::format("{} above {} in the runs at {}", high, low, label(g)),
            fmt::format("difference {:.3g} [{:.3g}, {:.3g}], n = {}", d.value, d.low, d.high, both.size()),
            both.size() > 1, d.low > 0.0, {.direction = d.value > 0.0});
  return *this;
}

Judge& Judge::agrees(Group g, std::string_view readout, double published, double n_published) {
  const std::vector<double> x = values(g, readout);
  const double mean = statistics::moments(x).mean;
  const double p = statistics::published_mean_test(x, published, n_published).p;
  condition(fmt::format("{} at {} agrees with {:.3g}", readout, label(g), published),
            fmt::format("mean {:.3g}, p {:.2g}", mean, p), x.size() > 1, p >= alpha,
            {.family = Family::agreement, .p = p, .close = std::abs(mean - published) <= tenth * std::abs(published)});
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
  condition(fmt::format("mean {} at {} is {:.3g} to {:.3g}", readout, label(g), low, high), fmt::format("{:.3g}", mean),
            std::isfinite(mean), mean >= low && mean <= high, {});
  return *this;
}

Judge& Judge::above(Group g, std::string_view readout, double bound) {
  const statistics::Interval mean = statistics::mean_interval(values(g, readout), alpha);
  condition(fmt::format("{} at {} lies above {:.3g} with its interval", readout, label(g), bound),
            fmt::format("from {:.3g}", mean.low), std::isfinite(mean.low), mean.low > bound,
            {.direction = mean.value > bound});
  return *this;
}
Judge& Judge::below(Group g, std::string_view readout, double bound) {
  const statistics::Interval mean = statistics::mean_interval(values(g, readout), alpha);
  condition(fmt::format("{} at {} lies below {:.3g} with its interval", readout, label(g), bound),
            fmt::format("up to {:.3g}", mean.high), std::isfinite(mean.high), mean.high < bound,
            {.direction = mean.value < bound});
  return *this;
}

Judge& Judge::ratio_below(Group a, Group b, std::string_view readout, double bound) {
  const double ratio = statistics::moments(values(b, readout)).mean / statistics::moments(values(a, readout)).mean;
  condition(fmt::format("{} at {} over that at {} is below {:.3g}", readout, label(b), label(a), bound),
            fmt::format("{:.3g}", ratio), std::isfinite(ratio), ratio < bound, {.direction = ratio < bound});
  return *this;
}

void Judge::correlate(std::string_view study, std::string_view x, std::string_view y, std::string_view wanted,
                      const std::function<bool(double, double)>& met, const std::function<Reading(double)>& reading) {
  const statistics::Correlation c = statistics::pearson(column(study, x), column(study, y));
  if (std::isfinite(c.r)) {
    m_ours.push_back(fmt::format("r of {} and {} {:.2g} (n = {})", x, y, c.r, c.n));
    m_others.push_back(m_ours.back());
  }
  condition(fmt::format("{} and {} {} over the runs of {}", x, y, wanted, study),
            fmt::format("r {:.2g}, p {:.2g}", c.r, c.p), std::isfinite(c.p), met(c.r, c.p), reading(c.r));
}

Judge& Judge::correlates(std::string_view study, std::string_view x, std::string_view y, Sign sign) {
  correlate(
      study, x, y, sign == Sign::up ? "rise together" : "go against each other",
      [&](double r, double p) { return has(sign, r) && p < alpha; },
      [&](double r) { return Reading{.direction = has(sign, r)}; });
  return *this;
}

Judge& Judge::uncorrelated(std::string_view study, std::string_view x, std::string_view y) {
  correlate(
      study, x, y, "do not correlate", [](double, double p) { return p >= alpha; }, [](double) { return Reading{}; });
  return *this;
}

Judge& Judge::mean_above(std::string_view study, std::string_view readout, double bound) {
  const std::vector<double> x = statistics::finite(column(study, readout));
  const double mean = statistics::moments(x).mean;
  if (!x.empty()) {
    m_ours.push_back(fmt::format("mean {} {:.3g} (n = {})", readout, mean, x.size()));
    m_others.push_back(m_ours.back());
  }
  condition(fmt::format("mean {} over the runs of {} is above {:.3g}", readout, study, bound),
            fmt::format("{:.3g}", mean), x.size() > 1, mean > bound, {});
  return *this;
}

Judge& Judge::none_above(std::string_view study, std::string_view readout, double bound) {
  const std::vector<double> x = statistics::finite(column(study, readout));
  const double most = x.empty() ? NAN : *std::ranges::max_element(x);
  if (!x.empty()) {
    m_ours.push_back(fmt::format("largest {} {:.3g} (n = {})", readout, most, x.size()));
    m_others.push_back(m_ours.back());
  }
  condition(fmt::format("largest {} over the runs of {} is at most {:.3g}", readout, study, bound),
            fmt::format("{:.3g}", most), x.size() > 1, most <= bound, {});
  return *this;
}

Judge& Judge::mostly_up_to(std::string_view study, std::string_view readout, double bound, double share) {
  const std::vector<double> x = statistics::finite(column(study, readout));
  const auto within = static_cast<double>(std::ranges::count_if(x, [&](double value) { return value <= bound; }));
  const double found = within / static_cast<double>(x.size());
  condition(
      fmt::format("{} is at most {:.3g} in at least {:.0f} % of the runs of {}", readout, bound, 100.0 * share, study),
      fmt::format("{:.0f} %", 100.0 * found), x.size() > 1, found >= share, {});
  return *this;
}

/// The verdict of the second edition.
void Judge::judge_again(Finding& finding) const {
  std::map<Family, std::vector<double>> adjusted;
  for (const Family family : {Family::no_difference, Family::agreement}) {
    for (const Condition& c : m_again)
      if (c.reading.family == family) adjusted[family].push_back(c.reading.p);
    adjusted[family] = statistics::holm(adjusted[family]);
  }
  bool defined = !m_again.empty(), met = true, states_direction = false, direction = true;
  std::map<Family, std::size_t> next;
  for (const Condition& c : m_again) {
    bool is_met = c.met;
    if (c.reading.family != Family::none)
      is_met = c.reading.close || !(adjusted[c.reading.family][next[c.reading.family]++] < alpha);
    defined = defined && c.defined;
    met = met && is_met;
    states_direction = states_direction || c.reading.direction.has_value();
    direction = direction && c.reading.direction.value_or(true);
    if (!is_met) finding.second_unmet.push_back(c.text);
  }
  finding.second = !defined                        ? Verdict::undecided
                   : met                           ? Verdict::holds
                   : states_direction && direction ? Verdict::in_direction
                                                   : Verdict::does_not_hold;
}

Finding Judge::finding() const {
  const Verdict verdict = !m_defined || m_conditions.empty() ? Verdict::undecided
                          : m_met                            ? Verdict::holds
                                                             : Verdict::does_not_hold;
  Finding finding{.verdict = verdict, .ours = m_ours, .conditions = m_conditions, .brief = brief()};
  if (verdict != Verdict::holds) finding.unmet = m_unmet;
  judge_again(finding);
  return finding;
}

std::string to_string(Verdict verdict) {
  switch (verdict) {
  case Verdict::holds:
    return "holds";
  case Verdict::in_direction:
    return "in direction";
  case Verdict::does_not_hold:
    return "does not hold";
  default:
    return "undecided";
  }
}

} // namespace matrigrate::study
