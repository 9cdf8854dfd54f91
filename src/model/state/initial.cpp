#include "state/initial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace matrigrate {

namespace {

double row_spacing(const EcmParameters& ecm) {
  return ecm.lattice == Lattice::square ? ecm.particle_spacing : ecm.particle_spacing * std::numbers::sqrt3 / 2.0;
}

/// x of the column in a row: odd rows of the hexagonal lattice are shifted by half a spacing.
double column_x(const EcmParameters& ecm, int column, int row) {
  const bool shifted = ecm.lattice == Lattice::hexagonal && row % 2 != 0;
  return (column + (shifted ? 0.5 : 0.0)) * ecm.particle_spacing;
}

void add(EcmState& s, const Vec2& X, bool clamped) {
  s.X.push_back(X);
  s.clamped.push_back(clamped ? 1 : 0);
}

/// Everything else at rest, intact and free of stress.
EcmState at_rest(EcmState s) {
  const std::size_t n = s.X.size();
  s.x = s.X;
  s.v.assign(n, Vec2::Zero());
  s.rho.assign(n, 1.0);
  s.S.assign(n, Mat2::Zero());
  s.f.assign(n, 1.0);
  return s;
}

} // namespace

double particle_area(const EcmParameters& ecm) { return ecm.particle_spacing * row_spacing(ecm); }

std::vector<Vec2> lattice_patch(const EcmParameters& ecm, double reach) {
  std::vector<Vec2> points;
  const double dy = row_spacing(ecm);
  const int rows = static_cast<int>(std::ceil(reach / dy));
  const int columns = static_cast<int>(std::ceil(reach / ecm.particle_spacing)) + 1;
  for (int row = -rows; row <= rows; ++row)
    for (int column = -columns; column <= columns; ++column) {
      const Vec2 X(column_x(ecm, column, row), row * dy);
      if (X.norm() <= reach) points.push_back(X);
    }
  return points;
}

EcmState disc(const Parameters& p) {
  EcmState s;
  s.V0 = particle_area(p.ecm);
  const double free_radius = p.ecm.radius - 2.0 * p.ecm.smoothing_length;
  for (const Vec2& X : lattice_patch(p.ecm, p.ecm.radius)) add(s, X, X.norm() > free_radius);
  s = at_rest(std::move(s));
  if (p.ecm.cell_hole) {
    const double hole_radius = p.cell.radius + p.degradation.body_distance;
    for (const CellStart& start : cell_starts(p))
      for (std::size_t i = 0; i < s.size(); ++i)
        if ((s.X[i] - Vec2(start.x, start.y)).norm() < hole_radius) s.f[i] = 0.0;
  }
  return s;
}

EcmState strip(const EcmParameters& ecm, double width, double height) {
  EcmState s;
  s.V0 = particle_area(ecm);
  const double dp = ecm.particle_spacing;
  const double dy = row_spacing(ecm);
  const int columns = static_cast<int>(std::ceil(width / dp - 1e-9));
  int rows = static_cast<int>(std::ceil(height / dy - 1e-9));
  if (ecm.lattice == Lattice::hexagonal && rows % 2 == 0) ++rows; // a middle row, and both walls alike
  const int wall_rows = static_cast<int>(std::floor(2.0 * ecm.smoothing_length / dy)) + 1;
  s.period_x = columns * dp;
  const double y_first = -0.5 * (rows - 1) * dy;
  for (int row = -wall_rows; row < rows + wall_rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Vec2 X(column_x(ecm, column, row) - 0.5 * s.period_x, y_first + row * dy);
      add(s, X, row < 0 || row >= rows);
    }
  return at_rest(std::move(s));
}

EcmState rectangle(const EcmParameters& ecm, double width, double height, double grip) {
  EcmState s;
  s.V0 = particle_area(ecm);
  const double dp = ecm.particle_spacing;
  const double dy = row_spacing(ecm);
  const int columns = static_cast<int>(std::lround(width / dp));
  const int rows = static_cast<int>(std::lround(height / dy));
  const double free_half = 0.5 * columns * dp - grip;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Vec2 X(column_x(ecm, column, row) - 0.5 * (columns - 1) * dp, (row - 0.5 * (rows - 1)) * dy);
      add(s, X, std::abs(X.x()) > free_half);
    }
  return at_rest(std::move(s));
}

} // namespace matrigrate
