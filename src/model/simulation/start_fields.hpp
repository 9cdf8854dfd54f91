#pragma once

#include "parameters/schema.hpp"
#include "state/initial.hpp"

#include <optional>
#include <string>
#include <vector>

/// Fields that a scenario gives (MODEL.md, I32), on the particles of its matrix. Test:
/// tests/unit/simulation/start_fields_test.cpp
namespace matrigrate {

/// The fields of a scenario as functions of the reference position. A field whose values are those of the uniform
/// matrix is left out, so that it gives the same bits.
/// @throws ConfigurationError with all faults: a text or a file that cannot be read any more, a value that is not
/// allowed
MatrixFields matrix_fields(const Parameters& p);

/// What is wrong with the values of a field: one is not finite or out of range. Empty without a fault, or without a
/// field.
std::string fault_of_field(const Parameters& p, const Row& row);

/// What is wrong with a field that is a formula and compares three values at once. Runs of earlier versions have such
/// fields, so they are refused at the start only.
std::string fault_of_chained_field(const Parameters& p, const Row& row);

/// Message that names a place at which an obstacle lies on a cell, or in the fluid margin around it, at the start.
/// Empty if there is no such place, or if the field itself has a fault.
std::string fault_of_obstacles(const Parameters& p);

/// A field as `explain` shows it.
struct FieldSummary {
  const Row* row = nullptr;
  std::string source;           ///< "a formula"; "a grid of 301 x 301 nodes from ..."
  double low = 0.0, high = 0.0; ///< over the particles, in the unit of the row
  std::vector<double> values;   ///< at the particles' reference positions
};

/// The fields that are given, and the places of their values: the particles of the matrix [um].
struct FieldSummaries {
  std::vector<Vec2> places;
  std::vector<FieldSummary> fields;
};
FieldSummaries field_summaries(const Parameters& p);

/// The uniform matrix as stiff as the stiffest place of a scenario: what bounds the step.
Parameters as_stiff_everywhere(const Parameters& p);

} // namespace matrigrate
