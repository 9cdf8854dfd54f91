#include "study_plan/fault_list.hpp"

#include "parameters/assign.hpp"
#include "parameters/document.hpp"
#include "parameters/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace matrigrate::study {

toml::table table_of(std::string_view text, const std::string& name) {
  auto document = parse_document(text, name);
  if (auto* fault = std::get_if<Fault>(&document)) throw ConfigurationError({std::move(*fault)});
  return std::move(std::get<toml::table>(document));
}

std::string quoted_list(const std::vector<std::string>& names) {
  constexpr std::size_t most = 20;
  const auto end = names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), most));
  return fmt::format("\"{}\"{}", fmt::join(names.begin(), end, "\", \""), names.size() > most ? ", ..." : "");
}

void FaultList::add(Place place, std::string_view key, std::string message, Hint hint) {
  add({file(), place.line, place.column, excerpt(key, 80), std::move(message)}, std::move(hint));
}

void FaultList::add(const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) add(fault);
}

void FaultList::check_keys(const toml::table& table, std::string_view section, const std::vector<std::string>& keys,
                           const std::string& what) {
  for (const auto& [name, node] : table)
    if (const std::string key(name.str()); std::ranges::find(keys, key) == keys.end())
      add(name, fmt::format("{}.{}", section, key), what, [key, keys] { return did_you_mean(nearest(key, keys)); });
}

const toml::node* FaultList::wanted(const toml::table& table, std::string_view section, std::string_view key,
                                    const std::string& remedy) {
  const toml::node* node = table.get(key);
  if (node == nullptr) add(table, fmt::format("{}.{}", section, key), "is missing" + remedy);
  return node;
}

const toml::table* FaultList::table(const toml::node& node, std::string_view key, std::string_view expected) {
  if (!node.is_table()) add(node, key, fmt::format("is {}, but a {} is expected", type_of(node), expected));
  return node.as_table();
}

std::string FaultList::text(const toml::node& node, std::string_view key) {
  if (const auto* value = node.as_string()) return value->get();
  add(node, key, fmt::format("is {}, but a string in quotes is expected", type_of(node)));
  return {};
}

bool FaultList::flag(const toml::node& node, std::string_view key) {
  if (const auto* value = node.as_boolean()) return value->get();
  add(node, key, fmt::format("is {}; write true or false, without quotes", type_of(node)));
  return false;
}

std::uint64_t FaultList::whole(const toml::node& node, std::string_view key, std::uint64_t low, std::uint64_t high) {
  const auto* value = node.as_integer();
  if (value == nullptr) {
    add(node, key,
        fmt::format("is {}, but a whole number is expected, >= {} and <= {}",
                    node.is_floating_point() ? "no whole number" : type_of(node), low, high));
  } else if (value->get() < 0 || std::cmp_less(value->get(), low) || std::cmp_greater(value->get(), high)) {
    add(node, key, fmt::format("{} is out of range; allowed is >= {} and <= {}", value->get(), low, high));
  } else {
    return static_cast<std::uint64_t>(value->get());
  }
  return low;
}

std::optional<double> FaultList::number(const toml::node& node, std::string_view key) {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (value && std::isfinite(*value)) return value;
  add(node, key, fmt::format("is {}, but a number without quotes is expected", value ? "not finite" : type_of(node)));
  return std::nullopt;
}

std::size_t FaultList::choice(const toml::node& node, std::string_view key, const std::vector<std::string>& names) {
  const auto* value = node.as_string();
  const auto found = value == nullptr ? names.end() : std::ranges::find(names, value->get());
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const bool few = names.size() <= 20; // more have presets and read-outs alone
  const std::string all =
      few ? fmt::format("allowed is \"{}\"", fmt::join(names, "\" or \""))
          : fmt::format("{} lists all {}", key == "preset" ? "`matrigrate list`" : "`matrigrate list --readouts-json`",
                        names.size());
  if (value == nullptr) {
    add(node, key, fmt::format("is {}{}; {}", type_of(node), few ? "" : ", but a name in quotes is expected", all));
    return 0;
  }
  const std::string unknown = fmt::format("\"{}\" is not known", excerpt(value->get()));
  if (few)
    add(node, key, unknown + "; " + all, [typed = value->get(), names] { return did_you_mean(nearest(typed, names)); });
  else
    add(node, key, unknown, [typed = value->get(), names, all] {
      const std::string meant = did_you_mean(nearest_readout(typed, names));
      return meant + (meant.empty() ? "; " : " ") + all;
    });
  return 0;
}

} // namespace matrigrate::study
