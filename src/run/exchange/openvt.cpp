#include "exchange/openvt.hpp"

#include "parameters/changes.hpp"
#include "tables/table.hpp"

#include <nlohmann/json.hpp>

namespace matrigrate::exchange {

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
