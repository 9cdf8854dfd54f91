#include "apps/export/layers.hpp"

#include "apps/verbs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace matrigrate::apps {

namespace {

struct LayerOf {
  Layer layer;
  std::string_view name, label;
  const observe::Floats& (*of)(const observe::Frame&); ///< two components of displacement, one of the others
};
constexpr std::array<LayerOf, 5> layers{{
    {Layer::degradation, "degradation", "f_degr: 1 solid, 0 fluid",
     [](const observe::Frame& f) -> const observe::Floats& { return f.matrix.f_degr; }},
    {Layer::displacement, "displacement", "displacement [um]",
     [](const observe::Frame& f) -> const observe::Floats& { return f.matrix.displacement; }},
    {Layer::von_mises, "von_mises", "von Mises stress [Pa]",
     [](const observe::Frame& f) -> const observe::Floats& { return f.matrix.von_mises; }},
    {Layer::pressure, "pressure", "pressure [Pa]",
     [](const observe::Frame& f) -> const observe::Floats& { return f.matrix.pressure; }},
    {Layer::fibre_von_mises, "fibre_von_mises", "von Mises stress of the fibres [Pa]",
     [](const observe::Frame& f) -> const observe::Floats& { return f.matrix.fibre_von_mises; }},
}};

const LayerOf& row_of(Layer layer) { return *std::ranges::find(layers, layer, &LayerOf::layer); }

} // namespace

Layer layer_of(const std::string& name) {
  const auto found = std::ranges::find(layers, name, &LayerOf::name);
  if (found != layers.end()) return found->layer;
  throw UsageError(fmt::format("there is no layer \"{}\"; the layers are: degradation, displacement, von_mises, "
                               "pressure, fibre_von_mises",
                               name));
}

std::string_view name_of(Layer layer) { return row_of(layer).name; }

std::string_view label_of(Layer layer) { return row_of(layer).label; }

bool is_signed(Layer layer) { return layer == Layer::pressure; }

void require_layer(const run::FinishedRun& run, Layer layer) {
  for (const observe::Frame& frame : run.film.frames)
    if (row_of(layer).of(frame).empty())
      throw UsageError(fmt::format("the run has no layer \"{}\": its matrix has no fibres", name_of(layer)));
}

std::vector<double> values_of(const observe::Frame& frame, Layer layer) {
  const observe::Floats& field = row_of(layer).of(frame);
  std::vector<double> values(frame.matrix.f_degr.size(), undefined);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (frame.matrix.f_degr[i] <= 0.0F && layer != Layer::degradation) continue;
    values[i] = layer == Layer::displacement ? std::hypot(field[2 * i], field[2 * i + 1]) : field[i];
  }
  return values;
}

report::Limits limits_of(const observe::Film& film, Layer layer) {
  if (layer == Layer::degradation) return {0.0, 1.0};
  if (layer != Layer::displacement) {
    const report::Limits limits = report::usual_limits(film, row_of(layer).of);
    const double most = std::max(-limits.low, limits.high);
    return is_signed(layer) ? report::Limits{-most, most} : limits;
  }
  std::vector<double> all;
  for (const observe::Frame& frame : film.frames)
    for (const double value : values_of(frame, layer))
      if (std::isfinite(value)) all.push_back(value);
  if (all.empty()) return {};
  const auto place = all.begin() + static_cast<std::ptrdiff_t>((all.size() - 1) * 999 / 1000);
  std::nth_element(all.begin(), place, all.end());
  return {0.0, *place > 0.0 ? *place : 1.0};
}

} // namespace matrigrate::apps
