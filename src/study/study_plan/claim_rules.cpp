#include "study_plan/claim.hpp"

#include "statistics/compare.hpp"
#include "statistics/correlation.hpp"
#include "statistics/sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matrigrate::study {

namespace {

using statistics::Interval;

constexpr double alpha = claim_alpha;
constexpr double tenth = 0.1; // of a published mean: as near as it is read off a figure, whatever the scatter

std::string_view word(Sign sign) { return sign == Sign::up ? "above" : "below"; }
bool has(Sign sign, double value) { return sign == Sign::up ? value > 0.0 : value < 0.0; }

/// Whether an interval reaches further to either side than half of what it is about: a difference of that size could
/// not have been told.
bool vague(const Interval& interval, double about) {
  return 0.5 * (interval.high - interval.low) > 0.5 * std::abs(about);
}

/// Whether an interval lies wholly on the other side of a limit than stated.
bool opposes(Sign stated, const Interval& interval, double limit = 0.0) {
  return stated == Sign::up ? interval.high < limit : interval.low > limit;
}

/// Two points by a t-test.
struct Compared {
  Interval d;    ///< of the means, `to` minus `from`
  double larger; ///< of the magnitudes of the two means
  double p;
  bool signed_so;
  bool significant;
  ClaimReading reading;
};

Compared compared(const ClaimCondition& c, const ClaimRuns& runs, const std::string& wanted) {
  const Interval d = statistics::mean_difference(runs.from, runs.to, alpha);
  const Interval g = statistics::hedges_g(runs.from, runs.to, alpha);
  const double p = statistics::t_test(runs.from, runs.to).p;
  return {.d = d,
          .larger =
              std::max(std::abs(statistics::moments(runs.from).mean), std::abs(statistics::moments(runs.to).mean)),
          .p = p,
          .signed_so = has(c.sign, d.value),
          .significant = p < alpha,
          .reading = {.wanted = fmt::format("$readout: $to {} $from", wanted),
                      .measured = fmt::format("difference {:.3g} [{:.3g}, {:.3g}], g {:.2g} [{:.2g}, {:.2g}], p {:.2g}",
                                              d.value, d.low, d.high, g.value, g.low, g.high, p),
                      .defined = runs.from.size() > 1 && runs.to.size() > 1}};
}

/// `differs` if it has to be significant, else `leans`.
template <bool significantly>
ClaimReading differs(const ClaimCondition& c, const ClaimRuns& runs) {
  Compared two = compared(c, runs, fmt::format("{}{}", significantly ? "significantly " : "", word(c.sign)));
  two.reading.met = two.signed_so && (two.significant || !significantly);
  two.reading.direction = two.signed_so;
  two.reading.against = opposes(c.sign, two.d);
  return two.reading;
}

/// `not_beyond` if it is about one side, else `same`.
template <bool one_sided>
ClaimReading same(const ClaimCondition& c, const ClaimRuns& runs) {
  Compared two = compared(c, runs,
                          one_sided ? fmt::format("not significantly {}", word(c.sign))
                                    : std::string("not significantly different from"));
  const bool counts = two.signed_so || !one_sided;
  two.reading.met = !(counts && two.significant);
  two.reading.family = ClaimFamily::no_difference;
  two.reading.p = counts ? two.p : 1.0;
  two.reading.vague = vague(two.d, two.larger) && !(one_sided && opposes(c.sign, two.d));
  return two.reading;
}

ClaimReading ratio_below(const ClaimCondition& c, const ClaimRuns& runs) {
  const double ratio = statistics::moments(runs.to).mean / statistics::moments(runs.from).mean;
  return {.wanted = fmt::format("$readout: $to over $from is below {:.3g}", c.value),
          .measured = fmt::format("{:.3g}", ratio),
          .defined = std::isfinite(ratio),
          .met = ratio < c.value,
          .direction = ratio < c.value};
}

ClaimReading exceeds(const ClaimCondition& /*c*/, const ClaimRuns& runs) {
  const Interval d = statistics::mean_interval(runs.excess, alpha);
  return {.wanted = "$to: $readout above $other in the same runs",
          .measured =
              fmt::format("difference {:.3g} [{:.3g}, {:.3g}], n = {}", d.value, d.low, d.high, runs.excess.size()),
          .defined = runs.excess.size() > 1,
          .met = d.low > 0.0,
          .direction = d.value > 0.0,
          .against = opposes(Sign::up, d)};
}

ClaimReading agrees(const ClaimCondition& c, const ClaimRuns& runs) {
  const double mean = statistics::moments(runs.to).mean;
  const double p = statistics::published_mean_test(runs.to, c.value, c.runs).p;
  return {.wanted = fmt::format("$readout: $to agrees with {:.3g}", c.value),
          .measured = fmt::format("mean {:.3g}, p {:.2g}", mean, p),
          .defined = runs.to.size() > 1,
          .met = p >= alpha,
          .family = ClaimFamily::agreement,
          .p = p,
          .close = std::abs(mean - c.value) <= tenth * std::abs(c.value),
          .vague = vague(statistics::mean_interval(runs.to, alpha), c.value)};
}

ClaimReading within(const ClaimCondition& c, const ClaimRuns& runs) {
  const double mean = statistics::moments(runs.to).mean;
  return {.wanted = fmt::format("$readout: the mean of $to is {:.3g} to {:.3g}", c.value, c.high),
          .measured = fmt::format("{:.3g}", mean),
          .defined = std::isfinite(mean),
          .met = mean >= c.value && mean <= c.high};
}

template <Sign side>
ClaimReading beyond(const ClaimCondition& c, const ClaimRuns& runs) {
  const Interval mean = statistics::mean_interval(runs.to, alpha);
  const double end = side == Sign::up ? mean.low : mean.high;
  return {.wanted = fmt::format("$readout: $to lies {} {:.3g} with its interval", word(side), c.value),
          .measured = fmt::format("{} {:.3g}", side == Sign::up ? "from" : "up to", end),
          .defined = std::isfinite(end),
          .met = has(side, end - c.value),
          .direction = has(side, mean.value - c.value),
          .against = opposes(side, mean, c.value)};
}

/// With its sentence, which says how they should go.
ClaimReading correlation(const statistics::Correlation& found, std::string_view how) {
  ClaimReading reading{.wanted = fmt::format("$readout, and $other: they {} over the runs of $study", how),
                       .measured = fmt::format("r {:.2g}, p {:.2g}", found.r, found.p),
                       .defined = std::isfinite(found.r)};
  if (reading.defined) reading.all_runs = fmt::format("$readout, and $other: r {:.2g} (n = {})", found.r, found.n);
  return reading;
}

ClaimReading correlates(const ClaimCondition& c, const ClaimRuns& runs) {
  const statistics::Correlation found = statistics::pearson(runs.all, runs.other);
  const bool signed_so = has(c.sign, found.r);
  ClaimReading reading = correlation(found, c.sign == Sign::up ? "rise together" : "go against each other");
  reading.met = signed_so && found.p < alpha;
  reading.direction = signed_so;
  reading.against = !signed_so && found.p < alpha;
  return reading;
}

ClaimReading uncorrelated(const ClaimCondition& /*c*/, const ClaimRuns& runs) {
  const statistics::Correlation found = statistics::pearson(runs.all, runs.other);
  ClaimReading reading = correlation(found, "do not correlate");
  reading.met = found.p >= alpha;
  reading.vague = found.n < 4 || vague(statistics::correlation_interval(found, alpha), 1.0);
  return reading;
}

/// A number over all runs: "$readout: the mean over the runs of $study is above 0.5".
ClaimReading over_all(std::string_view what, double found, std::size_t n, std::string_view wanted, double bound) {
  ClaimReading reading{.wanted =
                           fmt::format("$readout: the {} over the runs of $study is {} {:.3g}", what, wanted, bound),
                       .measured = fmt::format("{:.3g}", found),
                       .defined = n > 1};
  if (n > 0) reading.all_runs = fmt::format("$readout: {} {:.3g} (n = {})", what, found, n);
  return reading;
}

ClaimReading mean_above(const ClaimCondition& c, const ClaimRuns& runs) {
  const std::vector<double> x = statistics::finite(runs.all);
  const double mean = statistics::moments(x).mean;
  ClaimReading reading = over_all("mean", mean, x.size(), "above", c.value);
  reading.met = mean > c.value;
  return reading;
}

ClaimReading none_above(const ClaimCondition& c, const ClaimRuns& runs) {
  const std::vector<double> x = statistics::finite(runs.all);
  const double largest = x.empty() ? std::nan("") : *std::ranges::max_element(x);
  ClaimReading reading = over_all("largest", largest, x.size(), "at most", c.value);
  reading.met = largest <= c.value;
  return reading;
}

ClaimReading mostly_up_to(const ClaimCondition& c, const ClaimRuns& runs) {
  const std::vector<double> x = statistics::finite(runs.all);
  const auto within = static_cast<double>(std::ranges::count_if(x, [&](double value) { return value <= c.value; }));
  const double found = within / static_cast<double>(x.size());
  ClaimReading reading{.wanted = fmt::format("$readout: at most {:.3g} in at least {:.0f} % of the runs of $study",
                                             c.value, 100.0 * c.share),
                       .measured = fmt::format("{:.0f} %", 100.0 * found),
                       .defined = x.size() > 1,
                       .met = found >= c.share};
  if (reading.defined)
    reading.all_runs = fmt::format("$readout: at most {:.3g} in {:.0f} % (n = {})", c.value, 100.0 * found, x.size());
  return reading;
}

std::vector<double> drawn_slopes(const MsdCurves& runs, std::uint64_t key) {
  std::vector<double> slopes;
  for (std::size_t draw = 0; draw < statistics::bootstrap_draws; ++draw) {
    MsdCurves drawn;
    for (const std::size_t k : statistics::resampled(runs.size(), key, draw)) drawn.push_back(runs[k]);
    slopes.push_back(msd_slope(mean_curve(drawn)));
  }
  return slopes;
}

ClaimReading msd_leans(const ClaimCondition& c, const ClaimRuns& runs) {
  const double from = msd_slope(mean_curve(runs.from_msd)), to = msd_slope(mean_curve(runs.to_msd));
  std::vector<double> differences = drawn_slopes(runs.to_msd, 1); // the two samples are not paired
  const std::vector<double> of_from = drawn_slopes(runs.from_msd, 0);
  for (std::size_t k = 0; k < differences.size(); ++k) differences[k] -= of_from[k];
  const Interval d = statistics::percentile_interval(to - from, differences, alpha);
  return {.wanted = fmt::format("slope of the mean curve of the square displacement: $to {} $from", word(c.sign)),
          .measured = fmt::format("difference {:.3g} [{:.3g}, {:.3g}], bootstrap over runs", d.value, d.low, d.high),
          .defined = runs.from_msd.size() > 1 && runs.to_msd.size() > 1 && std::isfinite(d.value),
          .met = has(c.sign, d.value),
          .direction = has(c.sign, d.value),
          .against = opposes(c.sign, d)};
}

} // namespace

