#include "draw/layer_picture.hpp"

#include "base/time_text.hpp"
#include "draw/particle_picture.hpp"
#include "observe/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matrigrate::draw {

namespace {

ParticlePicture picture(const State& s, const Parameters& p, const std::string& what) {
  std::vector<std::vector<Vec2>> outlines;
  for (const Cell& cell : s.cells) outlines.push_back(cell.cortex.x);
  return {.title = fmt::format("{}, {}", what, time_text(s.t)),
          .value_label = {},
          .position = s.ecm.x,
          .particle_size = p.ecm.particle_spacing,
          .outlines = std::move(outlines)};
}

/// The value that all but one in a thousand stay under, so that a few particles do not take the whole colour bar.
double usual_largest(std::vector<double> values) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) return 1.0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * 999 / 1000);
  std::nth_element(values.begin(), place, values.end());
  return *place > 0.0 ? *place : 1.0;
}

/// Whether a reference coordinate lies on every third row of the lattice.
bool third(double X, double spacing) { return std::abs(std::remainder(X / spacing, 3.0)) < 0.5; }

} // namespace

std::string displacement_picture(const State& s, const Parameters& p) {
  ParticlePicture drawn = picture(s, p, "Displacement of the matrix");
  drawn.value_label = "displacement (µm)";
  drawn.value = displacement_field(s.ecm);
  drawn.value_max = usual_largest(drawn.value);
  const double dp = p.ecm.particle_spacing;
  drawn.arrow.assign(s.ecm.size(), Vec2::Zero());
  for (std::size_t i = 0; i < s.ecm.size(); ++i)
    if (std::isfinite(drawn.value[i]) && third(s.ecm.X[i].x(), dp) && third(s.ecm.X[i].y(), dp))
      drawn.arrow[i] = s.ecm.displacement(i);
  drawn.arrow_scale = 3.0 * dp / drawn.value_max;
  return to_svg(drawn, 900);
}

std::string fibre_stress_picture(const State& s, const Parameters& p, const FibreNetwork& network) {
  ParticlePicture drawn = picture(s, p, "Von Mises stress of the fibres");
  drawn.value_label = "von Mises stress (Pa)";
  drawn.value = fibre_stress_field(s.ecm, p.fibres, network);
  for (double& value : drawn.value) value *= 1e3;
  drawn.value_max = usual_largest(drawn.value);
  return to_svg(drawn, 900);
}

} // namespace matrigrate::draw
