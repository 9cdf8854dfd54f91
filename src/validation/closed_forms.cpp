#include "validation/closed_forms.hpp"

#include "ecm/loop/viscosity.hpp"
#include "state/initial.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace matrigrate::validation {

Vec2 clamped_disc_displacement(const Vec2& force, const Vec2& x, double a, double G, double nu) {
  const double kappa = 3.0 - 4.0 * nu;
  const double r = x.norm();
  const Vec2 e_r = x / r;
  const double C = 1.0 / (8.0 * std::numbers::pi * G * (1.0 - nu)); // a unit force
  const double d = -C / (2.0 * kappa * a * a);
  const double c = C * kappa * std::log(a) + d * (kappa + 2.0) * a * a;
  // components of the force along and across e_r take the places of cos(theta) and -sin(theta)
  const double radial = C * (1.0 - kappa * std::log(r)) + c + d * (kappa - 2.0) * r * r;
  const double across = -C * kappa * std::log(r) + c - d * (kappa + 2.0) * r * r;
  const double along_force = force.dot(e_r);
  return radial * along_force * e_r + across * (force - along_force * e_r);
}

double clamped_disc_compliance(const Kernel& kernel, double a, double G, double nu) {
  const double step = kernel.support() / 24.0;
  const auto grid = [&](double offset) { // points and weights of the kernel, on a grid shifted by a part of a step
    std::vector<std::pair<Vec2, double>> points;
    double sum = 0.0;
    for (int row = -25; row <= 25; ++row)
      for (int column = -25; column <= 25; ++column) {
        const Vec2 x = step * Vec2(column + offset, row + offset);
        if (x.norm() >= kernel.support()) continue;
        points.emplace_back(x, kernel.W(x.norm()));
        sum += points.back().second;
      }
    for (auto& [x, weight] : points) weight /= sum;
    return points;
  };
  double mean = 0.0;
  const auto loaded = grid(0.0);
  for (const auto& [x, of_reading] : grid(0.5)) // so that no point is read where it is loaded: ln r is integrable
    for (const auto& [y, of_load] : loaded)
      mean += of_reading * of_load * clamped_disc_displacement(Vec2(1.0, 0.0), x - y, a, G, nu).x();
  return mean;
}

double lattice_viscosity(const EcmParameters& p) { return sheared_lattice_viscosity(p, 0.0); }

double sheared_lattice_viscosity(const EcmParameters& p, double shear) {
  const Kernel kernel(p.smoothing_length);
  const double V0 = particle_area(p);
  double sum = 0.0;
  for (Vec2 X : lattice_patch(p, (2.0 + std::abs(shear)) * kernel.support())) {
    X.x() += shear * X.y();
    sum += 0.5 * X.y() * X.y()
           * pair_drag(X.squaredNorm(), kernel.W_slope(X.norm()), V0, p.viscosity, p.thickness, kernel.h());
  }
  return sum / (p.thickness * V0);
}

double fit_slope(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size() || x.size() < 2) throw std::invalid_argument("fit_slope: needs two points or more");
  const double n = static_cast<double>(x.size());
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    sx += x[k];
    sy += y[k];
    sxx += x[k] * x[k];
    sxy += x[k] * y[k];
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double fit_time_constant(std::span<const double> t, std::span<const double> y, double y_end) {
  std::vector<double> times, logs;
  const double whole = y_end - y.front();
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double left = (y_end - y[k]) / whole;
    if (left < 0.05 || left > 0.95) continue;
    times.push_back(t[k]);
    logs.push_back(std::log(left));
  }
  return -1.0 / fit_slope(times, logs);
}

} // namespace matrigrate::validation
