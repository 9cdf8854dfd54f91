#include "apps/export/time_list.hpp"

#include "parameters/units.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <sstream>
#include <stdexcept>

namespace matrigrate::apps {

std::vector<std::string> items_of(const std::string& list) {
  std::vector<std::string> items;
  std::istringstream in(list.empty() ? list : list + ','); // so that nothing behind the last comma is a part, too
  for (std::string text; std::getline(in, text, ',');) {
    const std::size_t begin = text.find_first_not_of(' ');
    items.push_back(begin == std::string::npos ? std::string()
                                               : text.substr(begin, text.find_last_not_of(' ') + 1 - begin));
  }
  return items;
}

double time_of(const std::string& text) {
  if (text.empty()) throw std::invalid_argument("is no time: nothing stands between two commas, or behind the last");
  const units::Quantity quantity = units::parse_quantity(text);
  const bool zero = units::to_internal(quantity.number, units::parse_unit("1")) == 0.0;
  if (quantity.unit.empty() && !zero)
    throw std::invalid_argument(fmt::format("has no unit; write {0} s, {0} min or {0} h", quantity.number));
  const units::Unit unit = units::parse_unit(quantity.unit.empty() ? "s" : quantity.unit);
  if (unit.dimension != units::Dimension{.time = 1000}) throw std::invalid_argument("is no time");
  return units::to_internal(quantity.number, unit);
}

} // namespace matrigrate::apps
