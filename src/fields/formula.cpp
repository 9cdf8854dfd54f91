#include "fields/formula.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <cctype>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace matrigrate::fields {

namespace {

constexpr std::size_t max_length = 1000;

/// "200.5" of the comma in "x + 200,5"; empty if it does not stand between digits.
std::string with_point(std::string_view text, std::size_t comma) {
  const auto digit = [&](std::size_t k) { return std::isdigit(static_cast<unsigned char>(text[k])) != 0; };
  std::size_t begin = comma, end = comma + 1;
  while (begin > 0 && digit(begin - 1)) --begin;
  while (end < text.size() && digit(end)) ++end;
  if (begin == comma || end == comma + 1) return {};
  return fmt::format("{}.{}", text.substr(begin, comma - begin), text.substr(comma + 1, end - comma - 1));
}

/// muParser would take the last of several values, and set x.
void refuse_several_values_and_assignments(std::string_view text) {
  std::vector<bool> of_function; // for each open parenthesis
  char before = ' ';             // the last character that is no space
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '(') of_function.push_back(before == '_' || std::isalnum(static_cast<unsigned char>(before)) != 0);
    if (c == ')' && !of_function.empty()) of_function.pop_back();
    if (c == ',' && (of_function.empty() || !of_function.back())) {
      const std::string number = with_point(text, k);
      throw std::invalid_argument(fmt::format(
          "cannot be read as a formula in x, y and r, at character {}: a comma stands outside of a function; {}", k + 1,
          number.empty() ? "a formula has one value" : fmt::format("write {} with a decimal point", number)));
    }
    if (c == '=' && text.substr(k, 2) == "==") {
      ++k;
    } else if (c == '=' && before != '!' && before != '<' && before != '>') {
      throw std::invalid_argument(fmt::format(
          "cannot be read as a formula in x, y and r, at character {}: = would set a value; write == to compare",
          k + 1));
    }
    if (c != ' ') before = c;
  }
}

} // namespace

struct Formula::Parser {
  mu::Parser parser;
  double x = 0.0, y = 0.0, r = 0.0;
};

Formula::Formula(const std::string& text) : m_parser(std::make_unique<Parser>()) {
  if (text.size() > max_length)
    throw std::invalid_argument(fmt::format("is a formula of {} characters; allowed are {}", text.size(), max_length));
  refuse_several_values_and_assignments(text);
  try {
    m_parser->parser.DefineVar("x", &m_parser->x);
    m_parser->parser.DefineVar("y", &m_parser->y);
    m_parser->parser.DefineVar("r", &m_parser->r);
    m_parser->parser.SetExpr(text);
    m_parser->parser.Eval();
  } catch (const mu::Parser::exception_type& error) {
    const int place = error.GetPos();
    throw std::invalid_argument(fmt::format("cannot be read as a formula in x, y and r{}: {}",
                                            place >= 0 ? fmt::format(", at character {}", place + 1) : "",
                                            error.GetMsg()));
  }
}

Formula::Formula(Formula&&) noexcept = default;
Formula::~Formula() = default;

double Formula::at(const Vec2& x) const {
  m_parser->x = x.x();
  m_parser->y = x.y();
  m_parser->r = std::hypot(x.x(), x.y());
  return m_parser->parser.Eval();
}

} // namespace matrigrate::fields
