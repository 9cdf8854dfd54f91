#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

/// Plots as data: a page of the viewer draws them. Test: tests/unit/report/report_test.cpp
namespace matrigrate::report {

enum class Mark { line, dashed, points };

/// A curve of a plot. x and y are of one length; values that are not finite, or not positive on a logarithmic axis,
/// break the line.
struct Series {
  std::string label = {}; ///< legend entry; empty for none
  std::vector<double> x = {}, y = {};
  Mark mark = Mark::line;
  int colour = -1; ///< index into the palette of viewer/src/colour.ts; -1 takes the next one

  void add(double at, double value) {
    x.push_back(at);
    y.push_back(value);
  }
};

/// Curves over linear or logarithmic axes.
struct Plot {
  std::string name = {}; ///< unique in its report
  std::string title = {};
  std::string caption = {};               ///< one or two sentences
  std::string x_label = {}, y_label = {}; ///< with unit: "time [s]"
  bool log_x = false, log_y = false;
  std::vector<Series> series = {};
};

/// As viewer/src/verdicts/contract.ts describes it; colours are chosen.
/// @throws std::invalid_argument if x and y of a series differ in length
nlohmann::ordered_json plot_json(const Plot& plot);

} // namespace matrigrate::report
