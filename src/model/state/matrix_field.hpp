#pragma once

#include "parameters/parameters.hpp"
#include "state/ecm.hpp"

#include <array>
#include <functional>
#include <numbers>
#include <string_view>
#include <vector>

/// Properties of the matrix that a scenario gives as functions of the reference position (MODEL.md, I32). A new one is
/// a member of EcmState and a row of the table below; a parameter (parameters.hpp, schema.cpp); and the law that reads
/// it. Start, checkpoints, frames, files and pages take it from the table.
/// Test: tests/unit/state/state_test.cpp
namespace matrigrate {

/// A function of the reference position [um]; empty: the property is uniform.
using OfPlace = std::function<double(const Vec2&)>;

/// What a matrix starts from.
struct MatrixFields {
  OfPlace E_ratio{};           ///< Young's modulus over ecm.youngs_modulus, > 0 [-]
  OfPlace fibre_direction{};   ///< of uniaxial fibres, from the x axis [rad]
  OfPlace fibre_ratio{};       ///< stiffness of fibres over fibres.stiffness, >= 0 [-]
  OfPlace ligand{};            ///< over the usual, >= 0 [-]
  OfPlace attractant_source{}; ///< release, >= 0 [1/s]
  // These change in time, or are kept in another form.
  OfPlace f_degr{};     ///< at the start, in [0, 1]; never raises f [-]
  OfPlace attractant{}; ///< concentration at the start, >= 0 [-]
  OfPlace obstacle{};   ///< in [0, 1]; from 1/2 on part of a rigid obstacle [-]
};

/// A property that does not change in time: one number per particle, none where it is uniform.
struct MatrixField {
  std::string_view path; ///< of its parameter
  std::string_view name; ///< in checkpoints
  std::string_view unit; ///< of the member, and of the property: "1" for a ratio
  std::vector<double> EcmState::*member;
  OfPlace MatrixFields::*given;
  bool (*allowed)(double value);                         ///< of finite values of the member
  double (*from_given)(double given, const Parameters&); ///< value of the member from that of the parameter
  bool (*is_read)(const Parameters&);                    ///< whether the model reads it with these parameters
  /// Left out where it is 1 everywhere: the model then takes the path of the uniform matrix.
  bool one_is_uniform = false;

  /// A layer of pages and a dataset of fields.h5, /matrix/<layer>; empty: it is in neither.
  std::string_view layer{}, layer_unit{}, title{}, meaning{};
  double (*shown)(double value, const Parameters&) = nullptr; ///< in layer_unit
};

inline constexpr auto matrix_field_table = [] {
  constexpr auto positive = [](double value) { return value > 0.0; };
  constexpr auto not_negative = [](double value) { return value >= 0.0; };
  constexpr auto any = [](double /*value*/) { return true; };
  constexpr auto as_given = [](double given, const Parameters& /*p*/) { return given; };
  constexpr auto always = [](const Parameters& /*p*/) { return true; };
  constexpr double Pa = 1000.0; // per kPa
  return std::array{
      MatrixField{.path = "ecm.fields.youngs_modulus",
                  .name = "E_ratio",
                  .unit = "1",
                  .member = &EcmState::E_ratio,
                  .given = &MatrixFields::E_ratio,
                  .allowed = positive,
                  .from_given = [](double E, const Parameters& p) { return E / Pa / p.ecm.youngs_modulus; },
                  .is_read = always,
                  .one_is_uniform = true,
                  .layer = "youngs_modulus",
                  .layer_unit = "Pa",
                  .title = "Young's modulus",
                  .meaning = "Of the intact matrix, at its position at the start.",
                  .shown = [](double ratio, const Parameters& p) { return Pa * ratio * p.ecm.youngs_modulus; }},
      MatrixField{.path = "fibres.field.direction_deg",
                  .name = "fibre_direction",
                  .unit = "rad",
                  .member = &EcmState::fibre_direction,
                  .given = &MatrixFields::fibre_direction,
                  .allowed = any,
                  .from_given = [](double degrees, const Parameters&) { return degrees * std::numbers::pi / 180.0; },
                  .is_read = [](const Parameters& p) { return p.fibres.arrangement == FibreArrangement::uniaxial; }},
      MatrixField{.path = "fibres.field.stiffness",
                  .name = "fibre_ratio",
                  .unit = "1",
                  .member = &EcmState::fibre_ratio,
                  .given = &MatrixFields::fibre_ratio,
                  .allowed = not_negative,
                  .from_given = [](double k_0, const Parameters& p) { return k_0 / Pa / p.fibres.stiffness; },
                  .is_read =
                      [](const Parameters& p) {
                        return p.fibres.arrangement != FibreArrangement::none && p.fibres.stiffness > 0.0;
                      }},
      MatrixField{.path = "ecm.fields.ligand",
                  .name = "ligand",
                  .unit = "1",
                  .member = &EcmState::ligand,
                  .given = &MatrixFields::ligand,
                  .allowed = not_negative,
                  .from_given = as_given,
                  .is_read = always,
                  .layer = "ligand",
                  .layer_unit = "1",
                  .title = "Ligand",
                  .meaning = "On the solid, relative to the usual amount; adhesions need it.",
                  .shown = as_given},
      MatrixField{.path = "ecm.fields.attractant_source",
                  .name = "attractant_source",
                  .unit = "1/s",
                  .member = &EcmState::attractant_source,
                  .given = &MatrixFields::attractant_source,
                  .allowed = not_negative,
                  .from_given = as_given,
                  .is_read = always},
  };
}();

/// Gives the particles of a matrix at rest their properties; clamped ones stay solid, those of obstacles become clamped
/// and solid (MODEL.md, I33).
/// @throws std::invalid_argument naming the place of a value that is out of range or not finite
void apply(const MatrixFields& fields, EcmState& ecm);

/// True if a value of MatrixFields::obstacle makes a particle part of an obstacle.
inline bool in_obstacle(double value) { return value >= 0.5; }

} // namespace matrigrate
