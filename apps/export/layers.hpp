#pragma once

#include "report/film_json.hpp"
#include "run/finished_run.hpp"

#include <string>
#include <string_view>
#include <vector>

/// What the matrix can be coloured by in exports: the layers of the player.
namespace matrigrate::apps {

enum class Layer { degradation, displacement, von_mises, pressure, fibre_von_mises };

/// @throws UsageError if there is no layer of that name
Layer layer_of(const std::string& name);

std::string_view name_of(Layer layer);
std::string_view label_of(Layer layer); ///< with unit: "displacement [um]"
bool is_signed(Layer layer);            ///< whether its colours have a neutral middle at zero

/// @throws UsageError if the run has no such layer: one of fibres where there are none
void require_layer(const run::FinishedRun& run, Layer layer);

/// A layer's value of each particle, NaN in fluid that has none.
std::vector<double> values_of(const observe::Frame& frame, Layer layer);

/// The range of a layer that holds all but one in a thousand values of the film.
report::Limits limits_of(const observe::Film& film, Layer layer);

} // namespace matrigrate::apps
