#include "report/run_page.hpp"

#include "parameters/changes.hpp"
#include "parameters/laws/law.hpp"
#include "parameters/schema.hpp"
#include "report/film_json.hpp"
#include "tables/table.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace matrigrate::report {

namespace {

using Json = nlohmann::ordered_json; // NaN is written as null

/// Entries of all cells, cell after cell.
Json tracks_json(std::span<const CellResult> cells) {
  Json json{{"t_s", Json::array()},           {"x_um", Json::array()},         {"y_um", Json::array()},
            {"area_um2", Json::array()},      {"perimeter_um", Json::array()}, {"polarization_rad", Json::array()},
            {"n_simultaneous", Json::array()}};
  for (const CellResult& cell : cells)
    for (const TrackRow& row : cell.rows) {
      json["t_s"].push_back(row.t);
      json["x_um"].push_back(row.centre.x());
      json["y_um"].push_back(row.centre.y());
      json["area_um2"].push_back(row.area);
      json["perimeter_um"].push_back(row.perimeter);
      json["polarization_rad"].push_back(row.polarization.value_or(undefined));
      json["n_simultaneous"].push_back(row.alive());
      if (cells.size() > 1) json["cell"].push_back(number_of(row.cell));
    }
  return json;
}

Json json_of(const store::Field& field) {
  return std::visit([](const auto& value) { return Json(value); }, field);
}

Json protrusions_json(const RunReport& report) {
  Json list = Json::array();
  const std::vector<std::string_view> columns = store::protrusion_columns();
  for (const CellResult& cell : report.cells)
    for (const ProtrusionRecord& record : cell.records) {
      const std::vector<store::Field> row = store::fields(record, report.p);
      Json json;
      if (report.cells.size() > 1) json["cell"] = number_of(cell.cell);
      for (std::size_t i = 0; i < columns.size(); ++i) json[std::string(columns[i])] = json_of(row[i]);
      list.push_back(std::move(json));
    }
  return list;
}

Json readouts_json(const RunReport& report) {
  Json list = Json::array();
  for (const CellResult& cell : report.cells)
    for (const store::NamedValue& v : store::shown_values(cell.readouts, report.p)) {
      list.push_back({{"name", v.name}, {"meaning", v.meaning}, {"value", json_of(v.value)}});
      if (report.cells.size() > 1) list.back()["cell"] = number_of(cell.cell);
    }
  return list;
}

/// A column of health.csv of which a page shows the largest value.
struct Sign {
  const char* column;
  const char* meaning;
  bool ratio = false; ///< of which the largest deviation from 1 is shown
};
constexpr std::array<Sign, 9> signs{{
    {"solver_iterations_max", "iterations of the solver in a step, largest number"},
    {"solver_residual_max", "relative residual of the solver, largest"},
    {"force_imbalance", "sum of inner forces over the sum of their magnitudes, largest"},
    {"n_orphans", "particles made fluid since too few neighbours were left"},
    {"n_torn", "particles made fluid since their density left its allowed range"},
    {"n_engulfed", "solid particles made fluid inside the cell"},
    {"n_solid_inside", "solid particles inside the cell, largest number"},
    {"area_ratio", "area of the cell over its start, largest deviation from 1", true},
    {"density_max", "density of the solid over its start, largest deviation from 1", true},
}};

Json health_json(std::string_view text) {
  const store::Table table = store::read_table(text);
  Json list = Json::array();
  for (const auto& [column, meaning, ratio] : signs) {
    double worst = undefined;
    const auto see = [&, of_one = ratio](const std::string& name) {
      if (table.columns.empty()) return; // a page without results
      for (const double value : table.column(name)) worst = std::fmax(worst, of_one ? std::abs(value - 1.0) : value);
    };
    see(column);
    if (std::string_view(column) == "density_max") see("density_min");
    list.push_back({{"name", column}, {"meaning", meaning}, {"value", worst}});
  }
  return list;
}

Json frames_json(const RunReport& report) {
  Json json = film_json(*report.film);
  if (Json fibres = fibres_json(report.p); !fibres.is_null()) json["fibres"] = std::move(fibres);
  if (Json obstacles = obstacles_json(report.film->head); !obstacles.is_null())
    json["obstacles_um"] = std::move(obstacles);
  return json;
}

/// A value as in a scenario, without quotes.
std::string bare(std::string text) {
  std::erase(text, '"');
  return text;
}

Json changed_parameters(const Parameters& p) {
  const Parameters defaults;
  Json list = Json::array();
  for (const Row& row : schema())
    if (differs(row, p, defaults))
      list.push_back({{"name", row.path},
                      {"value", bare(value_text(row, p))},
                      {"default", bare(value_text(row, defaults))},
                      {"meaning", row.description}});
  if (!p.cells.empty())
    list.push_back({{"name", "cells"},
                    {"value", bare(cells_text(p))},
                    {"default", ""},
                    {"meaning", "Centres of the cells at the start"}});
  return list;
}

Json changes_json(const Parameters& p) {
  Json list = Json::array();
  for (const ChangeWords& change : words_of_changes(p)) list.push_back({{"t_s", change.at}, {"text", to_text(change)}});
  return list;
}

/// Changed laws beside the default ones, over each argument that they depend on.
Json laws_json(const Parameters& p) {
  Json list = Json::array();
  for (const Row* law : changed_laws(p)) {
    Json curves = Json::array();
    for (const LawCurve& curve : law_curves(p, *law, 121))
      curves.push_back({{"over", curve.over.name},
                        {"unit", curve.over.unit},
                        {"at", curve.at},
                        {"x", curve.x},
                        {"changed", curve.changed},
                        {"usual", curve.usual}});
    list.push_back({{"name", law->path},
                    {"text", bare(value_text(*law, p))},
                    {"constants", constants_of(*law, p)},
                    {"unit", law->unit == "1" ? "" : law->unit},
                    {"curves", std::move(curves)}});
  }
  return list;
}

} // namespace

