#include "simulation/start_fields.hpp"

#include "base/failure.hpp"
#include "fields/field.hpp"
#include "parameters/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

namespace matrigrate {

namespace {

/// The unit of the attractant is of the user's choice.
bool unit_is_free(const Row& row) { return row.path.starts_with("ecm.fields.attractant"); }

/// The field in the unit of its row, its values as they are. @return nothing where the scenario gives no such field
/// @throws ConfigurationError
std::shared_ptr<fields::Field> numbers_of(const Parameters& p, std::string_view path) {
  const Row& row = *find_row(path);
  const std::string& text = text_of(row, p);
  if (text.empty()) return nullptr;
  try {
    auto field = std::make_shared<fields::Field>(text, "", p.grids.get());
    if (!unit_is_free(row)) field->scale(units::factor_of_column(field->column(), row.unit));
    return field;
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError({{"", 0, 0, std::string(path), error.what()}});
  } catch (const InputOutputError& error) {
    throw ConfigurationError({{"", 0, 0, std::string(path), error.what()}});
  }
}

/// The same as the model takes it: the directions of fibres have no sense.
std::shared_ptr<const fields::Field> field_of(const Parameters& p, std::string_view path) {
  const auto field = numbers_of(p, path);
  if (field && path == "fibres.field.direction_deg") field->take_as_axes();
  return field;
}

std::vector<Vec2> places(const Parameters& p) { return lattice_patch(p.ecm, p.ecm.radius); }

} // namespace

MatrixFields matrix_fields(const Parameters& p) {
  std::vector<Fault> faults;
  for (const Row& row : schema())
    if (kind(row) == Kind::field)
      if (std::string fault = fault_of_field(p, row); !fault.empty())
        faults.push_back({"", 0, 0, std::string(row.path), std::move(fault)});
  if (!faults.empty()) throw ConfigurationError(std::move(faults));
  MatrixFields given;
  for (const MatrixField& row : matrix_field_table) {
    const auto field = field_of(p, row.path);
    if (!field || !row.is_read(p)) continue;
    const OfPlace of_place = [field, row, p](const Vec2& X) { return row.from_given(field->at(X), p); };
    const auto varies = [&](const Vec2& X) { return of_place(X) != 1.0; };
    if (!row.one_is_uniform || std::ranges::any_of(places(p), varies)) given.*row.given = of_place;
  }
  const auto as_it_is = [&](std::string_view path, OfPlace& field) {
    if (const auto of_text = field_of(p, path)) field = [of_text](const Vec2& X) { return of_text->at(X); };
  };
  as_it_is("ecm.fields.f_degr", given.f_degr);
  as_it_is("ecm.fields.attractant", given.attractant);
  as_it_is("ecm.fields.obstacle", given.obstacle);
  return given;
}

std::string fault_of_field(const Parameters& p, const Row& row) {
  try {
    const auto field = numbers_of(p, row.path);
    if (!field) return {};
    for (const Vec2& X : places(p)) {
      const double value = field->at(X);
      if (in_range(row, value)) continue; // never of NaN
      return fmt::format("is {} at ({:.4g}, {:.4g}) um; write {}",
                         std::isfinite(value) ? fmt::format("{:g}", value) : "not finite", X.x(), X.y(),
                         allowed_text(row));
    }
  } catch (const ConfigurationError& error) {
    return error.faults().front().message;
  }
  return {};
}

std::string fault_of_chained_field(const Parameters& p, const Row& row) {
  if (!fault_of_field(p, row).empty()) return {};
  const auto field = numbers_of(p, row.path);
  return field ? field->chained() : std::string();
}

std::string fault_of_obstacles(const Parameters& p) {
  const Row& row = *find_row("ecm.fields.obstacle");
  if (!fault_of_field(p, row).empty()) return {};
  const auto obstacle = field_of(p, row.path);
  if (!obstacle) return {};
  const double room = p.cell.radius + p.degradation.body_distance;
  for (const Vec2& X : places(p)) {
    if (!in_obstacle(obstacle->at(X))) continue;
    for (const CellStart& start : cell_starts(p))
      if ((X - Vec2(start.x, start.y)).norm() < room)
        return fmt::format(
            "an obstacle lies on a cell, at ({:.4g}, {:.4g}) um; keep {:.4g} um around the cell's start at "
            "({:.4g}, {:.4g}) um free, or move the cell",
            X.x(), X.y(), room, start.x, start.y);
  }
  return {};
}

FieldSummaries field_summaries(const Parameters& p) {
  FieldSummaries all;
  for (const Row& row : schema()) {
    if (kind(row) != Kind::field) continue;
    const auto field = field_of(p, row.path);
    if (!field) continue;
    if (all.places.empty()) all.places = places(p);
    FieldSummary summary{.row = &row, .source = field->description(), .values = {}};
    for (const Vec2& X : all.places) summary.values.push_back(field->at(X));
    summary.low = std::ranges::min(summary.values);
    summary.high = std::ranges::max(summary.values);
    all.fields.push_back(std::move(summary));
  }
  return all;
}

Parameters as_stiff_everywhere(const Parameters& p) {
  Parameters stiffest = p;
  const auto highest = [&](std::string_view path, double& value) {
    const auto field = field_of(p, path);
    if (!field) return;
    value = 0.0;
    for (const Vec2& X : places(p)) value = std::max(value, field->at(X) / 1000.0); // Pa to kPa
  };
  highest("ecm.fields.youngs_modulus", stiffest.ecm.youngs_modulus);
  highest("fibres.field.stiffness", stiffest.fibres.stiffness);
  return stiffest;
}

} // namespace matrigrate
