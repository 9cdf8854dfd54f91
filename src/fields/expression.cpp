#include "fields/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <utility>
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

/// "cannot be read as a formula in x, y and r".
std::string unreadable(std::span<const std::string_view> variables) {
  std::string text = "cannot be read as a formula";
  for (std::size_t k = 0; k < variables.size(); ++k)
    text += fmt::format("{}{}", k == 0 ? " in " : k + 1 < variables.size() ? ", " : " and ", variables[k]);
  return text;
}

/// muParser would take the last of several values, and set x.
/// @param head  of the message
void refuse_several_values_and_assignments(std::string_view text, const std::string& head) {
  std::vector<bool> of_function; // for each open parenthesis
  char before = ' ';             // the last character that is no space
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '(') of_function.push_back(before == '_' || std::isalnum(static_cast<unsigned char>(before)) != 0);
    if (c == ')' && !of_function.empty()) of_function.pop_back();
    if (c == ',' && (of_function.empty() || !of_function.back())) {
      const std::string number = with_point(text, k);
      throw std::invalid_argument(fmt::format(
          "{}, at character {}: a comma stands outside of a function; {}", head, k + 1,
          number.empty() ? "a formula has one value" : fmt::format("write {} with a decimal point", number)));
    }
    if (c == '=' && text.substr(k, 2) == "==") {
      ++k;
    } else if (c == '=' && before != '!' && before != '<' && before != '>') {
      throw std::invalid_argument(
          fmt::format("{}, at character {}: = would set a value; write == to compare", head, k + 1));
    }
    if (c != ' ') before = c;
  }
}

bool begins_a_name(char c) { return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0; }

} // namespace

struct Expression::Parser {
  mu::Parser parser;
  std::vector<double> values; ///< of the variables
  std::vector<bool> used;
};

Expression::Expression(const std::string& text, std::span<const std::string_view> variables,
                       std::span<const NamedNumber> constants)
    : m_parser(std::make_unique<Parser>()) {
  const std::string head = unreadable(variables);
  if (text.size() > max_length)
    throw std::invalid_argument(fmt::format("is a formula of {} characters; allowed are {}", text.size(), max_length));
  refuse_several_values_and_assignments(text, head);
  mu::Parser& parser = m_parser->parser;
  m_parser->values.resize(variables.size(), 0.0);
  try {
    for (const NamedNumber& constant : constants) parser.DefineConst(constant.name, constant.value);
    for (std::size_t k = 0; k < variables.size(); ++k)
      parser.DefineVar(std::string(variables[k]), &m_parser->values[k]);
    parser.SetExpr(text);
    parser.Eval();
    const mu::varmap_type& used = parser.GetUsedVar();
    for (const std::string_view name : variables) m_parser->used.push_back(used.contains(std::string(name)));
  } catch (const mu::Parser::exception_type& error) {
    const std::string at = error.GetPos() >= 0 ? fmt::format(", at character {}", error.GetPos() + 1) : "";
    const std::string& token = error.GetToken();
    if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN && !token.empty() && begins_a_name(token.front()))
      throw UnknownName(fmt::format("{}{}: there is no {}", head, at, token), token);
    throw std::invalid_argument(fmt::format("{}{}: {}", head, at, error.GetMsg()));
  }
}

Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&& other) noexcept {
  m_parser = std::move(other.m_parser);
  return *this;
}
Expression::~Expression() = default;

double Expression::at(std::span<const double> arguments) const {
  std::ranges::copy(arguments, m_parser->values.begin());
  return m_parser->parser.Eval();
}

bool Expression::uses(std::size_t variable) const { return m_parser->used.at(variable); }

bool in_every_formula(const std::string& name) {
  const mu::Parser parser;
  return parser.GetFunDef().contains(name) || parser.GetConst().contains(name);
}

} // namespace matrigrate::fields
