#pragma once

#include "study/results.hpp"
#include "study/study.hpp"

#include <string>
#include <vector>

/// Box plots as SVG. Test: tests/unit/study_report/box_plot_test.cpp
namespace matrigrate::study {

/// Samples side by side: box from quartile to quartile with the median, whiskers after Tukey, each value as a dot, the
/// mean as a cross.
struct BoxPlot {
  std::string title; ///< the quantity with its unit
  std::vector<std::string> labels;
  std::vector<std::vector<double>> samples; ///< one a label; an empty one leaves its place empty
};

/// Plots below each other, in one document.
/// @throws std::invalid_argument if labels and samples differ in number
std::string to_svg(const std::vector<BoxPlot>& plots, const std::string& title);

/// A plot for each read-out of a study, the points side by side; of many points, the first 40.
std::string boxes_svg(const Study& study, const std::vector<Result>& results);
std::vector<BoxPlot> box_plots(const Study& study, const std::vector<Result>& results);

} // namespace matrigrate::study