std::vector<MsdPoint> mean_curve(const MsdCurves& runs) {
  std::vector<MsdPoint> mean;
  if (!runs.empty()) mean.resize(std::ranges::min_element(runs, {}, &std::vector<MsdPoint>::size)->size());
  for (std::size_t k = 0; k < mean.size(); ++k) {
    mean[k] = {.lag = runs.front()[k].lag, .msd = 0.0, .samples = runs.size()};
    for (const std::vector<MsdPoint>& run : runs) mean[k].msd += run[k].msd / static_cast<double>(runs.size());
  }
  return mean;
}

statistics::Interval mean_curve_slope(const MsdCurves& runs, std::uint64_t key) {
  return statistics::percentile_interval(msd_slope(mean_curve(runs)), drawn_slopes(runs, key), alpha);
}

const std::vector<ClaimRule>& claim_rules() {
  using enum ClaimPoints;
  static const std::vector<ClaimRule> rules{
      // `to` is significantly above (or below) `from`
      {"differs", {"readout", "from", "to", "sign"}, from_to, differs<true>},
      // `to` does not differ significantly from `from`
      {"same", {"readout", "from", "to"}, from_to, same<false>},
      // the mean of `to` is above (or below) that of `from`, significantly or not: "slightly"
      {"leans", {"readout", "from", "to", "sign"}, from_to, differs<false>},
      // the mean square displacement, averaged over runs, has a steeper (or flatter) slope at `to`
      {"msd_leans", {"from", "to", "sign"}, curves, msd_leans},
      // `to` is not significantly above (or below) `from`
      {"not_beyond", {"readout", "from", "to", "sign"}, from_to, same<true>},
      // the means of `to` and `from` are in a ratio below a bound
      {"ratio_below", {"readout", "from", "to", "bound"}, from_to, ratio_below},
      // in the runs the read-out is above another: the 95 % interval of their difference is above 0
      {"exceeds", {"readout", "over", "at"}, at, exceeds},
      // the published mean of so many runs could be one of our population: published_mean_test, p >= 0.05
      {"agrees", {"readout", "at", "value", "runs"}, at, agrees},
      // the lowest, or highest, of the means of all points agrees with a published one
      {"lowest_agrees", {"readout", "value", "runs"}, lowest, agrees},
      {"highest_agrees", {"readout", "value", "runs"}, highest, agrees},
      // the mean lies between two bounds
      {"within", {"readout", "at", "low", "high"}, at, within},
      // the 95 % interval of the mean lies below, or above, a bound
      {"below", {"readout", "at", "bound"}, at, beyond<Sign::down>},
      {"above", {"readout", "at", "bound"}, at, beyond<Sign::up>},
      // Pearson's r with another read-out over all runs is significant and has this sign
      {"correlates", {"readout", "with", "sign"}, all, correlates},
      // it is not significant
      {"uncorrelated", {"readout", "with"}, all, uncorrelated},
      // the mean over all runs is above a bound
      {"mean_above", {"readout", "bound"}, all, mean_above},
      // no run is above a bound
      {"none_above", {"readout", "bound"}, all, none_above},
      // at least a share of the runs is not above a bound
      {"mostly_up_to", {"readout", "bound", "share"}, all, mostly_up_to},
  };
  return rules;
}

} // namespace matrigrate::study
