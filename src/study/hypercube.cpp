#include "base/random.hpp"
#include "io/trajectory_hash.hpp"
#include "parameters/assign.hpp"
#include "parameters/node.hpp"
#include "study/sweep.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numeric>

namespace matrigrate::study {

namespace {

using Real = double& (*)(Parameters&);
using Integer = int& (*)(Parameters&);

/// The value of a number's row, in the row's unit; none for flags and choices.
std::optional<double> number_in_unit(const Row& row, Parameters p) {
  if (const auto* real = std::get_if<Real>(&row.member)) return (*real)(p) / units::to_internal(1.0, unit_of(row));
  if (const auto* integer = std::get_if<Integer>(&row.member)) return (*integer)(p);
  return std::nullopt;
}

/// A range that is sampled.
struct Span {
  const Row* row;
  Place place;
  double low = 0.0;
  double high = 0.0;
  bool log = false;

  double at(double share) const { return log ? low * std::pow(high / low, share) : low + share * (high - low); }
};

std::optional<Span> span_of(const Named& named, const Parameters& base, FaultList& faults) {
  const Row& row = *named.row;
  const auto complain = [&](std::string message) {
    faults.add(place_of(*named.node), row.path, std::move(message));
    return std::nullopt;
  };
  const toml::array* list = named.node->as_array();
  const std::string such = fmt::format("such as [{0}, {0}] or [{0}, {0}, \"log\"]", value_text(row, base));
  if (!number_in_unit(row, base)) return complain("is no number, and has no range");
  if (list == nullptr || list->size() < 2 || list->size() > 3)
    return complain(fmt::format("is {}, but a range of low and high is expected, {}", type_of(*named.node), such));
  Span span{&row, place_of(*named.node)};
  if (list->size() == 3) {
    if (list->get(2)->value_or(std::string()) != "log") return complain("the third of a range can only be \"log\"");
    span.log = true;
  }
  Parameters low = base;
  Parameters high = base;
  const auto first = assigned(row, *list->get(0), low, faults);
  const auto second = assigned(row, *list->get(1), high, faults);
  if (!first || !second) return std::nullopt;
  span.low = *number_in_unit(row, low);
  span.high = *number_in_unit(row, high);
  if (!(span.low < span.high)) return complain(fmt::format("{} is not below {}", first->value, second->value));
  if (span.log && !(span.low > 0.0)) return complain("a logarithmic range must start above 0");
  return span;
}

/// A number rounded to six digits, as if typed.
Given given_number(const Row& row, double value) {
  const std::string digits = fmt::format("{:.6g}", value);
  if (kind(row) == Kind::quantity) return {fmt::format("{} {}", digits, row.unit), "a string"};
  if (kind(row) == Kind::integer) return {static_cast<std::int64_t>(std::llround(value)), "a number"};
  double rounded = 0.0;
  std::from_chars(digits.data(), digits.data() + digits.size(), rounded);
  return {rounded, "a number"};
}

} // namespace

std::vector<double> stratified(std::size_t n, std::uint64_t seed) {
  std::vector<std::size_t> strip(n);
  std::iota(strip.begin(), strip.end(), std::size_t{0});
  for (std::size_t i = n; i-- > 1;) { // Fisher and Yates
    const double u = uniform(seed, Purpose::sampling, i, 0);
    std::swap(strip[i], strip[static_cast<std::size_t>(u * static_cast<double>(i + 1))]);
  }
  std::vector<double> places(n);
  for (std::size_t i = 0; i < n; ++i)
    places[i] = (static_cast<double>(strip[i]) + uniform(seed, Purpose::sampling, i, 1)) / static_cast<double>(n);
  return places;
}

std::vector<Draft> hypercube_points(const toml::table& hypercube, const Parameters& base, std::uint64_t seed,
                                    Allowance& allowance, FaultList& faults) {
  const toml::node* samples = hypercube.get("samples");
  if (samples == nullptr) faults.add(place_of(hypercube), "latin_hypercube.samples", "is missing; write samples = 50");
  const std::size_t n = samples == nullptr ? 0 : faults.whole(*samples, "latin_hypercube.samples", 1, most_runs);
  std::vector<Span> spans;
  for (const Named& named : named_parameters(hypercube, "latin_hypercube", {"samples"}, faults))
    if (const auto span = span_of(named, base, faults)) spans.push_back(*span);
  if (spans.empty()) {
    if (faults.empty()) faults.add(place_of(hypercube), "latin_hypercube", "has no range of a parameter");
    return {};
  }
  if (!allowance.allows(static_cast<double>(n), place_of(hypercube), "latin_hypercube.samples", faults)) return {};
  std::vector<Draft> drafts(n);
  for (Draft& draft : drafts) draft.point.parameters = base;
  for (const Span& span : spans) {
    const std::uint64_t key = std::stoull(io::text_hash(fmt::format("{} {}", seed, span.row->path)), nullptr, 16);
    const std::vector<double> places = stratified(n, key);
    for (std::size_t i = 0; i < n; ++i) {
      Point& point = drafts[i].point;
      const std::string fault = assign(*span.row, given_number(*span.row, span.at(places[i])), point.parameters);
      if (!fault.empty()) faults.add(span.place, span.row->path, fault);
      point.settings.push_back({std::string(span.row->path), value_text(*span.row, point.parameters)});
      drafts[i].settings.emplace_back(span.row->path, span.place);
      drafts[i].place = span.place;
    }
  }
  for (std::size_t i = 0; i < n; ++i) drafts[i].point.label = fmt::format("sample {}", i + 1);
  return drafts;
}

} // namespace matrigrate::study
