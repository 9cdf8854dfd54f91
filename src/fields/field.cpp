#include "fields/field.hpp"

#include "fields/expression.hpp"
#include "fields/file_words.hpp"
#include "fields/grids.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

namespace matrigrate::fields {

namespace {

constexpr std::array<std::string_view, 3> variables{"x", "y", "r"};

} // namespace

struct Field::Source {
  std::variant<Expression, std::shared_ptr<const Grid>> of;
};

Field::Field(const std::string& text, const std::filesystem::path& folder, Grids* grids) : m_text(text) {
  if (const auto words = file_words(text)) {
    NamedGrid named = grids != nullptr ? grids->of(*words, folder) : Grids().of(*words, folder);
    m_text = std::move(named.text);
    m_source = std::make_unique<Source>(Source{std::move(named.grid)});
  } else {
    m_source = std::make_unique<Source>(Source{Expression(text, variables)});
  }
}

Field::Field(Field&&) noexcept = default;
Field::~Field() = default;

double Field::at(const Vec2& x) const {
  if (const auto* grid = std::get_if<std::shared_ptr<const Grid>>(&m_source->of))
    return m_are_axes ? (*grid)->axis_at(x, m_factor) : m_factor * (*grid)->at(x);
  return m_factor * std::get<Expression>(m_source->of).at(std::array{x.x(), x.y(), std::hypot(x.x(), x.y())});
}

const std::string& Field::column() const {
  static const std::string none;
  const auto* grid = std::get_if<std::shared_ptr<const Grid>>(&m_source->of);
  return grid == nullptr ? none : (*grid)->samples.column;
}

std::string Field::chained() const {
  const auto* formula = std::get_if<Expression>(&m_source->of);
  return formula == nullptr ? std::string() : formula->tree().chained;
}

std::string Field::description() const {
  const auto* grid = std::get_if<std::shared_ptr<const Grid>>(&m_source->of);
  if (grid == nullptr) return "a formula";
  const Samples& s = (*grid)->samples;
  return fmt::format("a grid of {} x {} nodes from ({:g}, {:g}) to ({:g}, {:g}) um", s.columns, s.rows, s.origin.x(),
                     s.origin.y(), s.end().x(), s.end().y());
}

bool names_one_file(const std::string& text) {
  try {
    const auto words = file_words(text);
    return words && words->name.is_absolute() && words->options.contains("hash");
  } catch (const std::invalid_argument&) {
    return false;
  }
}

} // namespace matrigrate::fields
