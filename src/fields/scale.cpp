#include "fields/picture.hpp"

#include "base/text.hpp"

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

/// An attribute of OME's element Pixels, in quotes of either kind.
std::optional<std::string_view> attribute(std::string_view element, const std::string& name) {
  for (const char* quote : {"\"", "'"})
    if (const auto value = value_behind(element, " " + name + "=" + quote, quote))
      if (value->data() + value->size() != element.data() + element.size()) return value; // its quote is closed
  return std::nullopt;
}

std::optional<std::size_t> count_of(std::string_view element, const std::string& name) {
  return number_in<std::size_t>(attribute(element, name).value_or(""));
}

/// The start tag of each element of a name, with what follows it up to the next one.
/// @param name  "Pixels"; the name of an XML namespace may stand before it
std::vector<std::string_view> elements(std::string_view xml, const std::string& name) {
  std::vector<std::string_view> found;
  std::size_t last = std::string_view::npos;
  for (std::size_t at = xml.find(name + " "); at != std::string_view::npos; at = xml.find(name + " ", at + 1)) {
    if (at == 0 || (xml[at - 1] != '<' && xml[at - 1] != ':')) continue;
    const std::size_t bracket = xml.rfind('<', at);
    if (bracket == std::string_view::npos || xml.substr(bracket, 2) == "</") continue;
    if (last != std::string_view::npos) found.back() = xml.substr(last, at - last);
    found.push_back(xml.substr(at));
    last = at;
  }
  return found;
}

std::string_view start_tag(std::string_view element) { return element.substr(0, element.find('>')); }

/// Whether the planes of an Image are in a directory of the file: as its elements TiffData say.
bool has_directory(std::string_view pixels, std::size_t directory) {
  for (const std::string_view element : elements(pixels, "TiffData")) {
    const std::string_view tag = start_tag(element);
    const auto first = count_of(tag, "IFD"), planes = count_of(tag, "PlaneCount");
    const std::size_t begin = first.value_or(0);
    if (directory < begin) continue;
    if (planes ? directory - begin < *planes : !first || directory == begin) return true;
  }
  return false;
}

/// @param pixels  of OME-XML: the element Pixels
std::optional<PixelSize> size_of_ome(std::string_view pixels, const StatedScale& page) {
  const std::string_view tag = start_tag(pixels);
  const auto differs = [&](const char* name, std::size_t here) {
    const auto stated = count_of(tag, name);
    return stated && here > 0 && *stated != here;
  };
  if (differs("SizeX", page.columns) || differs("SizeY", page.rows)) return std::nullopt; // a smaller version of it
  const auto side = [&](const std::string& name) -> std::optional<double> {
    const auto size = number_in<double>(attribute(tag, name).value_or(""));
    const auto unit = micrometres(attribute(tag, name + "Unit").value_or("um"));
    return size && unit && std::isfinite(*size) && *size > 0.0 ? std::optional(*size * *unit) : std::nullopt;
  };
  const auto x = side("PhysicalSizeX");
  return x ? std::optional(PixelSize{*x, side("PhysicalSizeY").value_or(*x)}) : std::nullopt;
}

/// Nothing as well where several Images say that the page is theirs, of different sizes.
std::optional<PixelSize> of_ome(const StatedScale& page) {
  const std::vector<std::string_view> images = elements(page.description, "Pixels");
  std::optional<PixelSize> size;
  bool found = false;
  for (const std::string_view pixels : images) {
    if (images.size() > 1 && !has_directory(pixels, page.directory)) continue;
    const auto own = size_of_ome(pixels, page);
    if (found && own != size) return std::nullopt;
    size = own;
    found = true;
  }
  return size;
}

} // namespace

std::optional<PixelSize> pixel_size(const StatedScale& scale) {
  const std::string_view text = scale.description;
  if (text.find("<OME") != std::string_view::npos)
    if (const auto size = of_ome(scale)) return size;
  if (!(scale.x_resolution > 0.0) || !std::isfinite(scale.x_resolution)) return std::nullopt;
  const double y_resolution = scale.y_resolution > 0.0 ? scale.y_resolution : scale.x_resolution;
  std::optional<double> unit;
  if (text.starts_with("ImageJ="))
    if (const auto name = value_behind(text, "\nunit=", "\r\n")) unit = micrometres(*name);
  if (!unit && scale.in_centimetres) unit = 1e4;
  if (!unit) return std::nullopt;
  return PixelSize{*unit / scale.x_resolution, *unit / y_resolution};
}

} // namespace matrigrate::fields
