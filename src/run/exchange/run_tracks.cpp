#include "exchange/run_tracks.hpp"

#include "parameters/changes.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

namespace matrigrate::exchange {

namespace {

constexpr double same_time = 1e-3; // [s]

/// The ids of the cells, in the order of their first rows.
std::vector<std::uint32_t> cells_of(std::span<const TrackRow> rows) {
  std::vector<std::uint32_t> cells;
  for (const TrackRow& row : rows)
    if (std::ranges::find(cells, row.cell) == cells.end()) cells.push_back(row.cell);
  return cells;
}

/// Radius of the disc of the same area [um].
double radius(const TrackRow& row) { return std::sqrt(row.area / std::numbers::pi); }

/// A cell of a run.
struct Track {
  std::string front; ///< of its lines in tables: those of its run, and "cell 1"
  std::uint64_t id;  ///< among all
  std::vector<TrackRow> rows;
};

std::vector<Track> tracks_of(std::span<const RunTracks> runs) {
  std::vector<Track> tracks;
  for (const RunTracks& run : runs)
    for (const std::uint32_t cell : cells_of(run.rows)) {
      const std::string unique = fmt::format("{}_{}", run.name, tracks.size());
      const std::string label = fmt::format("cell {}", number_of(cell));
      std::string front = store::csv_line(
          {unique, run.condition, store::count(run.replicate), store::count(run.replicate), run.name, label});
      front.back() = ',';
      tracks.push_back({std::move(front), tracks.size(), rows_of(run.rows, cell)});
    }
  return tracks;
}

/// @throws std::invalid_argument if a run has no row at many of them, or none but the first
void require_possible(const RunTracks& run, double every, const observe::EvenTimes& there, double length) {
  if (there.all < 2) return; // said otherwise
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(
        fmt::format("every {:g} s is {}; {} has positions {}, for {:g} s", every, why, run.name, there.text(), length));
  };
  if (every < there.least - std::min(same_time, 0.5 * there.least)) refuse("less than the time between two positions");
  if (every > length + same_time) refuse("longer than the run");
}

std::vector<double> wanted_times(const RunTracks& run, const std::vector<double>& there, const Times& times) {
  if (!times.every) return times.list.empty() ? there : times.list;
  std::vector<double> wanted;
  if (there.empty()) return wanted;
  require_possible(run, *times.every, observe::even_times(there), there.back() - there.front());
  const double end = there.back() + same_time;
  for (double k = 0.0; k * *times.every <= end; ++k) wanted.push_back(k * *times.every);
  return wanted;
}

} // namespace

std::vector<TrackRow> rows_at(const RunTracks& run, const Times& times) {
  const std::vector<double> there = observe::times_of(run.rows);
  std::vector<TrackRow> rows;
  std::vector<std::string> missing;
  auto row = run.rows.begin();
  for (const double t : wanted_times(run, there, times)) {
    row = std::find_if(row, run.rows.end(), [&](const TrackRow& r) { return r.t >= t - same_time; });
    if (row == run.rows.end() || row->t > t + same_time) missing.push_back(fmt::format("{:g} s", t));
    for (; row != run.rows.end() && row->t <= t + same_time; ++row) {
      rows.push_back(*row);
      rows.back().t = t;
    }
  }
  if (missing.empty()) return rows;
  const std::size_t named = std::min<std::size_t>(missing.size(), 5);
  const std::string more = missing.size() > named ? fmt::format(" and {} more", missing.size() - named) : "";
  missing.resize(named);
  if (there.size() < 2) throw std::invalid_argument(fmt::format("{} has too few positions", run.name));
  throw std::invalid_argument(fmt::format(
      "{} has no position at {}{}: it has them {} from {:g} to {:g} s, and none is interpolated; "
      "output.track_interval sets that interval",
      run.name, fmt::join(missing, ", "), more, observe::even_times(there).text(), there.front(), there.back()));
}

std::string spots_csv(std::span<const RunTracks> runs) {
  const bool even = std::ranges::all_of(
      runs, [](const RunTracks& run) { return observe::even_times(observe::times_of(run.rows)).is_even(); });
  std::string text = fmt::format("Unique_ID,Condition,experiment_nb,Repeat,File_name,LABEL,ID,TRACK_ID,POSITION_X,"
                                 "POSITION_Y,POSITION_Z,POSITION_T,{}RADIUS,SPACE_UNIT,TIME_UNIT\n",
                                 even ? "FRAME," : "");
  std::uint64_t spot = 0;
  for (const Track& track : tracks_of(runs))
    for (std::size_t k = 0; k < track.rows.size(); ++k) {
      const TrackRow& row = track.rows[k];
      std::vector<store::Field> line{spot++, track.id, row.centre.x(), row.centre.y(), 0.0, row.t};
      if (even) line.push_back(store::count(k));
      line.insert(line.end(), {radius(row), "um", "s"});
      text += track.front + store::csv_line(line);
    }
  return text;
}

