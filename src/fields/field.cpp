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

namespace matrigrate::fields {

Field::Field(const std::string& text, const std::filesystem::path& folder, Grids* grids) : m_text(text) {
  if (const auto words = file_words(text)) {
    NamedGrid named = grids != nullptr ? grids->of(*words, folder) : Grids().of(*words, folder);
    m_text = std::move(named.text);
    m_grid = std::move(named.grid);
  } else {
    m_formula.emplace(text, std::array<std::string_view, 3>{"x", "y", "r"});
  }
}

double Field::at(const Vec2& x) const {
  if (m_grid) return m_are_axes ? m_grid->axis_at(x, m_factor) : m_factor * m_grid->at(x);
  return m_factor * m_formula->at(std::array{x.x(), x.y(), std::hypot(x.x(), x.y())});
}

std::string Field::column() const { return m_grid ? m_grid->samples.column : ""; }

std::string Field::chained() const { return m_grid ? "" : m_formula->tree().chained; }

std::string Field::description() const {
  if (!m_grid) return "a formula";
  const Samples& s = m_grid->samples;
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
