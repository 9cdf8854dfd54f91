#include "fields/file_words.hpp"

#include "base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace matrigrate::fields {

namespace {

constexpr std::string_view spaces = " \t\r\n";

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_quote(char c) { return c == '"' || c == '\''; }

std::string ending_of(const std::filesystem::path& name) {
  std::string ending = name.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

bool can_be_read(const std::string& ending) {
  return ending == ".csv" || ending == ".png" || ending == ".tif" || ending == ".tiff";
}

/// Whether a word ends as names of files do, ".jpg" or ".h5", and not as numbers do, "2.e5".
bool ends_as_file(std::string_view word) {
  const std::size_t dot = word.rfind('.');
  if (dot == std::string_view::npos || dot == 0) return false;
  const std::string_view ending = word.substr(dot + 1);
  if (ending.size() < 2 || !is_letter(ending.front())) return false;
  if (!std::ranges::all_of(ending, [](char c) { return is_letter(c) || is_digit(c); })) return false;
  const bool exponent = (ending[0] == 'e' || ending[0] == 'E') && std::ranges::all_of(ending.substr(1), is_digit);
  return !(exponent && is_digit(word[dot - 1]));
}

/// Where the options begin: at the space before the first key=.
std::size_t begin_of_options(std::string_view text) {
  for (std::size_t space = text.find_first_of(spaces); space != std::string_view::npos;
       space = text.find_first_of(spaces, space + 1)) {
    std::size_t end = space + 1;
    while (end < text.size() && (is_letter(text[end]) || text[end] == '_')) ++end;
    if (end > space + 1 && end < text.size() && text[end] == '=' && text.substr(end, 2) != "==") return space;
  }
  return text.size();
}

/// How much of a text without quotes is the name of a file: up to the last ending that can be read, else up to the last
/// one. 0 for a formula.
std::size_t length_of_name(std::string_view text) {
  std::size_t length = 0;
  bool readable = false;
  for (std::size_t end = 0; end < text.size();) {
    const std::size_t begin = text.find_first_not_of(spaces, end);
    if (begin == std::string_view::npos) break;
    end = std::min(text.find_first_of(spaces, begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    if (!ends_as_file(word)) continue;
    const bool known = can_be_read(ending_of(word));
    if (known || !readable) length = end;
    readable = readable || known;
  }
  const bool a_path = text.starts_with('/') || text.starts_with("./") || text.starts_with("../");
  return length == 0 && a_path ? text.size() : length;
}

std::string quoted_word(std::istringstream& in, const std::string& text) {
  std::string word;
  in >> std::quoted(word, static_cast<char>(in.peek()));
  if (!in) throw std::invalid_argument(fmt::format("has a quote that does not end: {}", text));
  return word;
}

/// Takes characters up to a space or a sign.
std::string take_word(std::istringstream& in, int sign) {
  std::string word;
  while (in.peek() != std::istringstream::traits_type::eof() && in.peek() != sign
         && spaces.find(static_cast<char>(in.peek())) == std::string_view::npos)
    word += static_cast<char>(in.get());
  return word;
}

std::vector<std::string> known_options(bool picture) {
  if (picture) return {"pixel", "from", "to", "black", "white", "direction", "x", "y", "page", "channel", "hash"};
  return {"column", "hash"};
}

void read_options(FileWords& words, std::istringstream& in, const std::string& text) {
  const std::vector<std::string> known = known_options(words.picture());
  while (in >> std::ws && in.peek() != std::istringstream::traits_type::eof()) {
    const std::string key = take_word(in, '=');
    if (in.peek() != '=' || std::ranges::find(known, key) == known.end())
      throw std::invalid_argument(fmt::format("\"{}\" is not known; allowed after the file: {}=...",
                                              key + (in.peek() == '=' ? "=" : ""), fmt::join(known, "=..., ")));
    in.get();
    const std::string value =
        is_quote(static_cast<char>(in.peek())) ? quoted_word(in, text) : take_word(in, spaces.front());
    if (value.empty()) throw std::invalid_argument(fmt::format("{}= has no value", key));
    if (!words.options.emplace(key, value).second) throw std::invalid_argument(fmt::format("{}= is given twice", key));
  }
}

/// A word that is read back as it is.
std::string as_word(const std::string& word) {
  if (word.find_first_of(spaces) == std::string::npos && !is_quote(word.front())) return word;
  std::ostringstream out;
  out << std::quoted(word);
  return out.str();
}

} // namespace

bool FileWords::picture() const { return ending_of(name) != ".csv"; }

std::string FileWords::word(const std::string& key) const {
  const auto found = options.find(key);
  return found == options.end() ? "" : found->second;
}

std::optional<double> FileWords::number(const std::string& key) const {
  const std::string text = word(key);
  if (text.empty()) return std::nullopt;
  const auto value = number_in<double>(text);
  if (!value || !std::isfinite(*value))
    throw std::invalid_argument(
        fmt::format("{}={} is no number; write it without a unit, and with a decimal point", key, text));
  return value;
}

std::optional<FileWords::Amount> FileWords::amount(const std::string& key) const {
  const std::string text = word(key);
  if (!text.ends_with('%')) {
    const std::optional<double> value = number(key);
    return value ? std::optional(Amount{.value = *value}) : std::nullopt;
  }
  const auto value = number_in<double>(std::string_view(text).substr(0, text.size() - 1));
  if (!value || !(*value >= 0.0 && *value <= 100.0))
    throw std::invalid_argument(fmt::format("{}={} is no percentage from 0% to 100%", key, text));
  return Amount{.value = 0.01 * *value, .percent = true};
}

std::optional<std::size_t> FileWords::count(const std::string& key) const {
  const std::string text = word(key);
  if (text.empty()) return std::nullopt;
  const auto value = number_in<std::size_t>(text);
  if (value.value_or(0) == 0)
    throw std::invalid_argument(fmt::format("{0}={1} is not a whole number >= 1; the first {0} is {0}=1", key, text));
  return value;
}

std::string FileWords::text(const std::filesystem::path& file, const std::string& hash) const {
  std::string text = as_word(file.string());
  for (const auto& [key, value] : options)
    if (key != "hash") text += fmt::format(" {}={}", key, as_word(value));
  return text + " hash=" + hash;
}

std::optional<FileWords> file_words(const std::string& text) {
  const std::size_t first = text.find_first_not_of(spaces);
  if (first == std::string::npos) return std::nullopt;
  FileWords words;
  std::istringstream in(text.substr(first));
  if (is_quote(text[first])) {
    words.name = quoted_word(in, text);
  } else {
    const std::string_view head = std::string_view(text).substr(first, begin_of_options(text.substr(first)));
    const std::size_t length = length_of_name(head);
    if (length == 0) return std::nullopt;
    words.name = head.substr(0, length);
    in.seekg(static_cast<std::streamoff>(length));
  }
  if (!can_be_read(ending_of(words.name)))
    throw std::invalid_argument(fmt::format(
        "the file \"{}\" cannot be read; PNG (.png), TIFF (.tif, .tiff) and CSV (.csv) can", words.name.string()));
  read_options(words, in, text);
  return words;
}

} // namespace matrigrate::fields
