#include "base/text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace matrigrate {

std::string csv_text(std::string_view field) {
  const bool is_number = number_in<double>(field.substr(field.starts_with('+') ? 1 : 0)).has_value();
  std::string shown(field.find_first_of("=+-@\t\r\n") == 0 && !is_number ? "'" : "");
  shown += field;
  if (shown.find_first_of(",\"\r\n") == std::string::npos) return shown;
  std::string out = "\"";
  for (const char c : shown) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string time_text(double seconds) {
  if (seconds < 60.0) return fmt::format("{:.3g} s", seconds);
  const auto minutes = static_cast<long>(std::floor(seconds / 60.0 + 1e-6));
  const double rest = seconds - 60.0 * static_cast<double>(minutes);
  if (minutes < 60 && rest > 0.5) return fmt::format("{} min {:.0f} s", minutes, std::floor(rest));
  if (minutes < 60) return fmt::format("{} min", minutes);
  return minutes % 60 == 0 ? fmt::format("{} h", minutes / 60) : fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

std::string wall_time_text(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

} // namespace matrigrate
