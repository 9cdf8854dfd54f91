#include "state/matrix_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace matrigrate {

namespace {

/// The values of a property at all particles; none without a field.
std::vector<double> values(const OfPlace& field, const EcmState& ecm, std::string_view name, bool (*allowed)(double)) {
  std::vector<double> all;
  if (!field) return all;
  for (const Vec2& X : ecm.X) {
    const double value = field(X);
    if (!std::isfinite(value) || !allowed(value))
      throw std::invalid_argument(
          fmt::format("{} of the matrix is {} at ({:.4g}, {:.4g}) um", name, value, X.x(), X.y()));
    all.push_back(value);
  }
  return all;
}

bool is_share(double value) { return value >= 0.0 && value <= 1.0; }

} // namespace

void apply(const MatrixFields& fields, EcmState& ecm) {
  for (const MatrixField& field : matrix_field_table)
    ecm.*field.member = values(fields.*field.given, ecm, field.name, field.allowed);
  const std::vector<double> f = values(fields.f_degr, ecm, "f_degr", is_share);
  for (std::size_t i = 0; i < f.size(); ++i)
    if (!ecm.clamped[i]) ecm.f[i] = std::min(ecm.f[i], f[i]);
  ecm.attractant = values(fields.attractant, ecm, "attractant", [](double a) { return a >= 0.0; });
  if (!ecm.attractant_source.empty() && ecm.attractant.empty()) ecm.attractant.assign(ecm.size(), 0.0);
  const std::vector<double> o = values(fields.obstacle, ecm, "obstacle", is_share);
  if (std::ranges::none_of(o, in_obstacle)) return;
  for (std::size_t i = 0; i < o.size(); ++i) {
    ecm.obstacle.push_back(in_obstacle(o[i]) ? 1 : 0);
    if (ecm.obstacle[i] == 0) continue;
    ecm.clamped[i] = 1;
    ecm.f[i] = 1.0;
  }
}

} // namespace matrigrate
