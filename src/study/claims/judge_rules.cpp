#include "claims/judge.hpp"

#include "statistics/compare.hpp"
#include "statistics/correlation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

// The rules of conditions.
namespace matrigrate::study {

namespace {

constexpr double tenth = 0.1; // of a published mean: as near as it is read off a figure, whatever the scatter

std::string_view word(Sign sign) { return sign == Sign::up ? "above" : "below"; }
bool has(Sign sign, double value) { return sign == Sign::up ? value > 0.0 : value < 0.0; }

/// Whether an interval reaches further to either side than half of what it is about: a difference of that size could
/// not have been told.
bool vague(const statistics::Interval& interval, double about) {
  return 0.5 * (interval.high - interval.low) > 0.5 * std::abs(about);
}

/// Whether an interval lies wholly on the other side of a limit than stated.
bool opposes(Sign stated, const statistics::Interval& interval, double limit = 0.0) {
  return stated == Sign::up ? interval.high < limit : interval.low > limit;
}

} // namespace

/// Two points by a t-test.
void Judge::compare(const ClaimCondition& c) {
  const Group a = group(c.from);
  const Group b = group(c.to);
  const std::vector<double> x = values(a, c.readout);
  const std::vector<double> y = values(b, c.readout);
  const statistics::Interval d = statistics::mean_difference(x, y, alpha);
  const statistics::Interval g = statistics::hedges_g(x, y, alpha);
  const double larger = std::max(std::abs(statistics::moments(x).mean), std::abs(statistics::moments(y).mean));
  const double p = statistics::t_test(x, y).p;
  const bool signed_so = has(c.sign, d.value);
  const bool significant = p < alpha;
  std::string wanted;
  bool met = false;
  Reading reading;
  if (c.rule == ClaimRule::differs) {
    wanted = fmt::format("significantly {}", word(c.sign));
    met = signed_so && significant;
    reading = {.direction = signed_so, .against = opposes(c.sign, d)};
  } else if (c.rule == ClaimRule::leans) {
    wanted = word(c.sign);
    met = signed_so;
    reading = {.direction = signed_so, .against = opposes(c.sign, d)};
  } else if (c.rule == ClaimRule::same) {
    wanted = "not significantly different from";
    met = !significant;
    reading = {.family = Family::no_difference, .p = p, .vague = vague(d, larger)};
  } else { // not_beyond
    wanted = fmt::format("not significantly {}", word(c.sign));
    met = !(signed_so && significant);
    reading = {
        .family = Family::no_difference, .p = signed_so ? p : 1.0, .vague = vague(d, larger) && !opposes(c.sign, d)};
  }
  condition(words([&](auto named, auto labelled) {
              return fmt::format("{} at {} {} that at {}", named(c.readout), labelled(b), wanted, labelled(a));
            }),
            fmt::format("difference {:.3g} [{:.3g}, {:.3g}], p {:.2g}", d.value, d.low, d.high, p),
            x.size() > 1 && y.size() > 1, met, reading);
  m_conditions.back().measured.whole =
      fmt::format("difference {:.3g} [{:.3g}, {:.3g}], g {:.2g} [{:.2g}, {:.2g}], p {:.2g}", d.value, d.low, d.high,
                  g.value, g.low, g.high, p);
}

void Judge::ratio_below(const ClaimCondition& c) {
  const Group a = group(c.from);
  const Group b = group(c.to);
  const double mean_b = statistics::moments(values(b, c.readout)).mean;
  const double ratio = mean_b / statistics::moments(values(a, c.readout)).mean;
  condition(words([&](auto named, auto labelled) {
              return fmt::format("{} at {} over that at {} is below {:.3g}", named(c.readout), labelled(b), labelled(a),
                                 c.value);
            }),
            fmt::format("{:.3g}", ratio), std::isfinite(ratio), ratio < c.value, {.direction = ratio < c.value});
}

void Judge::exceeds(const ClaimCondition& c) {
  const Group g = group(c.to);
  std::vector<double> differences;
  if (g.ensemble != nullptr) {
    values(g, c.other);
    values(g, c.readout);
    for (const Result& r : g.ensemble->results)
      if (r.run.point == g.point)
        differences.push_back(r.readouts.at(readout_column(c.readout)) - r.readouts.at(readout_column(c.other)));
  }
  const std::vector<double> both = statistics::finite(differences);
  const statistics::Interval d = statistics::mean_interval(both, alpha);
  condition(words([&](auto named, auto labelled) {
              return fmt::format("{} above {} in the runs at {}", named(c.readout), named(c.other), labelled(g));
            }),
            fmt::format("difference {:.3g} [{:.3g}, {:.3g}], n = {}", d.value, d.low, d.high, both.size()),
            both.size() > 1, d.low > 0.0, {.direction = d.value > 0.0, .against = opposes(Sign::up, d)});
}

void Judge::agrees_at(const Group& g, const ClaimCondition& c) {
  const std::vector<double> x = values(g, c.readout);
  const double mean = statistics::moments(x).mean;
  const statistics::Interval interval = statistics::mean_interval(x, alpha);
  const double p = statistics::published_mean_test(x, c.value, c.runs).p;
  condition(words([&](auto named, auto labelled) {
              return fmt::format("{} at {} agrees with {:.3g}", named(c.readout), labelled(g), c.value);
            }),
            fmt::format("mean {:.3g}, p {:.2g}", mean, p), x.size() > 1, p >= alpha,
            {.family = Family::agreement,
             .p = p,
             .close = std::abs(mean - c.value) <= tenth * std::abs(c.value),
             .vague = vague(interval, c.value)});
}

void Judge::agrees(const ClaimCondition& c) { agrees_at(group(c.to), c); }

/// The first of the lowest, or highest, means of all points.
void Judge::extreme_agrees(const ClaimCondition& c) {
  const Sign which = c.rule == ClaimRule::lowest_agrees ? Sign::down : Sign::up;
  const Ensemble* known = ensemble(c.study);
  Group extreme = group({c.study, ""});
  double best = std::nan("");
  if (known != nullptr)
    for (std::size_t i = 0; i < known->study.points.size(); ++i) {
      Group g = group({c.study, known->study.points[i].label});
      const double mean = statistics::moments(values(g, c.readout)).mean;
      if (i > 0 && !has(which, mean - best)) continue;
      best = mean;
      extreme = std::move(g);
    }
  agrees_at(extreme, c);
}

void Judge::within(const ClaimCondition& c) {
  const Group g = group(c.to);
  const double mean = statistics::moments(values(g, c.readout)).mean;
  condition(words([&](auto named, auto labelled) {
              return fmt::format("mean {} at {} is {:.3g} to {:.3g}", named(c.readout), labelled(g), c.value, c.high);
            }),
            fmt::format("{:.3g}", mean), std::isfinite(mean), mean >= c.value && mean <= c.high, {});
}

void Judge::beyond(const ClaimCondition& c) {
  const bool above = c.rule == ClaimRule::above;
  const Group g = group(c.to);
  const statistics::Interval mean = statistics::mean_interval(values(g, c.readout), alpha);
  const double end = above ? mean.low : mean.high;
  const auto met = [&](double x) { return above ? x > c.value : x < c.value; };
  condition(words([&](auto named, auto labelled) {
              return fmt::format("{} at {} lies {} {:.3g} with its interval", named(c.readout), labelled(g),
                                 above ? "above" : "below", c.value);
            }),
            fmt::format("{} {:.3g}", above ? "from" : "up to", end), std::isfinite(end), met(end),
            {.direction = met(mean.value), .against = opposes(above ? Sign::up : Sign::down, mean, c.value)});
}

void Judge::correlate(const ClaimCondition& c) {
  const statistics::Correlation found = statistics::pearson(column(c, c.readout), column(c, c.other));
  if (std::isfinite(found.r))
    tell_all(words([&](auto named, auto) {
      return fmt::format("r of {} and {} {:.2g} (n = {})", named(c.readout), named(c.other), found.r, found.n);
    }));
  const bool wanted = c.rule == ClaimRule::correlates;
  const bool signed_so = has(c.sign, found.r);
  const char* how = !wanted ? "do not correlate" : c.sign == Sign::up ? "rise together" : "go against each other";
  condition(words([&](auto named, auto) {
              return fmt::format("{} and {} {} over the runs of {}", named(c.readout), named(c.other), how,
                                 c.study.empty() ? m_study : c.study);
            }),
            fmt::format("r {:.2g}, p {:.2g}", found.r, found.p), std::isfinite(found.r),
            wanted ? signed_so && found.p < alpha : found.p >= alpha,
            wanted ? Reading{.direction = signed_so, .against = !signed_so && found.p < alpha}
                   : Reading{.vague = found.n < 4 || vague(statistics::correlation_interval(found, alpha), 1.0)});
}

void Judge::over_all_runs(const ClaimCondition& c) {
  const std::vector<double> x = statistics::finite(column(c, c.readout));
  const std::string& study = c.study.empty() ? m_study : c.study;
  const bool defined = x.size() > 1;
  if (c.rule == ClaimRule::mostly_up_to) {
    const auto within = static_cast<double>(std::ranges::count_if(x, [&](double value) { return value <= c.value; }));
    const double found = within / static_cast<double>(x.size());
    if (defined)
      tell_all(words([&](auto named, auto) {
        return fmt::format("{} at most {:.3g} in {:.0f} % (n = {})", named(c.readout), c.value, 100.0 * found,
                           x.size());
      }));
    return condition(words([&](auto named, auto) {
                       return fmt::format("{} is at most {:.3g} in at least {:.0f} % of the runs of {}",
                                          named(c.readout), c.value, 100.0 * c.share, study);
                     }),
                     fmt::format("{:.0f} %", 100.0 * found), defined, found >= c.share, {});
  }
  const bool of_mean = c.rule == ClaimRule::mean_above;
  const double found = of_mean ? statistics::moments(x).mean : x.empty() ? std::nan("") : *std::ranges::max_element(x);
  const char* what = of_mean ? "mean" : "largest";
  if (!x.empty())
    tell_all(words([&](auto named, auto) {
      return fmt::format("{} {} {:.3g} (n = {})", what, named(c.readout), found, x.size());
    }));
  condition(words([&](auto named, auto) {
              return fmt::format("{} {} over the runs of {} is {} {:.3g}", what, named(c.readout), study,
                                 of_mean ? "above" : "at most", c.value);
            }),
            fmt::format("{:.3g}", found), defined, of_mean ? found > c.value : found <= c.value, {});
}

} // namespace matrigrate::study
