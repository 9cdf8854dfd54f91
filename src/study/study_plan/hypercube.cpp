#include "base/random.hpp"
#include "parameters/assign.hpp"
#include "store/trajectory_hash.hpp"
#include "study_plan/range.hpp"
#include "study_plan/sweep.hpp"

#include <fmt/format.h>

#include <numeric>

namespace matrigrate::study {

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
  const std::size_t n = samples == nullptr ? 0 : faults.whole(*samples, "latin_hypercube.samples", 1, max_runs);
  std::vector<Span> spans;
  for (const Named& named : named_parameters(hypercube, "latin_hypercube", {"samples"}, base, faults))
    if (const auto span = span_of(named, base, faults)) spans.push_back(*span);
  if (spans.empty()) {
    if (faults.empty()) faults.add(place_of(hypercube), "latin_hypercube", "has no range of a parameter");
    return {};
  }
  if (!allowance.allows(static_cast<double>(n), place_of(hypercube), "latin_hypercube.samples", faults)) return {};
  std::vector<Draft> drafts(n);
  for (Draft& draft : drafts) draft.point.parameters = base;
  for (const Span& span : spans) {
    const std::uint64_t key = std::stoull(store::text_hash(fmt::format("{} {}", seed, span.row->path)), nullptr, 16);
    const std::vector<double> places = stratified(n, key);
    for (std::size_t i = 0; i < n; ++i) {
      Point& point = drafts[i].point;
      const std::optional<int> digits = digits_for_stratum(span, places[i], n);
      if (!digits) {
        faults.add(
            span.place, span.row->path,
            fmt::format("the range is too narrow for {} different values; take fewer samples or a wider range", n));
        return {};
      }
      const std::string fault =
          assign(*span.row, given_number(*span.row, span.at(places[i]), *digits), point.parameters);
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
