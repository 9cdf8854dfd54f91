#include "study/fault_list.hpp"

#include "parameters/nearest.hpp"
#include "parameters/node.hpp"
#include "parameters/scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <iterator>
#include <tuple>
#include <utility>

namespace matrigrate::study {

namespace {

constexpr std::size_t most_faults = 200;

Place place_of_region(const toml::source_region& source) {
  return {static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

} // namespace

Place place_of(const toml::node& node) { return place_of_region(node.source()); }
Place place_of(const toml::key& key) { return place_of_region(key.source()); }

void FaultList::add(Place place, std::string_view key, std::string message) {
  const Fault fault{m_file, place.line, place.column, excerpt(key, 80), std::move(message)};
  const auto same = [&](const Fault& f) {
    return std::tie(f.file, f.line, f.column, f.key, f.message)
           == std::tie(fault.file, fault.line, fault.column, fault.key, fault.message);
  };
  if (std::ranges::none_of(m_faults, same)) m_faults.push_back(fault);
}

void FaultList::add(std::vector<Fault> faults) { std::ranges::move(faults, std::back_inserter(m_faults)); }

std::string FaultList::text(const toml::node& node, std::string_view key) {
  if (const auto* value = node.as_string()) return value->get();
  add(place_of(node), key, fmt::format("is {}, but a string in quotes is expected", type_of(node)));
  return {};
}

bool FaultList::flag(const toml::node& node, std::string_view key) {
  if (const auto* value = node.as_boolean()) return value->get();
  add(place_of(node), key, fmt::format("is {}; write true or false, without quotes", type_of(node)));
  return false;
}

std::uint64_t FaultList::whole(const toml::node& node, std::string_view key, std::uint64_t low, std::uint64_t high) {
  const auto* value = node.as_integer();
  if (value == nullptr) {
    add(place_of(node), key,
        fmt::format("is {}, but a whole number is expected, >= {} and <= {}",
                    node.is_floating_point() ? "no whole number" : type_of(node), low, high));
  } else if (value->get() < 0 || std::cmp_less(value->get(), low) || std::cmp_greater(value->get(), high)) {
    add(place_of(node), key, fmt::format("{} is out of range; allowed is >= {} and <= {}", value->get(), low, high));
  } else {
    return static_cast<std::uint64_t>(value->get());
  }
  return low;
}

std::size_t FaultList::choice(const toml::node& node, std::string_view key, const std::vector<std::string>& names) {
  const auto* value = node.as_string();
  const auto found = value == nullptr ? names.end() : std::ranges::find(names, value->get());
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::string allowed = fmt::format("allowed is \"{}\"", fmt::join(names, "\" or \""));
  if (value == nullptr)
    add(place_of(node), key, fmt::format("is {}; {}", type_of(node), allowed));
  else
    add(place_of(node), key,
        fmt::format("\"{}\" is not known; {}{}", excerpt(value->get()), allowed,
                    did_you_mean(nearest(value->get(), names))));
  return 0;
}

void FaultList::raise() {
  if (m_faults.empty()) return;
  const auto order = [&](const Fault& f) {
    return std::tuple(f.file != m_file, f.line > 0 ? f.line : INT_MAX, f.column);
  };
  std::ranges::stable_sort(m_faults, [&](const Fault& a, const Fault& b) { return order(a) < order(b); });
  if (m_faults.size() > most_faults) {
    const std::size_t more = m_faults.size() - most_faults;
    m_faults.resize(most_faults);
    m_faults.push_back({m_file, 0, 0, "", fmt::format("has {} more faults", more)});
  }
  throw ConfigurationError(std::move(m_faults));
}

} // namespace matrigrate::study
