#include "study_results/comparison.hpp"

#include "parameters/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace matrigrate::study {

namespace {

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

std::vector<Pair> all_pairs(std::size_t n) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) pairs.emplace_back(i, j);
  return pairs;
}

std::vector<Pair> control_pairs(const Study& study) {
  const auto control = std::ranges::find(study.points, study.comparisons.control, &Point::label);
  const auto c = static_cast<std::size_t>(control - study.points.begin());
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < study.points.size(); ++i)
    if (i != c) pairs.emplace_back(c, i);
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
  switch (study.comparisons.pairs) {
  case Pairs::none:
    return {};
  case Pairs::all:
    return all_pairs(study.points.size());
  case Pairs::control:
    return control_pairs(study);
  default:
    return adjacent_pairs(study);
  }
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

} // namespace matrigrate::study
