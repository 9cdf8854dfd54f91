#pragma once

#include "draw/particle_picture.hpp"
#include "report/plot.hpp"
#include "report/run_page.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// The report on statements that hold or do not: verification cases, claims of the paper. Like the report of a run, it
/// is made of a template of viewer/ and of data. Test: tests/unit/report/report_test.cpp
namespace matrigrate::report {

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
