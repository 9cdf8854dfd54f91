#include "study_plan/read_comparisons.hpp"

#include "parameters/nearest.hpp"
#include "parameters/node.hpp"
#include "parameters/scan.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::study {

namespace {

double alpha_of(const toml::node& node, const std::string& key, FaultList& faults) {
  const auto value = node.value<double>();
  if (value && *value > 0.0 && *value <= 0.5) return *value;
  faults.add(place_of(node), key,
             value ? fmt::format("{} is out of range; allowed is > 0 and <= 0.5", *value)
                   : fmt::format("is {}, but a number without quotes is expected, such as 0.05", type_of(node)));
  return Comparisons{}.alpha;
}

void check_control(const Comparisons& c, const toml::table& table, const std::vector<Point>& points,
                   FaultList& faults) {
  if (c.pairs != Pairs::control) return;
  const toml::node* node = table.get("control");
  std::vector<std::string> labels;
  labels.reserve(points.size());
  for (const Point& point : points) labels.push_back(point.label);
  if (std::ranges::find(labels, c.control) != labels.end()) return;
  const std::string what = node == nullptr ? std::string("is missing: the label")
                                           : fmt::format("\"{}\" is not the label", excerpt(c.control));
  faults.add(place_of(node == nullptr ? *table.get("compare") : *node), "statistics.control",
             fmt::format("{} of a point; the labels are {}{}", what, quoted_list(labels),
                         did_you_mean(nearest(c.control, labels))));
}

} // namespace

Comparisons read_comparisons(const toml::table& table, Comparisons c, const std::vector<Point>& points,
                             FaultList& faults) {
  faults.check_keys(table, "statistics", {"compare", "test", "control", "alpha"});
  if (const auto* node = table.get("compare"))
    c.pairs = static_cast<Pairs>(faults.choice(*node, "statistics.compare", {"none", "adjacent", "all", "control"}));
  if (const auto* node = table.get("test"))
    c.test = static_cast<TestKind>(faults.choice(*node, "statistics.test", {"t", "welch", "mann_whitney"}));
  if (const auto* node = table.get("control")) c.control = faults.text(*node, "statistics.control");
  if (const auto* node = table.get("alpha")) c.alpha = alpha_of(*node, "statistics.alpha", faults);
  check_control(c, table, points, faults);
  return c;
}

} // namespace matrigrate::study
