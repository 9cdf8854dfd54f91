#include "parameters/column_unit.hpp"

#include "parameters/unit_hint.hpp"
#include "parameters/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

namespace matrigrate::units {

namespace {

std::optional<Unit> known(std::string_view text) {
  if (std::ranges::none_of(text, [](unsigned char c) { return std::isalpha(c) != 0 || c > 127; })) return std::nullopt;
  try {
    return parse_unit(text);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// Where a name may state a unit; empty if there is no such place.
std::string_view place_of_unit(std::string_view name) {
  for (const auto& [open, close] : {std::pair('(', ')'), std::pair('[', ']')})
    if (const std::size_t at = name.rfind(open); at != std::string_view::npos && name.ends_with(close))
      return name.substr(at + 1, name.size() - at - 2);
  const std::size_t at = name.rfind('_');
  const std::string_view end = at == std::string_view::npos ? std::string_view() : name.substr(at + 1);
  return end.size() > 1 ? end : std::string_view();
}

} // namespace

double factor_of_column(std::string_view name, std::string_view wanted) {
  const std::string_view stated = place_of_unit(name);
  const std::optional<Unit> unit = known(stated);
  if (!unit) {
    if (const std::string meant = stated.empty() ? std::string() : unit_meant(stated); !meant.empty())
      throw std::invalid_argument(fmt::format("column {}: {} is no unit{}", name, stated, meant));
    return 1.0;
  }
  const Unit of_field = parse_unit(wanted);
  if (unit->dimension != of_field.dimension)
    throw std::invalid_argument(fmt::format("column {} is in {}; wanted is {}", name, stated,
                                            wanted == "1" ? "a number without a unit" : wanted));
  return to_internal(1.0, *unit) / to_internal(1.0, of_field);
}

} // namespace matrigrate::units