std::string tracks_csv(std::span<const RunTracks> runs) {
  std::string text = "Unique_ID,Condition,experiment_nb,Repeat,File_name,LABEL,TRACK_ID,NUMBER_SPOTS,TRACK_START,"
                     "TRACK_STOP\n";
  for (const Track& track : tracks_of(runs))
    text += track.front
            + store::csv_line({track.id, store::count(track.rows.size()), track.rows.front().t, track.rows.back().t});
  return text;
}

std::string celltrackr_csv(std::span<const TrackRow> rows) {
  std::string text = "id,t_s,x_um,y_um\n";
  for (const TrackRow& row : rows)
    text += fmt::format("{},{},{},{}\n", number_of(row.cell), row.t, row.centre.x(), row.centre.y());
  return text;
}

std::string trackmate_csv(std::span<const TrackRow> rows) {
  const bool even = observe::even_times(observe::times_of(rows)).is_even();
  const char* const frame = even ? "FRAME," : "";
  const char* const title = even ? "Frame," : "";
  std::string text = fmt::format(
      "ID,TRACK_ID,POSITION_X,POSITION_Y,POSITION_Z,POSITION_T,{0}RADIUS\nSpot ID,Track ID,X,Y,Z,T,{1}Radius\n"
      "Spot ID,Track ID,X,Y,Z,T,{1}R\n,,(micron),(micron),(micron),(sec),{2}(micron)\n",
      frame, title, even ? "," : "");
  std::map<std::uint32_t, std::size_t> frames; // rows so far of each cell
  for (std::size_t k = 0; k < rows.size(); ++k)
    text += fmt::format("{},{},{},{},0,{},{}{}\n", k, rows[k].cell, rows[k].centre.x(), rows[k].centre.y(), rows[k].t,
                        even ? fmt::format("{},", frames[rows[k].cell]++) : "", radius(rows[k]));
  return text;
}

std::string trackmate_xml(std::span<const TrackRow> rows) {
  std::vector<std::uint32_t> cells = cells_of(rows);
  if (cells.empty()) cells.push_back(0);
  const observe::EvenTimes times = observe::even_times(observe::times_of(rows));
  if (!times.is_even()) throw std::invalid_argument(fmt::format("the rows are {}", times.text()));
  std::string particles;
  for (const std::uint32_t cell : cells) {
    const std::vector<TrackRow> own = rows_of(rows, cell);
    particles += fmt::format("  <particle nSpots=\"{}\">\n", own.size());
    for (std::size_t k = 0; k < own.size(); ++k)
      particles += fmt::format("    <detection t=\"{}\" x=\"{}\" y=\"{}\" z=\"0\" />\n", k, own[k].centre.x(),
                               own[k].centre.y());
    particles += "  </particle>\n";
  }
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Tracks nTracks=\"{}\" spaceUnits=\"um\" "
                     "frameInterval=\"{}\" timeUnits=\"s\" from=\"matrigrate\">\n{}</Tracks>\n",
                     cells.size(), times.interval, particles);
}

namespace {

using Json = nlohmann::ordered_json;

/// As it would follow --set: without the quotes of TOML.
std::string bare(std::string text) {
  if (text.size() > 1 && text.front() == '"' && text.back() == '"') return text.substr(1, text.size() - 2);
  return text;
}

/// The parameters that differ from their defaults, the seed and the threads aside.
Json settings_of(const Parameters& p) {
  Json settings = Json::object();
  for (const Row& row : schema()) {
    if (row.path == "run.seed" || row.path == "run.threads") continue;
    if (differs(row, p, Parameters())) settings[std::string(row.path)] = bare(value_text(row, p));
  }
  if (!p.cells.empty()) settings["cells"] = cells_text(p);
  if (!p.changes.empty()) settings["changes"] = changes_text(p);
  return settings;
}

Json simulations(std::span<const RunTracks> runs) {
  Json all = Json::array();
  for (const RunTracks& run : runs) {
    Json settings = Json::object();
    for (const auto& [key, value] : run.settings) settings[key] = bare(value);
    all.push_back({{"simID", all.size()},
                   {"run", run.name},
                   {"condition", run.condition},
                   {"replicate", run.replicate},
                   {"seed", run.seed},
                   {"parameters", settings}});
  }
  return all;
}

Json process(const char* id, const char* name, const char* description) {
  return {{"process_id", id}, {"name", name}, {"description", description}};
}

} // namespace