void to_json(Json& json, const Fact& fact) { json = {{"name", fact.name}, {"value", fact.value}}; }

std::string citation() {
  return "Heck et al. 2020, The role of actin protrusion dynamics in cell migration through a degradable viscoelastic "
         "extracellular matrix: Insights from a computational model. PLoS Comput Biol 16(1): e1007250, "
         "doi:10.1371/journal.pcbi.1007250. Computed with Matrigrate; the file CITATION.cff in its source says how to "
         "cite it.";
}

Json run_data(const RunReport& report) {
  const bool plays = report.film != nullptr && !report.film->frames.empty();
  const std::size_t n = plays ? report.film->head.particles() : 0;
  const auto of_a_cell = static_cast<std::size_t>(report.p.cell.particles);
  const std::size_t n_outline = of_a_cell * std::max<std::size_t>(1, report.cells.size());
  return {{"format", "matrigrate-run"},
          {"version", 1},
          {"title", report.title},
          {"status", report.status},
          {"summary", store::result_sentence(report.cells)},
          {"facts", report.facts},
          {"t_end_s", report.t_end},
          {"geometry",
           {{"radius_um", report.p.ecm.radius},
            {"spacing_um", report.p.ecm.particle_spacing},
            {"n_particles", n},
            {"n_outline", n_outline}}},
          {"frames", plays ? frames_json(report) : Json()},
          {"tracks", tracks_json(report.cells)},
          {"protrusions", protrusions_json(report)},
          {"readouts", readouts_json(report)},
          {"parameters", changed_parameters(report.p)},
          {"laws", laws_json(report.p)},
          {"changes", changes_json(report.p)},
          {"health", health_json(report.health)},
          {"provenance", report.provenance},
          {"citation", citation()}};
}

std::string filled_page(std::string_view page_template, const Json& data) {
  constexpr std::string_view place = "<script type=\"application/json\" id=\"matrigrate-data\">null</script>";
  constexpr std::string_view before = "null</script>";
  const std::size_t at = page_template.find(place);
  if (at == std::string_view::npos || page_template.find(place, at + 1) != std::string_view::npos)
    throw std::invalid_argument("the template of a page has no place for data, or several");
  const std::size_t start = at + place.size() - before.size();
  const std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string page;
  page.reserve(page_template.size() + text.size() + 4096); // without growing: it is a large part of all memory
  page = page_template.substr(0, start);
  for (const char c : text) c == '<' ? page += "\\u003c" : page += c;
  return page.append(page_template.substr(start + 4));
}

} // namespace matrigrate::report
