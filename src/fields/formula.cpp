#include "fields/formula.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <cmath>
#include <stdexcept>

namespace matrigrate::fields {

namespace {

constexpr std::size_t max_length = 1000;

} // namespace

struct Formula::Parser {
  mu::Parser parser;
  double x = 0.0, y = 0.0, r = 0.0;
};

Formula::Formula(const std::string& text) : m_parser(std::make_unique<Parser>()) {
  if (text.size() > max_length)
    throw std::invalid_argument(fmt::format("is a formula of {} characters; allowed are {}", text.size(), max_length));
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
