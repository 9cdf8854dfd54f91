#pragma once

#include "observe/frame.hpp"
#include "tables/run_files.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The report of a run: one HTML file that plays it and needs nothing else. Made of a template, which viewer/ builds,
/// and of data, whose contract is in viewer/src/contract.ts. Test: tests/unit/report/run_page_test.cpp
namespace matrigrate::report {

/// Something about a run as a whole: "seed", "7".
struct Fact {
  std::string name;
  std::string value;
};
void to_json(nlohmann::ordered_json& json, const Fact& fact); ///< {name, value}

struct RunReport {
  std::string title{};
  std::string status{};      ///< a sentence: how the run ended
  std::vector<Fact> facts{}; ///< what was run, when and how
  double t_end = 0.0;        ///< what it reached [s]
  Parameters p{};
  std::span<const CellResult> cells{}; ///< none: a page without results
  std::string_view health{};           ///< the text of health.csv
  const observe::Film* film = nullptr; ///< none: a page without a player
  std::string provenance{};            ///< its line breaks are kept
};

/// What to cite, on every page.
std::string citation();

/// The data of the page.
nlohmann::ordered_json run_data(const RunReport& report);

/// A template with data in its place.
/// @throws std::invalid_argument if the template has no place for it, or several
std::string filled_page(std::string_view page_template, const nlohmann::ordered_json& data);

} // namespace matrigrate::report
