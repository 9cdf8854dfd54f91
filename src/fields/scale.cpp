#include "fields/scale.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace matrigrate::fields {

namespace {

/// A unit of length as OME and ImageJ write it [um].
std::optional<double> micrometres(std::string_view unit) {
  using namespace std::string_view_literals;
  constexpr std::pair<std::string_view, double> known[]{
      {"\xc2\xb5m"sv, 1.0}, {"\xce\xbcm"sv, 1.0},  {"\xb5m"sv, 1.0},    {"&#181;m"sv, 1.0},
      {"&#xB5;m"sv, 1.0},   {"&#xb5;m"sv, 1.0},    {"um"sv, 1.0},       {"micron"sv, 1.0},
      {"microns"sv, 1.0},   {"micrometer"sv, 1.0}, {"\\u00B5m"sv, 1.0}, {"nm"sv, 1e-3},
      {"mm"sv, 1e3},        {"cm"sv, 1e4},         {"m"sv, 1e6},        {"pm"sv, 1e-6}};
  for (const auto& [name, width] : known)
    if (unit == name) return width;
  return std::nullopt;
}

/// What stands behind a key up to one of the characters that end it; nothing if
/// the key is not there.
std::optional<std::string_view> value_behind(std::string_view text, std::string_view key, std::string_view ends) {
  const std::size_t at = text.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  text.remove_prefix(at + key.size());
  return text.substr(0, text.find_first_of(ends));
}

std::optional<double> number_in(std::optional<std::string_view> text) {
  double value = 0.0;
  if (!text) return std::nullopt;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (error != std::errc() || end != text->data() + text->size() || !std::isfinite(value) || value <= 0.0)
    return std::nullopt;
  return value;
}

double square(double x, double y) {
  if (std::abs(x - y) > 1e-3 * std::max(x, y))
    throw std::invalid_argument(fmt::format("has pixels of {:g} x {:g} um; scale it so that they are "
                                            "square, or state pixel=",
                                            x, y));
  return x;
}

/// An attribute of OME's element Pixels, in quotes of either kind.
std::optional<std::string_view> attribute(std::string_view element, const std::string& name) {
  for (const char* quote : {"\"", "'"})
    if (const auto value = value_behind(element, " " + name + "=" + quote, quote))
      if (value->data() + value->size() != element.data() + element.size()) return value; // its quote is closed
  return std::nullopt;
}

/// @param element  of OME-XML: Pixels, without its end
std::optional<double> of_ome(std::string_view element) {
  const auto side = [&](const std::string& name) -> std::optional<double> {
    const auto size = number_in(attribute(element, name));
    const auto unit = micrometres(attribute(element, name + "Unit").value_or("um"));
    return size && unit ? std::optional(*size * *unit) : std::nullopt;
  };
  const auto x = side("PhysicalSizeX");
  return x ? std::optional(square(*x, side("PhysicalSizeY").value_or(*x))) : std::nullopt;
}

} // namespace

std::optional<double> pixel_width(const StatedScale& scale) {
  const std::string_view text = scale.description;
  const std::size_t ome = text.find("Pixels ");
  if (ome != std::string_view::npos && text.find("<OME") != std::string_view::npos)
    if (const auto width = of_ome(text.substr(ome, text.find('>', ome) - ome))) return width;
  if (!(scale.x_resolution > 0.0) || !std::isfinite(scale.x_resolution)) return std::nullopt;
  const double y_resolution = scale.y_resolution > 0.0 ? scale.y_resolution : scale.x_resolution;
  std::optional<double> unit;
  if (text.starts_with("ImageJ="))
    if (const auto name = value_behind(text, "\nunit=", "\r\n")) unit = micrometres(*name);
  if (!unit && scale.unit == StatedScale::Unit::centimetre) unit = 1e4;
  if (!unit) return std::nullopt;
  return square(*unit / scale.x_resolution, *unit / y_resolution);
}

} // namespace matrigrate::fields
