#include "study_plan/range.hpp"

#include "parameters/assign.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace matrigrate::study {

namespace {

using Integer = int& (*)(Parameters&);

double rounded(double value, int digits) {
  const std::string text = fmt::format("{:.{}g}", value, digits);
  double number = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

} // namespace

std::optional<double> number_in_unit(const Row& row, Parameters p) { // NOLINT: members are asked of no const ones
  if (const double* real = real_of(row, p)) return *real / units::to_internal(1.0, unit_of(row));
  if (const auto* integer = std::get_if<Integer>(&row.member)) return (*integer)(p);
  return std::nullopt;
}

double Span::at(double share) const { return log ? low * std::pow(high / low, share) : low + share * (high - low); }

double Span::share(double value) const {
  return log ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

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

Given given_number(const Row& row, double value, int digits) {
  if (kind(row) == Kind::quantity) return {fmt::format("{:.{}g} {}", value, digits, row.unit), "a string"};
  if (kind(row) == Kind::integer) return {static_cast<std::int64_t>(std::llround(value)), "a number"};
  return {rounded(value, digits), "a number"};
}

std::optional<int> digits_for_stratum(const Span& span, double share, std::size_t n) {
  if (kind(*span.row) == Kind::integer) return usual_digits; // several samples may have the same one
  const double strata = static_cast<double>(n), value = span.at(share);
  for (int digits = usual_digits; digits <= most_digits; ++digits)
    if (std::floor(span.share(rounded(value, digits)) * strata) == std::floor(share * strata)) return digits;
  const bool at_its_edge = std::abs(span.share(value) - share) * strata < 1e-6;
  return at_its_edge ? std::optional(most_digits) : std::nullopt;
}

} // namespace matrigrate::study
