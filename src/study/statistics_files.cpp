#include "io/row_file.hpp"
#include "statistics/correlation.hpp"
#include "study/comparison.hpp"

#include <algorithm>

namespace matrigrate::study {

namespace {

using io::csv_line;
using io::Field;

Field count(std::size_t n) { return std::uint64_t{n}; }

/// A read-out of all runs, in their order; NaN where it is not defined.
std::vector<double> column(const std::vector<Result>& results, const std::string& readout) {
  const std::vector<std::string> names = all_readouts();
  const auto index = static_cast<std::size_t>(std::ranges::find(names, readout) - names.begin());
  std::vector<double> values;
  values.reserve(results.size());
  for (const Result& r : results) values.push_back(r.readouts[index]);
  return values;
}

} // namespace

std::string statistics_csv(const Study& study, const std::vector<Comparison>& comparisons) {
  using View = std::string_view;
  std::string text = csv_line({View("readout"),
                               View("point_a"),
                               View("point_b"),
                               View("n_a"),
                               View("n_b"),
                               View("mean_a"),
                               View("mean_b"),
                               View("sd_a"),
                               View("sd_b"),
                               View("difference"),
                               View("difference_low"),
                               View("difference_high"),
                               View("test"),
                               View("statistic"),
                               View("df"),
                               View("p"),
                               View("p_holm"),
                               View("hedges_g"),
                               View("hedges_g_low"),
                               View("hedges_g_high"),
                               View("detectable_difference_80_percent")});
  const std::string test = name(study.comparisons.test);
  for (const Comparison& c : comparisons)
    text += csv_line({View(c.readout),
                      View(study.points[c.a].label),
                      View(study.points[c.b].label),
                      count(c.sample_a.n),
                      count(c.sample_b.n),
                      c.sample_a.mean,
                      c.sample_b.mean,
                      c.sample_a.sd,
                      c.sample_b.sd,
                      c.difference.value,
                      c.difference.low,
                      c.difference.high,
                      View(test),
                      c.test.statistic,
                      c.test.df,
                      c.test.p,
                      c.p_holm,
                      c.g.value,
                      c.g.low,
                      c.g.high,
                      c.detectable});
  return text;
}

std::string groups_csv(const Study& study, const std::vector<Result>& results) {
  using View = std::string_view;
  std::string text = csv_line({View("readout"), View("point"), View("n"), View("mean"), View("mean_low"),
                               View("mean_high"), View("sd"), View("low_whisker"), View("low_quartile"), View("median"),
                               View("high_quartile"), View("high_whisker")});
  for (const std::string& readout : study.readouts)
    for (std::size_t i = 0; i < study.points.size(); ++i) {
      const std::vector<double> x = sample(results, i, readout);
      const statistics::Interval mean = statistics::mean_interval(x, study.comparisons.alpha);
      const statistics::Box box = statistics::box(x);
      text += csv_line({View(readout), View(study.points[i].label), count(x.size()), mean.value, mean.low, mean.high,
                        statistics::moments(x).sd, box.low_whisker, box.low_quartile, box.median, box.high_quartile,
                        box.high_whisker});
    }
  return text;
}

std::string correlations_csv(const Study& study, const std::vector<Result>& results) {
  using View = std::string_view;
  std::vector<std::vector<double>> columns;
  for (const std::string& readout : study.readouts) columns.push_back(column(results, readout));
  const auto matrix = statistics::correlation_matrix(columns);
  std::string text = csv_line({View("readout_x"), View("readout_y"), View("n"), View("r"), View("p")});
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = 0; j < columns.size(); ++j)
      text += csv_line(
          {View(study.readouts[i]), View(study.readouts[j]), count(matrix[i][j].n), matrix[i][j].r, matrix[i][j].p});
  return text;
}

} // namespace matrigrate::study
