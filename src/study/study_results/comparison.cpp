#include "study_results/comparison.hpp"

#include "parameters/schema.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace matrigrate::study {

namespace {

using store::count;
using store::csv_line;
using store::Field;
using View = std::string_view;

using Pair = std::pair<std::size_t, std::size_t>;

/// For each point, which of the values of each swept parameter it has, by the order in which they appear.
std::vector<std::vector<std::size_t>> grid_places(const Study& study) {
  const std::vector<std::string> keys = swept_keys(study);
  std::vector<std::map<std::string, std::size_t>> known(keys.size());
  std::vector<std::vector<std::size_t>> places;
  for (const Point& point : study.points) {
    std::vector<std::size_t>& place = places.emplace_back();
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const std::string value = meaning_text(*find_row(keys[k], point.parameters), point.parameters);
      place.push_back(known[k].try_emplace(value, known[k].size()).first->second);
    }
  }
  return places;
}

std::vector<Pair> adjacent_pairs(const Study& study) {
  const auto places = grid_places(study);
  std::map<std::vector<std::size_t>, std::size_t> at;
  for (std::size_t i = 0; i < places.size(); ++i) at.emplace(places[i], i);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = places[i].size(); k-- > 0;) {
      auto next = places[i];
      ++next[k];
      if (const auto found = at.find(next); found != at.end()) pairs.emplace_back(i, found->second);
    }
  return pairs;
}

statistics::TestResult tested(TestKind test, statistics::Values a, statistics::Values b) {
  if (test == TestKind::welch) return statistics::welch_test(a, b);
  if (test == TestKind::mann_whitney) return statistics::mann_whitney_test(a, b);
  return statistics::t_test(a, b);
}

Comparison compared(const Comparisons& how, statistics::Values a, statistics::Values b) {
  Comparison c;
  c.sample_a = statistics::moments(a);
  c.sample_b = statistics::moments(b);
  c.difference = statistics::mean_difference(a, b, how.alpha, how.test != TestKind::welch);
  c.test = tested(how.test, a, b);
  c.g = statistics::hedges_g(a, b, how.alpha);
  c.detectable = statistics::detectable_difference(static_cast<double>(a.size()), static_cast<double>(b.size()),
                                                   how.alpha, wanted_power)
                 * statistics::pooled_sd(c.sample_a, c.sample_b);
  return c;
}

} // namespace

std::vector<Pair> compared_pairs(const Study& study) {
  const Pairs wanted = study.comparisons.pairs;
  if (wanted == Pairs::adjacent) return adjacent_pairs(study);
  std::vector<Pair> pairs;
  const std::size_t n = study.points.size();
  if (wanted == Pairs::all)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) pairs.emplace_back(i, j);
  if (wanted == Pairs::control) {
    const auto control = std::ranges::find(study.points, study.comparisons.control, &Point::label);
    const auto c = static_cast<std::size_t>(control - study.points.begin());
    for (std::size_t i = 0; i < n; ++i)
      if (i != c) pairs.emplace_back(c, i);
  }
  return pairs;
}

std::vector<Comparison> comparisons(const Study& study, const std::vector<Result>& results) {
  const std::vector<Pair> pairs = compared_pairs(study);
  std::vector<Comparison> all;
  for (const std::string& readout : study.readouts) {
    std::vector<std::vector<double>> samples;
    for (std::size_t i = 0; i < study.points.size(); ++i) samples.push_back(sample(results, i, readout));
    std::vector<double> p;
    for (const auto& [a, b] : pairs) {
      Comparison c = compared(study.comparisons, samples[a], samples[b]);
      c.readout = readout;
      c.a = a;
      c.b = b;
      p.push_back(c.test.p);
      all.push_back(std::move(c));
    }
    const std::vector<double> corrected = statistics::holm(p);
    for (std::size_t k = 0; k < p.size(); ++k) all[all.size() - p.size() + k].p_holm = corrected[k];
  }
  return all;
}

std::string name(TestKind test) { return test_names[static_cast<std::size_t>(test)]; }

std::vector<ReadOutSample> samples(const Study& study, const std::vector<Result>& results) {
  std::vector<ReadOutSample> all;
  for (const std::string& readout : study.readouts)
    for (std::size_t i = 0; i < study.points.size(); ++i) {
      const std::vector<double> x = sample(results, i, readout);
      all.push_back({.readout = readout,
                     .point = i,
                     .moments = statistics::moments(x),
                     .mean = statistics::mean_interval(x, study.comparisons.alpha),
                     .box = statistics::box(x)});
    }
  return all;
}

