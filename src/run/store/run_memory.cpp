#include "store/run_memory.hpp"

#include "base/failure.hpp"
#include "store/state_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <stdexcept>

namespace matrigrate::store {

namespace {

/// The id of the first cell, 0, is left out.
Json json_of(const TrackRow& row) {
  Json json{row.t,        row.step,      to_json(row.centre),
            row.area,     row.perimeter, row.polarization ? Json(*row.polarization) : Json(),
            row.in_phase, row.initiated};
  if (row.cell != 0 || row.nucleus) json.push_back(row.cell);
  if (row.nucleus) json.push_back({to_json(row.nucleus->centre), row.nucleus->area, row.nucleus->aspect});
  return json;
}

TrackRow track_of(const Json& json) {
  TrackRow row{.t = number(json.at(0)),
               .step = integer<std::uint64_t>(json.at(1)),
               .cell = json.size() > 8 ? integer<std::uint32_t>(json.at(8)) : 0,
               .centre = vector(json.at(2)),
               .area = number(json.at(3)),
               .perimeter = number(json.at(4)),
               .polarization = {},
               .in_phase = {},
               .initiated = integer<std::uint32_t>(json.at(7))};
  for (std::size_t k = 0; k < row.in_phase.size(); ++k) row.in_phase[k] = integer<std::uint32_t>(json.at(6).at(k));
  if (json.size() > 9)
    row.nucleus = {
        .centre = vector(json.at(9).at(0)), .area = number(json.at(9).at(1)), .aspect = number(json.at(9).at(2))};
  if (!json.at(5).is_null()) row.polarization = json.at(5).get<double>();
  return row;
}

Json json_of(const HealthRow& row) {
  return {row.t,          row.step,         row.iterations,    row.max_iterations, row.residual, row.largest_residual,
          row.area_ratio, row.density_min,  row.density_max,   row.density_bounds, row.orphans,  row.torn,
          row.engulfed,   row.solid_inside, row.deepest_solid, row.crosses_itself, row.fastest,  row.force_imbalance};
}

HealthRow health_of(const Json& json) {
  return {.t = number(json.at(0)),
          .step = integer<std::uint64_t>(json.at(1)),
          .iterations = integer<int>(json.at(2)),
          .max_iterations = integer<int>(json.at(3)),
          .residual = number(json.at(4)),
          .largest_residual = number(json.at(5)),
          .area_ratio = number(json.at(6)),
          .density_min = number(json.at(7)),
          .density_max = number(json.at(8)),
          .density_bounds = integer<std::size_t>(json.at(9)),
          .orphans = integer<std::size_t>(json.at(10)),
          .torn = integer<std::size_t>(json.at(11)),
          .engulfed = integer<std::size_t>(json.at(12)),
          .solid_inside = integer<std::size_t>(json.at(13)),
          .deepest_solid = number(json.at(14)),
          .crosses_itself = json.at(15).get<bool>(),
          .fastest = number(json.at(16)),
          .force_imbalance = number(json.at(17))};
}

/// An undefined value is null.
Json json_of(const GroupRow& row) {
  return {row.t,     row.step,      to_json(row.centre), row.spread, row.speed,
          row.order, row.direction, row.nearest,         row.gap,    row.contacts};
}

GroupRow group_of(const Json& json) {
  return {.t = number(json.at(0)),
          .step = integer<std::uint64_t>(json.at(1)),
          .centre = vector(json.at(2)),
          .spread = number(json.at(3)),
          .speed = number(json.at(4)),
          .order = number(json.at(5)),
          .direction = number(json.at(6)),
          .nearest = number(json.at(7)),
          .gap = number(json.at(8)),
          .contacts = integer<std::size_t>(json.at(9))};
}

Json json_of(const StepHealth& counts) {
  return {counts.solve.iterations, counts.solve.residual, counts.solve.converged, counts.density_bounds,
          counts.orphans,          counts.torn,           counts.engulfed,        counts.list_builds};
}

StepHealth counts_of(const Json& json) {
  return {.solve = {.iterations = integer<int>(json.at(0)),
                    .residual = number(json.at(1)),
                    .converged = json.at(2).get<bool>()},
          .density_bounds = integer<std::size_t>(json.at(3)),
          .orphans = integer<std::size_t>(json.at(4)),
          .torn = integer<std::size_t>(json.at(5)),
          .engulfed = integer<std::size_t>(json.at(6)),
          .list_builds = integer<std::size_t>(json.at(7))};
}

Json json_of(const observe::DrawnProtrusion& drawn) {
  return {{"phase", drawn.phase},
          {"contour", to_json(drawn.contour)},
          {"tip", to_json(drawn.tip)},
          {"anchor", drawn.anchor ? to_json(*drawn.anchor) : Json()}};
}

observe::DrawnProtrusion drawn_of(const Json& json) {
  observe::DrawnProtrusion drawn{.phase = integer<std::size_t>(json.at("phase")),
                                 .contour = vectors(json.at("contour")),
                                 .tip = vector(json.at("tip")),
                                 .anchor = {}};
  if (drawn.phase >= std::variant_size_v<Phase>) throw std::invalid_argument("there is no such phase");
  if (!json.at("anchor").is_null()) drawn.anchor = vector(json.at("anchor"));
  return drawn;
}

Json json_of(const observe::DrawnCell& cell) {
  Json json{{"cell", to_json(cell.outline)}, {"front", to_json(cell.front)}, {"path", to_json(cell.path)}};
  if (!cell.nucleus.empty()) json["nucleus"] = to_json(cell.nucleus);
  return json;
}

observe::DrawnCell drawn_cell_of(const Json& json) {
  observe::DrawnCell cell{
      .outline = vectors(json.at("cell")), .front = vectors(json.at("front")), .path = vectors(json.at("path"))};
  if (json.contains("nucleus")) cell.nucleus = vectors(json.at("nucleus"));
  return cell;
}

/// A single cell, or none, stands among the scene's own keys.
Json json_of(const observe::CellScene& scene) {
  Json matrix = Json::array();
  for (const std::vector<Vec2>& particles : scene.matrix) matrix.push_back(to_json(particles));
  Json protrusions = Json::array();
  for (const observe::DrawnProtrusion& drawn : scene.protrusions) protrusions.push_back(json_of(drawn));
  Json json{
      {"t_s", scene.t}, {"radius_um", scene.radius}, {"spacing_um", scene.spacing}, {"matrix", std::move(matrix)}};
  if (!scene.obstacles.empty()) json["obstacles"] = to_json(scene.obstacles);
  if (scene.cells.size() > 1) {
    for (const observe::DrawnCell& cell : scene.cells) json["cells"].push_back(json_of(cell));
    json["protrusions"] = std::move(protrusions);
    return json;
  }
  const observe::DrawnCell& cell = scene.cells.empty() ? observe::DrawnCell{} : scene.cells.front();
  json["cell"] = to_json(cell.outline);
  json["front"] = to_json(cell.front);
  json["protrusions"] = std::move(protrusions);
  json["path"] = to_json(cell.path);
  if (!cell.nucleus.empty()) json["nucleus"] = to_json(cell.nucleus);
  return json;
}

observe::CellScene scene_of(const Json& json) {
  observe::CellScene scene;
  scene.t = number(json.at("t_s"));
  scene.radius = number(json.at("radius_um"));
  scene.spacing = number(json.at("spacing_um"));
  for (std::size_t k = 0; k < observe::matrix_classes; ++k) scene.matrix[k] = vectors(json.at("matrix").at(k));
  if (json.contains("obstacles")) scene.obstacles = vectors(json.at("obstacles"));
  if (json.contains("cells"))
    for (const Json& cell : json.at("cells")) scene.cells.push_back(drawn_cell_of(cell));
  else
    scene.cells.push_back(drawn_cell_of(json));
  for (const Json& drawn : json.at("protrusions")) scene.protrusions.push_back(drawn_of(drawn));
  return scene;
}

template <class T>
Json list(const std::vector<T>& all) {
  Json json = Json::array();
  for (const T& one : all) json.push_back(json_of(one));
  return json;
}

} // namespace

std::string to_text(const RunMemory& memory) {
  Json json{{"rows", list(memory.rows)},
            {"health", list(memory.health)},
            {"last", memory.last ? json_of(*memory.last) : Json()},
            {"most_iterations", memory.watch.max_iterations},
            {"largest_residual", memory.watch.largest_residual},
            {"counts", json_of(memory.counts)},
            {"scenes", list(memory.scenes)},
            {"frames", memory.frames},
            {"trajectory", memory.trajectory},
            {"march_wall_time_s", memory.march_wall_time}};
  if (!memory.group.empty()) json["group"] = list(memory.group);
  return json.dump();
}

RunMemory parse_memory(const std::string& text) {
  try {
    require_shallow(text);
    const Json json = Json::parse(text);
    RunMemory memory;
    for (const Json& row : json.at("rows")) memory.rows.push_back(track_of(row));
    for (const Json& row : json.at("health")) memory.health.push_back(health_of(row));
    if (!json.at("last").is_null()) memory.last = health_of(json.at("last"));
    memory.watch = {.max_iterations = integer<int>(json.at("most_iterations")),
                    .largest_residual = number(json.at("largest_residual"))};
    if (json.contains("group"))
      for (const Json& row : json.at("group")) memory.group.push_back(group_of(row));
    memory.counts = counts_of(json.at("counts"));
    for (const Json& scene : json.at("scenes")) memory.scenes.push_back(scene_of(scene));
    memory.frames = json.at("frames").get<std::vector<double>>();
    memory.trajectory = integer<std::uint64_t>(json.at("trajectory"));
    memory.march_wall_time = number(json.at("march_wall_time_s"));
    return memory;
  } catch (const Json::exception& error) {
    throw InputOutputError(fmt::format("what the run has written so far cannot be read: {}", error.what()));
  } catch (const std::invalid_argument& error) {
    throw InputOutputError(fmt::format("what the run has written so far cannot be read: {}", error.what()));
  }
}

} // namespace matrigrate::store
