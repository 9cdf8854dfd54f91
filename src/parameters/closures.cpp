#include "parameters/closures.hpp"

#include "parameters/presets.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace matrigrate {

namespace {

/// A set and all its values; the latest one first.
struct Set {
  std::string_view name;
  Parameters p;
};

/// The first set differs from the second in these, and in readings that have gone (tag closures-2).
const std::vector<std::string>& of_first_set() {
  static const std::vector<std::string> overrides{"contact.fluid_share=0.1", "contact.body_fluid_share=0.1",
                                                  "adhesion.rest_speed=0 nm/s",
                                                  "laws.curvature_factor=max(0, 1 - abs(kappa - kappa_0)/kappa_w)"};
  return overrides;
}

std::span<const Set> sets() {
  static const std::array<Set, 3> all = [] {
    const Parameters second = parameters_of(*find_preset("second-closures"));
    return std::array<Set, 3>{
        {{"third", Parameters{}}, {"second", second}, {"first", apply_overrides(second, of_first_set())}}};
  }();
  return all;
}

/// The parameters that the sets differ in, in the order of the schema.
std::vector<const Row*> rows_of_sets() {
  std::vector<const Row*> rows;
  for (const Row& row : schema())
    if (!row.path.starts_with("run.")
        && std::ranges::any_of(sets(), [&](const Set& set) { return differs(row, set.p, {}); }))
      rows.push_back(&row);
  return rows;
}

/// "contact.fluid_share = 0.15, adhesion.rest_speed = \"4 nm/s\""
std::string listed(const std::vector<ClosureValue>& values, std::string_view set) {
  std::vector<std::string> all;
  for (const ClosureValue& value : values)
    if (set.empty() ? value.sets.empty() : std::ranges::find(value.sets, set) != value.sets.end())
      all.push_back(fmt::format("{} = {}", value.key, value.value));
  return fmt::format("{}", fmt::join(all, ", "));
}

/// The values that one set has and the default has not.
std::vector<ClosureValue> earlier_values(const Closures& closures) {
  std::vector<ClosureValue> values = closures.values;
  std::erase_if(values, [](const ClosureValue& v) { return std::ranges::find(v.sets, "third") != v.sets.end(); });
  return values;
}

} // namespace

Closures closures_of(const Parameters& p) {
  Closures found{.set = "mixed", .values = {}};
  for (const Row* row : rows_of_sets()) {
    ClosureValue value{.key = row->path, .value = value_text(*row, p), .sets = {}};
    for (const Set& set : sets())
      if (!differs(*row, set.p, p)) value.sets.push_back(set.name);
    found.values.push_back(std::move(value));
  }
  for (const Set& set : sets()) {
    const bool has_all = std::ranges::all_of(found.values, [&](const ClosureValue& v) {
      return v.sets.empty() || std::ranges::find(v.sets, set.name) != v.sets.end();
    });
    if (has_all && found.set == "mixed") found.set = set.name;
  }
  return found;
}

std::string closures_text(const Closures& closures) {
  const std::string own = listed(closures.values, "");
  const std::string but = own.empty() ? "" : fmt::format(", but for {}", own);
  if (closures.set != "mixed") return fmt::format("{} set{}", closures.set, but);
  std::string text = fmt::format("mixed: of the third set {}", listed(closures.values, "third"));
  const std::vector<ClosureValue> earlier = earlier_values(closures);
  for (const std::string_view set : {"second", "first"}) {
    std::vector<ClosureValue> values = earlier;
    if (set == "first") // what both have is told of the second
      std::erase_if(values, [](const ClosureValue& v) { return std::ranges::find(v.sets, "second") != v.sets.end(); });
    if (const std::string text_of_set = listed(values, set); !text_of_set.empty())
      text += fmt::format("; of the {} {}", set, text_of_set);
  }
  return own.empty() ? text : fmt::format("{}; of no set {}", text, own);
}

std::string closures_note(const Closures& closures) {
  if (closures.set == "third") return {};
  if (closures.set == "second")
    return fmt::format("the closures are of the {}, as the preset second-closures has them; the default is the third",
                       closures_text(closures));
  if (closures.set == "first")
    return fmt::format(
        "the numbers of the closures are of the {}, but its readings have gone: results are not those of "
        "that set, which the version of the tag closures-2 computes; begin from a new file (matrigrate "
        "new), or from --preset second-closures",
        closures_text(closures));
  return fmt::format("the closures are {}: results belong to no set. For the second set begin from matrigrate new FILE "
                     "--preset second-closures, for the third leave out those values of earlier sets",
                     closures_text(closures));
}

} // namespace matrigrate