std::string openvt_csv(std::span<const RunTracks> runs) {
  std::string text = "simID,time,cellID,cellType,x,y\n";
  for (std::size_t k = 0; k < runs.size(); ++k)
    for (const TrackRow& row : runs[k].rows)
      text += store::csv_line({store::count(k), row.t, std::uint64_t{number_of(row.cell)}, std::uint64_t{0},
                               row.centre.x(), row.centre.y()});
  return text;
}

std::string openvt_record(const OpenVtModel& model, std::span<const RunTracks> runs) {
  const Json record{
      {"$schema", "http://json-schema.org/draft-07/schema#"},
      {"title", model.title},
      {"type", "object"},
      {"properties",
       {{"model_id", runs.size() == 1 ? "matrigrate_" + runs.front().name : "matrigrate"},
        {"model_name", model.title},
        {"simulator", "Matrigrate"},
        {"simulator_version", model.version},
        {"description", "Migration of single cells through a degradable viscoelastic matrix after Heck et al. 2020, "
                        "https://doi.org/10.1371/journal.pcbi.1007250"},
        {"input_files", Json::array({"scenario.resolved.toml"})},
        {"output_files", Json::array({"openvt.csv"})},
        {"units", {{"time", "s"}, {"x", "um"}, {"y", "um"}}},
        {"cell_types", {{"0", "migrating cell"}}},
        {"parameters", settings_of(model.base)},
        {"simulations", simulations(runs)},
        {"last_updated", model.updated}}},
      {"required",
       {"model_id", "model_name", "simulator", "description", "input_files", "output_files", "parameters"}}};
  return record.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string openvt_simulator(const std::string& version) {
  const Json record{
      {"name", "Matrigrate"},
      {"version", version},
      {"category", "Virtual Tissue"},
      {"sub_category", "Single-cell migration: deformable cell in smoothed particle hydrodynamics"},
      {"description",
       "A simulator of single-cell migration through a degradable viscoelastic extracellular matrix, in the plane. It "
       "implements the model of Heck et al. 2020, https://doi.org/10.1371/journal.pcbi.1007250"},
      {"platform", "Linux"},
      {"input_formats", {"TOML", "CSV", "PNG", "TIFF"}},
      {"output_formats", {"CSV", "JSON", "HDF5", "XDMF", "OME-TIFF", "Simularium", "TrackMate XML", "SVG"}},
      {"developer", "The Matrigrate authors"},
      {"license", "BSD-3-Clause"},
      {"objects",
       {{{"object_id", "obj_001"},
         {"name", "Cell"},
         {"attributes", {"position", "area", "perimeter", "polarization", "protrusions", "nucleus"}},
         {"processes", {"proc_001", "proc_002", "proc_003", "proc_004"}}},
        {{"object_id", "obj_002"},
         {"name", "ExtracellularMatrix"},
         {"attributes", {"displacement", "stress", "youngs_modulus", "viscosity", "degradation", "ligand", "fibres"}},
         {"processes", {"proc_004", "proc_005"}},
         {"boundary_conditions", Json::array({"clamped rim"})}},
        {{"object_id", "obj_003"},
         {"name", "ChemicalField"},
         {"attributes", {"concentration", "diffusion_coefficient", "decay_rate"}},
         {"processes", Json::array({"proc_006"})}}}},
      {"processes",
       {process("proc_001", "CellMigration", "Protrusion, adhesion, contraction and polarization of a cell."),
        process("proc_002", "ForceDependentAdhesion", "Maturation and disassembly of adhesions under force."),
        process("proc_003", "Chemotaxis", "Initiation of protrusions biased by attractant, ligand or fibres."),
        process("proc_004", "MatrixDegradation", "Degradation of the matrix near a cell."),
        process("proc_005", "MatrixMechanics", "Viscoelastic deformation of the matrix, with fibres."),
        process("proc_006", "ChemicalDiffusion", "Diffusion, release, decay and uptake of attractant.")}},
      {"boundaries", {{"spatial", "disc with a clamped rim"}, {"temporal", "fixed duration"}}},
      {"containment", Json::array({{{"outer_object_id", "obj_002"}, {"inner_object_id", "obj_001"}}})}};
  return record.dump(2) + "\n";
}

} // namespace matrigrate::exchange
