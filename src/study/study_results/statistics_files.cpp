#include "study_results/comparison.hpp"
#include "tables/table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace matrigrate::study {

namespace {

using store::count;
using store::csv_line;
using store::Field;
using View = std::string_view;

/// A read-out of all runs, in their order; NaN where it is not defined.
std::vector<double> column(const std::vector<Result>& results, const std::string& readout) {
  const std::size_t index = readout_column(readout);
  std::vector<double> values;
  values.reserve(results.size());
  for (const Result& r : results) values.push_back(r.readouts[index]);
  return values;
}

} // namespace

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
  const std::vector<std::string> swept = swept_columns(study);
  std::vector<std::string> names{"readout", "point_a", "point_b"};
  for (const char* end : {"_a", "_b"})
    for (const std::string& name : swept) names.push_back(name + end);
  for (const char* name : {"n_a", "n_b", "mean_a", "mean_b", "sd_a", "sd_b", "difference", "difference_low",
                           "difference_high", "test", "statistic", "df", "p", "p_holm", "hedges_g", "hedges_g_low",
                           "hedges_g_high", "detectable_difference_80_percent"})
    names.emplace_back(name);
  names.insert(names.end(), {"lost_at_rim_a", "lost_at_rim_b"});
  std::string text = csv_line({names.begin(), names.end()});
  const std::string test = name(study.comparisons.test);
  for (const Comparison& c : comparisons) {
    const Point& a = study.points[c.a];
    const Point& b = study.points[c.b];
    std::vector<Field> row{View(c.readout), View(a.label), View(b.label)};
    const std::vector<std::string> values_a = swept_values(study, a);
    const std::vector<std::string> values_b = swept_values(study, b);
    row.insert(row.end(), values_a.begin(), values_a.end());
    row.insert(row.end(), values_b.begin(), values_b.end());
    row.insert(row.end(),
               {count(c.sample_a.n), count(c.sample_b.n), c.sample_a.mean, c.sample_b.mean, c.sample_a.sd,
                c.sample_b.sd, c.difference.value, c.difference.low, c.difference.high, View(test), c.test.statistic,
                c.test.df, c.test.p, c.p_holm, c.g.value, c.g.low, c.g.high, c.detectable});
    row.insert(row.end(), {count(lost[c.a]), count(lost[c.b])});
    text += csv_line(row);
  }
  return text;
}

std::string groups_csv(const Study& study, const std::vector<Result>& results) {
  std::vector<std::string> names{"readout", "point"};
  for (const std::string& name : swept_columns(study)) names.push_back(name);
  for (const char* name : {"n", "mean", "mean_low", "mean_high", "sd", "low_whisker", "low_quartile", "median",
                           "high_quartile", "high_whisker"})
    names.emplace_back(name);
  names.emplace_back("lost_at_rim");
  const std::vector<std::size_t> lost = lost_at_rim(study, results);
  std::string text = csv_line({names.begin(), names.end()});
  for (const ReadOutSample& s : samples(study, results)) {
    const Point& point = study.points[s.point];
    std::vector<Field> row{View(s.readout), View(point.label)};
    const std::vector<std::string> values = swept_values(study, point);
    row.insert(row.end(), values.begin(), values.end());
    row.insert(row.end(), {count(s.moments.n), s.mean.value, s.mean.low, s.mean.high, s.moments.sd, s.box.low_whisker,
                           s.box.low_quartile, s.box.median, s.box.high_quartile, s.box.high_whisker});
    row.push_back(count(lost[s.point]));
    text += csv_line(row);
  }
  return text;
}

Correlations correlations(const Study& study, const std::vector<Result>& results) {
  std::vector<std::size_t> point;
  for (const Result& r : results) point.push_back(r.run.point);
  Correlations found;
  std::vector<std::vector<double>> columns;
  for (const std::string& readout : study.readouts) {
    std::vector<double> values = column(results, readout);
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