std::string statistics_csv(const Study& study, const std::vector<Comparison>& comparisons,
                           const std::vector<Result>& results) {
  const std::vector<std::size_t> lost = lost_at_rim(study, results);
  std::vector<std::string> swept_a = swept_columns(study), swept_b = swept_a;
  for (std::string& column : swept_a) column += "_a";
  for (std::string& column : swept_b) column += "_b";
  const auto names = concatenated<std::string>(
      {{"readout", "point_a", "point_b"},
       swept_a,
       swept_b,
       {"n_a", "n_b", "mean_a", "mean_b", "sd_a", "sd_b", "difference", "difference_low", "difference_high"},
       {"test", "statistic", "df", "p", "p_holm", "hedges_g", "hedges_g_low", "hedges_g_high"},
       {"detectable_difference_80_percent", "lost_at_rim_a", "lost_at_rim_b"}});
  std::string text = csv_line({names.begin(), names.end()});
  const std::string test = name(study.comparisons.test);
  for (const Comparison& c : comparisons) {
    const Point &a = study.points[c.a], &b = study.points[c.b];
    const std::vector<std::string> values_a = swept_values(study, a), values_b = swept_values(study, b);
    text += csv_line(concatenated<Field>(
        {{View(c.readout), View(a.label), View(b.label)},
         {values_a.begin(), values_a.end()},
         {values_b.begin(), values_b.end()},
         {count(c.sample_a.n), count(c.sample_b.n), c.sample_a.mean, c.sample_b.mean, c.sample_a.sd, c.sample_b.sd,
          c.difference.value, c.difference.low, c.difference.high, View(test), c.test.statistic, c.test.df, c.test.p,
          c.p_holm, c.g.value, c.g.low, c.g.high, c.detectable},
         {count(lost[c.a]), count(lost[c.b])}}));
  }
  return text;
}

std::string groups_csv(const Study& study, const std::vector<Result>& results) {
  const auto names =
      concatenated<std::string>({{"readout", "point"},
                                 swept_columns(study),
                                 {"n", "mean", "mean_low", "mean_high", "sd", "low_whisker", "low_quartile", "median",
                                  "high_quartile", "high_whisker", "lost_at_rim"}});
  const std::vector<std::size_t> lost = lost_at_rim(study, results);
  std::string text = csv_line({names.begin(), names.end()});
  for (const ReadOutSample& s : samples(study, results)) {
    const Point& point = study.points[s.point];
    const std::vector<std::string> values = swept_values(study, point);
    text += csv_line(concatenated<Field>(
        {{View(s.readout), View(point.label)},
         {values.begin(), values.end()},
         {count(s.moments.n), s.mean.value, s.mean.low, s.mean.high, s.moments.sd, s.box.low_whisker,
          s.box.low_quartile, s.box.median, s.box.high_quartile, s.box.high_whisker, count(lost[s.point])}}));
  }
  return text;
}

Correlations correlations(const Study& study, const std::vector<Result>& results) {
  std::vector<std::size_t> point;
  for (const Result& r : results) point.push_back(r.run.point);
  Correlations found;
  std::vector<std::vector<double>> columns;
  for (const std::string& readout : study.readouts) {
    const std::size_t index = readout_column(readout);
    std::vector<double> values;
    for (const Result& r : results) values.push_back(r.readouts[index]);
    if (std::isnan(statistics::pearson_within(values, values, point).r)) continue;
    found.readouts.push_back(readout);
    columns.push_back(std::move(values));
  }
  const std::size_t n = columns.size();
  found.p_holm.assign(n, std::vector<double>(n, std::numeric_limits<double>::quiet_NaN()));
  std::vector<double> p; // of each pair once
  for (std::size_t i = 0; i < n; ++i) {
    found.pairs.emplace_back();
    for (std::size_t j = 0; j < n; ++j)
      found.pairs[i].push_back(statistics::pearson_within(columns[i], columns[j], point));
    for (std::size_t j = i + 1; j < n; ++j) p.push_back(found.pairs[i][j].p);
  }
  const std::vector<double> holm = statistics::holm(p);
  std::size_t next = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) found.p_holm[i][j] = found.p_holm[j][i] = holm[next++];
  return found;
}

std::string correlations_csv(const Correlations& found) {
  std::string text = csv_line({View("readout_x"), View("readout_y"), View("n"), View("r"), View("p"), View("p_holm")});
  for (std::size_t i = 0; i < found.readouts.size(); ++i)
    for (std::size_t j = 0; j < found.readouts.size(); ++j) {
      const statistics::Correlation& c = found.pairs[i][j];
      text += csv_line({View(found.readouts[i]), View(found.readouts[j]), count(c.n), c.r, c.p, found.p_holm[i][j]});
    }
  return text;
}

} // namespace matrigrate::study
