#pragma once

#include "draw/particle_picture.hpp"
#include "report/run_page.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// The report on statements that hold or do not: verification cases, claims of the paper. Like the report of a run, it
/// is made of a template of viewer/ and of data. Test: tests/unit/report/report_test.cpp
namespace matrigrate::report {

// Plots as data: a page of the viewer draws them. Test: tests/unit/report/report_test.cpp

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

/// What became of a statement.
enum class Verdict { holds, in_direction, does_not_hold, undecided };

/// "holds", "in direction", "does not hold", "undecided": in texts, tables, JSON and pages.
std::string to_string(Verdict verdict);

/// Sentences under a heading.
struct Sentences {
  std::string name;
  std::vector<std::string> list;
};

/// A statement and its verdict.
struct Statement {
  std::string id;       ///< "A2", "creep"
  std::string kind{};   ///< "calibration", "predicted", ...; empty for none
  std::string sentence; ///< what is stated
  Verdict verdict = Verdict::undecided;
  std::string caveat{};  ///< beside the verdict: "not the paper's runs"; empty for nothing
  std::string published; ///< the paper's numbers; empty where it gives none
  std::string brief{};   ///< ours, in a line
  std::string why_not{}; ///< in a line; empty if it holds
  nlohmann::ordered_json checks = nlohmann::ordered_json::array(); ///< rows as in results.json of `validate`
  nlohmann::ordered_json claims = nlohmann::ordered_json::array(); ///< the paper's, as checks
  std::vector<Sentences> details{};
  std::vector<std::string> studies{}; ///< names of those that it is judged by
  std::vector<Plot> plots{};
  std::vector<draw::Picture> pictures{};
};

struct VerdictReport {
  std::string title;
  std::vector<Fact> facts{}; ///< command, date, version, runs done
  std::string setting{};     ///< how the runs were made
  std::vector<Statement> statements;
  nlohmann::ordered_json studies = nlohmann::ordered_json::array(); ///< {name, study}: study_report/drawn_study.hpp
  std::string provenance;                                           ///< its line breaks are kept
};

/// The data of the page.
nlohmann::ordered_json verdict_data(const VerdictReport& report);

} // namespace matrigrate::report
