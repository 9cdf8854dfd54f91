#include "apps/export/time_list.hpp"

#include "parameters/units.hpp"

#include <cstddef>
#include <sstream>
#include <stdexcept>

namespace matrigrate::apps {

std::vector<std::string> items_of(const std::string& list) {
  std::vector<std::string> items;
  std::istringstream in(list);
  for (std::string text; std::getline(in, text, ',');) {
    const std::size_t begin = text.find_first_not_of(' ');
    items.push_back(begin == std::string::npos ? std::string()
                                               : text.substr(begin, text.find_last_not_of(' ') + 1 - begin));
  }
  return items;
}

double time_of(const std::string& text) {
  const units::Quantity quantity = units::parse_quantity(text);
  const units::Unit unit = units::parse_unit(quantity.unit.empty() ? "h" : quantity.unit);
  if (unit.dimension != units::Dimension{.time = 1000}) throw std::invalid_argument("is no time");
  return units::to_internal(quantity.number, unit);
}

} // namespace matrigrate::apps
