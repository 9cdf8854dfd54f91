#include "parameters/closures.hpp"

#include "parameters/presets.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace matrigrate {

namespace {

/// The latest set first.
constexpr std::array names{"third", "second", "first"};

/// All values of each set.
const std::array<Parameters, 3>& sets() {
  static const std::array<Parameters, 3> all = [] {
    const Parameters second = parameters_of(*find_preset("second-closures"));
    // The first set differs from the second in these, and in readings that have gone (tag closures-2).
    return std::array{Parameters{}, second,
                      apply_overrides(second, {"contact.fluid_share=0.1", "contact.body_fluid_share=0.1",
                                               "adhesion.rest_speed=0 nm/s",
                                               "laws.curvature_factor=max(0, 1 - abs(kappa - kappa_0)/kappa_w)"})};
  }();
  return all;
}

/// The parameters that the sets differ in, in the order of the schema.
const std::vector<const Row*>& rows_of_sets() {
  static const std::vector<const Row*> rows = [] {
    std::vector<const Row*> found;
    for (const Row& row : schema())
      if (!row.path.starts_with("run.")
          && std::ranges::any_of(sets(), [&](const Parameters& set) { return differs(row, set, {}); }))
        found.push_back(&row);
    return found;
  }();
  return rows;
}

/// What to do about the closures of a set, or about mixed ones.
std::string note_of(std::size_t set, const std::string& text) {
  if (set == 0) return {};
  if (set == 1)
    return fmt::format("the closures are of the {}, as the preset second-closures has them; the default is the third",
                       text);
  if (set == 2)
    return fmt::format(
        "the numbers of the closures are of the {}, but its readings have gone: results are not those of "
        "that set, which the version of the tag closures-2 computes; begin from a new file (matrigrate "
        "new), or from --preset second-closures",
        text);
  return fmt::format("the closures are {}: results belong to no set. For the second set begin from matrigrate new FILE "
                     "--preset second-closures, for the third leave out those values of earlier sets",
                     text);
}

} // namespace

Closures closures_of(const Parameters& p) {
  constexpr std::size_t none = names.size();
  std::array<bool, none> is_whole{true, true, true};
  std::array<std::string, none + 1> values; // by the latest set that has them; the last ones are of no set
  for (const Row* row : rows_of_sets()) {
    std::array<bool, none> has{};
    std::ranges::transform(sets(), has.begin(), [&](const Parameters& set) { return !differs(*row, set, p); });
    const auto latest = static_cast<std::size_t>(std::ranges::find(has, true) - has.begin());
    for (std::size_t set = 0; set < none; ++set) is_whole[set] = is_whole[set] && (has[set] || latest == none);
    values[latest] += fmt::format("{}{} = {}", values[latest].empty() ? "" : ", ", row->path, value_text(*row, p));
  }
  const auto set = static_cast<std::size_t>(std::ranges::find(is_whole, true) - is_whole.begin());
  std::string text;
  if (set == none) {
    text = fmt::format("mixed: of the third set {}", values[0]);
    for (const std::size_t earlier : {1, 2})
      if (!values[earlier].empty()) text += fmt::format("; of the {} {}", names[earlier], values[earlier]);
  } else {
    text = fmt::format("{} set", names[set]);
  }
  if (!values[none].empty()) text += fmt::format("{}{}", set == none ? "; of no set " : ", but for ", values[none]);
  return {text, note_of(set, text)};
}

} // namespace matrigrate
