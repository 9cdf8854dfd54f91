#include "fields/field.hpp"

#include "base/file.hpp"
#include "fields/formula.hpp"
#include "fields/samples.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <variant>
#include <vector>

namespace matrigrate::fields {

namespace {

constexpr std::size_t max_table_bytes = std::size_t{1} << 28U;

/// Values of samples, from black to white of a picture.
struct Scaled {
  Samples samples;
  double from = 0.0, to = 1.0;

  double at(const Vec2& x) const { return from + (to - from) * samples.at(x); }
};

/// The words of a text that names a file: "collagen.png pixel=0.5".
struct FileWords {
  std::filesystem::path name;
  std::map<std::string, std::string> options;

  bool picture() const { return name.extension() != ".csv"; }

  /// @throws std::invalid_argument if it is no number
  double number(const char* key, double otherwise) const {
    const auto found = options.find(key);
    if (found == options.end()) return otherwise;
    double value = 0.0;
    const std::string& text = found->second;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
      throw std::invalid_argument(fmt::format("{}={} is no number", key, text));
    return value;
  }
};

bool names_file(const std::string& text) {
  const std::string first = text.substr(0, text.find(' '));
  constexpr std::array endings{".csv", ".png", ".tif", ".tiff"};
  return std::ranges::any_of(endings, [&](const char* ending) { return first.ends_with(ending); });
}

/// @throws std::invalid_argument if an option is unknown
FileWords words_of(const std::string& text) {
  std::istringstream in(text);
  FileWords words;
  std::string word;
  in >> word;
  words.name = word;
  const std::vector<std::string> known = words.picture()
                                             ? std::vector<std::string>{"pixel", "from", "to", "x", "y", "hash"}
                                             : std::vector<std::string>{"column", "hash"};
  while (in >> word) {
    const std::size_t equals = word.find('=');
    const std::string key = word.substr(0, equals);
    if (equals == std::string::npos || std::ranges::find(known, key) == known.end())
      throw std::invalid_argument(
          fmt::format("\"{}\" is not known; after the file may stand {}=...", word, fmt::join(known, "=..., ")));
    words.options[key] = word.substr(equals + 1);
  }
  return words;
}

std::string fingerprint(const std::string& bytes) {
  return fmt::format("{:016x}", XXH3_64bits(bytes.data(), bytes.size()));
}

Scaled picture_of(const FileWords& words, const std::filesystem::path& file) {
  for (const char* needed : {"pixel", "from", "to"})
    if (!words.options.contains(needed))
      throw std::invalid_argument(
          fmt::format("a picture needs {0}=...: write \"{1} pixel=0.5 from=50 to=400\", the width "
                      "of a pixel in um and the values of black and white",
                      needed, words.name.string()));
  const double pixel = words.number("pixel", 1.0);
  if (pixel <= 0.0) throw std::invalid_argument("pixel must be above 0 um");
  return {samples_from_picture(file, pixel, {words.number("x", 0.0), words.number("y", 0.0)}),
          words.number("from", 0.0), words.number("to", 1.0)};
}

} // namespace

struct Field::Source {
  std::variant<Formula, Scaled> of;
};

Field::Field(const std::string& text, const std::filesystem::path& folder) : m_text(text) {
  if (!names_file(text)) {
    m_source = std::make_unique<Source>(Source{Formula(text)});
    return;
  }
  const FileWords words = words_of(text);
  const std::filesystem::path file = std::filesystem::absolute(folder / words.name).lexically_normal();
  const std::string bytes = read_file(file, max_table_bytes);
  const std::string hash = fingerprint(bytes);
  if (const auto given = words.options.find("hash"); given != words.options.end() && given->second != hash)
    throw std::invalid_argument(
        fmt::format("{} has changed: its fingerprint is {}, and was {}", file.string(), hash, given->second));
  try {
    if (words.picture()) {
      m_source = std::make_unique<Source>(Source{picture_of(words, file)});
    } else {
      const auto column = words.options.find("column");
      m_source = std::make_unique<Source>(
          Source{Scaled{samples_from_csv(bytes, column == words.options.end() ? "" : column->second)}});
    }
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", words.name.string(), error.what()));
  }
  m_text = file.string();
  for (const auto& [key, value] : words.options)
    if (key != "hash") m_text += fmt::format(" {}={}", key, value);
  m_text += " hash=" + hash;
}

Field::Field(Field&&) noexcept = default;
Field::~Field() = default;

double Field::at(const Vec2& x) const {
  return std::visit([&](const auto& source) { return source.at(x); }, m_source->of);
}

std::string Field::description() const {
  const auto* scaled = std::get_if<Scaled>(&m_source->of);
  if (scaled == nullptr) return "a formula";
  const Samples& s = scaled->samples;
  return fmt::format("a grid of {} x {} nodes from ({:g}, {:g}) to ({:g}, {:g}) um", s.columns, s.rows, s.origin.x(),
                     s.origin.y(), s.end().x(), s.end().y());
}

} // namespace matrigrate::fields
