#include "fields/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace matrigrate::fields {

namespace {

constexpr std::size_t max_length = 1000;

/// "cannot be read as a formula in x, y and r".
std::string unreadable(std::span<const std::string_view> variables) {
  std::string text = "cannot be read as a formula";
  for (std::size_t k = 0; k < variables.size(); ++k)
    text += fmt::format("{}{}", k == 0 ? " in " : k + 1 < variables.size() ? ", " : " and ", variables[k]);
  return text;
}

/// muParser takes no notice of what is not a number in their second value: max(0, sqrt(-1)) would be 0.
template <class Better>
double best(const double* values, int count, const Better& better) {
  double found = values[0];
  for (int k = 1; k < count; ++k) {
    if (std::isnan(values[k]) || std::isnan(found)) return std::numeric_limits<double>::quiet_NaN();
    if (better(values[k], found)) found = values[k];
  }
  return found;
}

double least(const double* values, int count) { return best(values, count, std::less<>()); }
double largest(const double* values, int count) { return best(values, count, std::greater<>()); }
double sign(double x) { return std::isnan(x) ? x : x < 0.0 ? -1.0 : x > 0.0 ? 1.0 : 0.0; }
double floored(double x) { return std::floor(x); }
double ceiled(double x) { return std::ceil(x); }
double rest(double a, double b) { return a - b * std::floor(a / b); } // has the sign of b

/// One that knows the functions and constants of every formula.
mu::Parser usual_parser() {
  mu::Parser parser;
  parser.ClearConst();
  parser.DefineConst("_pi", std::numbers::pi); // that of muParser is 8e-13 too small
  parser.DefineConst("_e", std::numbers::e);
  parser.DefineFun("min", least);
  parser.DefineFun("max", largest);
  parser.DefineFun("sign", sign);
  parser.DefineFun("floor", floored);
  parser.DefineFun("ceil", ceiled);
  parser.DefineFun("mod", rest);
  return parser;
}

const mu::Parser& known() {
  static const mu::Parser parser = usual_parser();
  return parser;
}

int arguments_of(std::string_view function) {
  const auto found = known().GetFunDef().find(std::string(function));
  return found == known().GetFunDef().end() ? 0 : found->second.GetArgc();
}

/// Characters that are no blanks.
std::size_t length_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](unsigned char c) { return std::isspace(c) == 0 && (c & 0xc0U) != 0x80U; }));
}

/// @throws UnknownName, std::invalid_argument
FormulaTree readable_tree(std::string_view text, std::span<const std::string_view> variables,
                          std::span<const NamedNumber> constants) {
  try {
    return tree_of(text, [&](std::string_view name) {
      return std::ranges::find(variables, name) != variables.end()
             || std::ranges::find(constants, name, &NamedNumber::name) != constants.end();
    });
  } catch (const FormulaFault& fault) {
    const std::string why = fmt::format("{}, at character {}: {}", unreadable(variables), fault.at, fault.what());
    if (fault.unknown.empty()) throw std::invalid_argument(why);
    throw UnknownName(why, fault.unknown);
  }
}

} // namespace

struct Expression::Parser {
  FormulaTree tree;
  mu::Parser parser = usual_parser();
  std::vector<double> values; ///< of the variables
  std::vector<bool> used;
};

Expression::Expression(const std::string& text, std::span<const std::string_view> variables,
                       std::span<const NamedNumber> constants)
    : Expression(readable_tree(text, variables, constants), variables, constants) {}

Expression::Expression(FormulaTree tree, std::span<const std::string_view> variables,
                       std::span<const NamedNumber> constants)
    : m_parser(std::make_unique<Parser>()) {
  m_parser->tree = std::move(tree);
  mu::Parser& parser = m_parser->parser;
  m_parser->values.resize(variables.size(), 0.0);
  try {
    for_each_part(m_parser->tree.whole, [&](const Part& part) {
      const auto named = std::ranges::find(constants, part.text, &NamedNumber::name);
      if (part.kind == Part::Kind::name && named != constants.end()) parser.DefineConst(named->name, named->value);
    });
    for (std::size_t k = 0; k < variables.size(); ++k)
      parser.DefineVar(std::string(variables[k]), &m_parser->values[k]);
    parser.SetExpr(for_evaluation(m_parser->tree.whole));
    parser.Eval();
    const mu::varmap_type& used = parser.GetUsedVar();
    for (const std::string_view name : variables) m_parser->used.push_back(used.contains(std::string(name)));
  } catch (const mu::Parser::exception_type& error) { // the tree is one that muParser reads
    throw std::invalid_argument(fmt::format("{}: {}", unreadable(variables), error.GetMsg()));
  }
}

const FormulaTree& Expression::tree() const { return m_parser->tree; }

Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

double Expression::at(std::span<const double> arguments) const {
  std::ranges::copy(arguments, m_parser->values.begin());
  return m_parser->parser.Eval();
}

bool Expression::uses(std::size_t variable) const { return m_parser->used.at(variable); }

FormulaTree tree_of(std::string_view text, const std::function<bool(std::string_view)>& is_given) {
  const auto refuse_long = [](std::string_view formula) {
    if (const std::size_t length = length_of(formula); length > max_length || formula.size() > 10 * max_length)
      throw std::invalid_argument(fmt::format("is a formula of {} characters; allowed are {}", length, max_length));
  };
  refuse_long(text);
  const auto is_number = [&](std::string_view name) {
    return is_given(name) || known().GetConst().contains(std::string(name));
  };
  FormulaTree tree = formula_tree(text, {is_number, arguments_of});
  refuse_long(written(tree.whole));
  return tree;
}

bool in_every_formula(const std::string& name) {
  return known().GetFunDef().contains(name) || known().GetConst().contains(name);
}

} // namespace matrigrate::fields
