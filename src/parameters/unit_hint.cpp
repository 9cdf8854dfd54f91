#include "parameters/unit_hint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace matrigrate::units {

namespace {

bool same_letters(std::string_view a, std::string_view b) { // upper and lower case are the same
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
}

} // namespace

std::string unit_meant(std::string_view text) {
  static constexpr std::array usual{"Pa", "kPa", "um", "nm", "mm",     "nN",     "pN",   "uN",  "s",
                                    "ms", "min", "h",  "d",  "rad",    "deg",    "MPa",  "GPa", "mPa",
                                    "m",  "N",   "g",  "kg", "second", "minute", "hour", "day"};
  for (const std::string_view unit : usual)
    if (same_letters(unit, text)
        || (unit.size() >= 3 && text.size() == unit.size() + 1 && same_letters(fmt::format("{}s", unit), text)))
      return fmt::format("; did you mean {}?", unit);
  static constexpr std::array words{
      std::pair{"pascal", "Pa"},       std::pair{"pascals", "Pa"},     std::pair{"kilopascal", "kPa"},
      std::pair{"kilopascals", "kPa"}, std::pair{"micron", "um"},      std::pair{"microns", "um"},
      std::pair{"micrometer", "um"},   std::pair{"micrometers", "um"}, std::pair{"sec", "s"},
      std::pair{"secs", "s"},          std::pair{"hr", "h"},           std::pair{"hrs", "h"}};
  for (const auto& [word, unit] : words)
    if (same_letters(word, text)) return fmt::format("; did you mean {}?", unit);
  return {};
}

} // namespace matrigrate::units
