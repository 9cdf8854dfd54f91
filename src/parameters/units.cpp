#include "parameters/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace matrigrate::units {

namespace {

constexpr int one = 1000; // an exponent of 1, in thousandths
constexpr std::size_t longest_text = 80;

struct Symbol {
  std::string_view text;
  Unit unit;
  bool prefixes = false;
};

constexpr Unit minute{{0, one, 0}, one, one, one};           // 60 = 2 3 10
constexpr Unit hour{{0, one, 0}, 2 * one, 2 * one, 2 * one}; // 3600 = 2^2 3^2 10^2
constexpr Unit day{{0, one, 0}, 5 * one, 3 * one, 2 * one};  // 86400 = 2^5 3^3 10^2
constexpr Unit radian{{0, 0, 0, one}};
constexpr Unit degree{{0, 0, 0, one}, -one, -2 * one, -one, one}; // pi/180, 180 = 2 3^2 10

// Exponents of ten follow from um, s, nN: m = 10^6 um, N = 10^9 nN, Pa = N/m^2 = 10^-3 nN/um^2,
// g = 10^-3 N s^2/m = nN s^2/um.
constexpr std::array symbols{
    Symbol{"m", {{one, 0, 0}, 0, 0, 6 * one}, true},
    Symbol{"s", {{0, one, 0}, 0, 0, 0}, true},
    Symbol{"N", {{0, 0, one}, 0, 0, 9 * one}, true},
    Symbol{"Pa", {{-2 * one, 0, one}, 0, 0, -3 * one}, true},
    Symbol{"g", {{-one, 2 * one, one}, 0, 0, 0}, true},
    Symbol{"min", minute, false},
    Symbol{"h", hour, false},
    Symbol{"d", day, false},
    Symbol{"1", {}, false},
    Symbol{"rad", radian, false},
    Symbol{"deg", degree, false},
    Symbol{"°", degree, false},
    Symbol{"degree", degree, false},
    Symbol{"second", {{0, one, 0}}, false},
    Symbol{"minute", minute, false},
    Symbol{"hour", hour, false},
    Symbol{"day", day, false},
};

constexpr std::array<std::pair<std::string_view, int>, 10> prefixes{
    {{"p", -12}, {"n", -9}, {"u", -6}, {"µ", -6}, {"μ", -6}, {"m", -3}, {"c", -2}, {"k", 3}, {"M", 6}, {"G", 9}}};

std::optional<Unit> find_symbol(std::string_view text) {
  const auto is = [text](std::string_view symbol) { // words have a plural: "hours"
    return text == symbol || (symbol.size() >= 3 && text.ends_with('s') && text.substr(0, text.size() - 1) == symbol);
  };
  for (const Symbol& symbol : symbols) // whole symbols first: "min" is a minute, no milli-inch
    if (is(symbol.text)) return symbol.unit;
  for (const auto& [prefix, ten] : prefixes)
    for (const Symbol& symbol : symbols)
      if (symbol.prefixes && text.starts_with(prefix) && text.substr(prefix.size()) == symbol.text) {
        Unit unit = symbol.unit;
        unit.ten += ten * one;
        return unit;
      }
  return std::nullopt;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_space(char c) { return c == ' ' || c == '\t'; }

/// Characters of the decimal number that starts the text; 0 if none does.
std::size_t number_length(std::string_view text) {
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  if (sign == text.size() || (!is_digit(text[sign]) && text[sign] != '.')) return 0; // nan and inf are none
  double number = 0.0; // an e without digits behind it is no exponent, but begins a unit
  const auto [end, error] = std::from_chars(text.data() + sign, text.data() + text.size(), number);
  return error == std::errc::invalid_argument ? 0 : static_cast<std::size_t>(end - text.data());
}

/// Reads a unit from left to right.
class Scanner {
public:
  explicit Scanner(std::string_view text) : m_text(text) {}

  bool at_end() {
    while (!m_text.empty() && is_space(m_text.front())) m_text.remove_prefix(1);
    return m_text.empty();
  }

  bool take(std::string_view token) {
    if (at_end() || !m_text.starts_with(token)) return false;
    m_text.remove_prefix(token.size());
    return true;
  }

  /// The letters of a symbol, or the digit 1.
  std::string_view symbol() {
    at_end();
    std::size_t length = 0;
    if (m_text.starts_with('1'))
      length = 1;
    else
      while (length < m_text.size() && is_letter(length)) ++length;
    const std::string_view found = m_text.substr(0, length);
    m_text.remove_prefix(length);
    return found;
  }

  /// The characters of a decimal number; none if there is none.
  std::string_view number() {
    at_end();
    const std::string_view found = m_text.substr(0, number_length(m_text));
    m_text.remove_prefix(found.size());
    return found;
  }

  /// A signed decimal with at most three decimals, in thousandths.
  std::optional<int> exponent() {
    const bool negative = take("-");
    if (!negative) take("+");
    std::size_t length = 0;
    while (length < m_text.size() && (is_digit(m_text[length]) || m_text[length] == '.')) ++length;
    double value = 0.0;
    const auto [end, error] = std::from_chars(m_text.data(), m_text.data() + length, value);
    const double thousandths = value * one;
    if (error != std::errc{} || end != m_text.data() + length || value > 9.0 || thousandths != std::round(thousandths))
      return std::nullopt;
    m_text.remove_prefix(length);
    return static_cast<int>(negative ? -thousandths : thousandths);
  }

private:
  bool is_letter(std::size_t i) const {
    const char c = m_text[i];
    if (m_text.substr(i).starts_with("·") || (i > 0 && m_text.substr(i - 1).starts_with("·"))) return false;
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80; // micro sign
  }

  std::string_view m_text;
};

void multiply(Unit& product, const Unit& factor, int power) {
  const auto add = [power](int& sum, int exponent) { sum += exponent * power / one; };
  add(product.dimension.length, factor.dimension.length);
  add(product.dimension.time, factor.dimension.time);
  add(product.dimension.force, factor.dimension.force);
  add(product.dimension.angle, factor.dimension.angle);
  add(product.two, factor.two);
  add(product.three, factor.three);
  add(product.ten, factor.ten);
  add(product.pi, factor.pi);
}

/// text with its decimal exponent raised by `shift`.
std::string shifted(std::string_view number, long shift) {
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  constexpr long most = 99999; // beyond any double either way
  if (e < number.size())
    shift += std::clamp(std::strtol(std::string(number.substr(e + 1)).c_str(), nullptr, 10), -most, most);
  return fmt::format("{}e{}", number.substr(0, e), shift);
}

template <class T>
T value_of(const std::string& number) {
  T value{};
  const char* first = number.data() + (number.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(first, number.data() + number.size(), value);
  if (error == std::errc::result_out_of_range) throw std::invalid_argument("is too large or too small a number");
  if (error != std::errc{} || end != number.data() + number.size()) throw std::invalid_argument("is not a number");
  return value;
}

/// Of the magnitude of the exponent: whose sign says whether it multiplies or divides.
long double power(long double base, int thousandths) {
  if (thousandths % one != 0) return std::pow(base, static_cast<long double>(std::abs(thousandths)) / one);
  long double result = 1.0L; // exact as long as it fits the mantissa: 86400^3 does
  for (int i = 0; i < std::abs(thousandths) / one; ++i) result *= base;
  return result;
}

/// number x unit where more than the decimal point moves: one multiplication and one division in extended precision.
double scaled(const std::string& number, const Unit& unit) {
  long double value = value_of<long double>(number);
  long double divisor = 1.0L;
  const auto apply = [&](long double base, int exponent) {
    (exponent >= 0 ? value : divisor) *= power(base, exponent);
  };
  apply(std::numbers::pi, unit.pi); // that of a double, so that 60 deg has the bits of pi/3
  apply(2, unit.two);
  apply(3, unit.three);
  apply(10, unit.ten % one); // whole powers of ten are in the number already
  return static_cast<double>(value / divisor);
}

/// "6 h 30 min" in seconds; none unless it is two times or more, each a number without a sign and the name of a unit.
std::optional<Quantity> sum_of_times(std::string_view text) {
  std::vector<std::pair<std::string_view, Unit>> terms;
  for (Scanner scan(text); !scan.at_end();) {
    const std::string_view number = scan.number();
    const auto unit = find_symbol(scan.symbol());
    if (number.empty() || number.front() == '-' || !unit || unit->dimension != hour.dimension) return std::nullopt;
    terms.emplace_back(number, *unit);
  }
  if (terms.size() < 2) return std::nullopt;
  double seconds = 0.0;
  for (const auto& [number, unit] : terms) seconds += to_internal(number, unit);
  return Quantity{fmt::format("{}", seconds), "s"};
}

/// The same number as people write it: 0.2e3 -> 200.
std::string plain(const std::string& number) { return fmt::format("{}", value_of<double>(number)); }

} // namespace

Unit parse_unit(std::string_view text) {
  if (text.size() > longest_text) throw std::invalid_argument("is too long for a unit");
  Scanner scan(text);
  Unit unit;
  bool divide = scan.take("/");
  bool first = !divide;
  while (!first || !scan.at_end()) {
    const std::string_view symbol = scan.symbol();
    if (symbol.empty()) throw Unreadable(fmt::format("\"{}\" is not a unit", text), true, false);
    const auto factor = find_symbol(symbol);
    if (!factor) {
      const std::string meant = unit_meant(symbol);
      throw Unreadable(fmt::format("\"{}\" is not a unit{}", symbol, meant), true, !meant.empty());
    }
    int exponent = one;
    if (scan.take("^")) {
      const auto given = scan.exponent();
      if (!given)
        throw Unreadable(fmt::format("the exponent of {} in \"{}\" cannot be read", symbol, text), true, false);
      exponent = *given;
    }
    multiply(unit, *factor, divide ? -exponent : exponent);
    if (scan.at_end()) break;
    divide = scan.take("/");
    if (!divide && !scan.take("*")) scan.take("·");
    first = false;
  }
  return unit;
}

Unit quotient(const Unit& a, const Unit& b) {
  Unit unit = a;
  multiply(unit, b, -one);
  return unit;
}

Quantity parse_quantity(std::string_view text) {
  if (text.size() > longest_text) throw std::invalid_argument("is too long for a number with a unit");
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  const std::size_t end = number_length(text);
  if (end == 0) throw std::invalid_argument("is not a number with a unit");
  std::string_view unit = text.substr(end);
  if (unit.size() > 1 && unit[0] == ',' && is_digit(unit[1]))
    throw Unreadable(fmt::format("has a comma; did you mean \"{}.{}\"?", text.substr(0, end), unit.substr(1)), false,
                     true);
  if (auto sum = sum_of_times(text)) return *std::move(sum);
  while (!unit.empty() && is_space(unit.front())) unit.remove_prefix(1);
  return {std::string(text.substr(0, end)), std::string(unit)};
}

double to_internal(std::string_view number, const Unit& unit) {
  const std::string moved = shifted(number, unit.ten / one);
  const double value = unit.decimal() ? value_of<double>(moved) : scaled(moved, unit);
  if (!std::isfinite(value)) throw std::invalid_argument("is too large a number");
  return value;
}

double to_internal(double number, const Unit& unit) { return to_internal(fmt::format("{}", number), unit); }

std::string from_internal(double value, const Unit& unit) {
  if (unit.decimal()) {
    const std::string text = shifted(fmt::format("{}", value), -(unit.ten / one));
    const std::string readable = plain(text);
    return to_internal(readable, unit) == value ? readable : text;
  }
  const double guess = value / to_internal(1.0, unit);
  const std::string text = plain(fmt::format("{:.9g}", guess));
  return to_internal(text, unit) == value ? text : std::string();
}

double number_in(double value, const Unit& unit) {
  const std::string text = from_internal(value, unit);
  return text.empty() ? value / to_internal(1.0, unit) : value_of<double>(text);
}

std::string to_string(const Dimension& d) {
  static constexpr std::array<std::pair<Dimension, std::string_view>, 15> words{
      {{{0, 0, 0}, "a bare number"},
       {{one, 0, 0}, "a length"},
       {{2 * one, 0, 0}, "an area"},
       {{0, one, 0}, "a time"},
       {{0, -one, 0}, "a rate"},
       {{one, -one, 0}, "a speed"},
       {{0, 0, one}, "a force"},
       {{0, 0, -one}, "an inverse force"},
       {{-2 * one, 0, one}, "a stress"},
       {{-2 * one, one, one}, "a viscosity"},
       {{-one, 0, one}, "a stiffness"},
       {{-one, one, one}, "a drag coefficient"},
       {{one, 0, one}, "a bending stiffness"},
       {{-one, 0, 0}, "a curvature"},
       {{0, 0, 0, one}, "an angle"}}};
  const auto word = std::ranges::find(words, d, &std::pair<Dimension, std::string_view>::first);
  if (word != words.end()) return std::string(word->second);
  std::string text;
  const auto append = [&text](std::string_view symbol, int exponent) {
    if (exponent == 0) return;
    text += text.empty() ? "" : " ";
    text += exponent == one ? std::string(symbol) : fmt::format("{}^{}", symbol, static_cast<double>(exponent) / one);
  };
  append("um", d.length);
  append("s", d.time);
  append("nN", d.force);
  append("rad", d.angle);
  return "a quantity in " + text;
}

namespace {

/// Whether a text is a word or its plural, whatever its capital letters.
bool is_word(std::string_view word, std::string_view text) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  if (word.size() >= 3 && text.size() == word.size() + 1 && lower(text.back()) == 's') text.remove_suffix(1);
  return std::ranges::equal(word, text, {}, lower, lower);
}

} // namespace

std::string unit_meant(std::string_view text) {
  static constexpr std::array usual{"Pa", "kPa", "um", "nm", "mm",     "nN",     "pN",   "uN",  "s",
                                    "ms", "min", "h",  "d",  "rad",    "deg",    "MPa",  "GPa", "mPa",
                                    "m",  "N",   "g",  "kg", "second", "minute", "hour", "day"};
  for (const std::string_view unit : usual)
    if (is_word(unit, text)) return fmt::format("; did you mean {}?", unit);
  static constexpr std::array words{std::pair{"pascal", "Pa"}, std::pair{"kilopascal", "kPa"},
                                    std::pair{"micron", "um"}, std::pair{"micrometer", "um"},
                                    std::pair{"sec", "s"},     std::pair{"hr", "h"},
                                    std::pair{"hrs", "h"}};
  for (const auto& [word, unit] : words)
    if (is_word(word, text)) return fmt::format("; did you mean {}?", unit);
  return {};
}

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
