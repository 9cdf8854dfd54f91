#include "store/checkpoint.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "state/dof.hpp"
#include "store/hdf5.hpp"
#include "store/state_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <xxhash.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace matrigrate::store {

namespace {

constexpr std::size_t block = 512; // HDF5 looks for its beginning at 0, 512, 1024, ...
constexpr std::string_view checkpoint_magic = "matrigrate checkpoint ";
constexpr const char* other_length = "is cut short, or its first line has been changed";
constexpr std::size_t max_checkpoint_bytes = std::size_t{4} << 30U;

std::string fingerprint(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string first_line(int version, std::string_view content) {
  std::string line =
      fmt::format("{}{} bytes {} xxh128 {}\n", checkpoint_magic, version, content.size(), fingerprint(content));
  line.resize(block, '\0');
  return line;
}

/// The format of a checkpoint by its first bytes. @throws InputOutputError if it is none that can be read
int version_in(std::string_view start, const std::string& name) {
  int version = 0;
  const char* const end = start.data() + start.size();
  const bool ours = start.starts_with(checkpoint_magic);
  if (!ours || std::from_chars(start.data() + checkpoint_magic.size(), end, version).ec != std::errc())
    throw InputOutputError(fmt::format("{}: is no checkpoint of matrigrate", name));
  if (version < one_cell_version || version > checkpoint_version)
    throw InputOutputError(fmt::format("{}: is a checkpoint of format {}; this program reads formats {} to {}", name,
                                       version, one_cell_version, checkpoint_version));
  return version;
}

/// How a checkpoint begins that has so many bytes behind its first line.
std::string promise_of(int version, std::uintmax_t bytes) {
  return fmt::format("{}{} bytes {} ", checkpoint_magic, version, bytes);
}

/// The HDF5 file behind a user block that promises it. @throws InputOutputError with the reason
std::string_view checked_content(std::string_view image, const std::string& name) {
  const auto refuse = [&name](std::string_view why) { throw InputOutputError(fmt::format("{}: {}", name, why)); };
  const int version = version_in(image, name);
  if (image.size() < block) refuse("is cut short");
  const std::string_view content = image.substr(block);
  if (image.substr(0, block) == first_line(version, content)) return content;
  refuse(image.starts_with(promise_of(version, content.size())) ? "has been changed: its fingerprint is another"
                                                                : other_length);
  return {};
}

/// All of a cell but its arrays and its number.
Json small_parts(const Cell& cell) {
  Json protrusions = Json::array();
  for (const Protrusion& p : cell.protrusions) protrusions.push_back(to_json(p));
  Json ended = Json::array();
  for (const ProtrusionRecord& r : cell.ended) ended.push_back(to_json(r));
  return {{"polarization_rad", cell.polarization ? Json(*cell.polarization) : Json()},
          {"initiated", cell.initiated},
          {"protrusions", std::move(protrusions)},
          {"ended", std::move(ended)}};
}

Cell small_parts_of_cell(const Json& json) {
  Cell cell;
  if (!json.at("polarization_rad").is_null()) cell.polarization = json.at("polarization_rad").get<double>();
  cell.initiated = integer<std::uint32_t>(json.at("initiated"));
  for (const Json& p : json.at("protrusions")) cell.protrusions.push_back(protrusion_of(p));
  for (const Json& r : json.at("ended")) cell.ended.push_back(record_of(r));
  return cell;
}

/// The oldest format that can hold a state.
int version_of(const State& s) {
  const bool one = s.cells.empty() || (s.cells.size() == 1 && s.cells.front().id == 0);
  const EcmState& m = s.ecm;
  const bool uniform = m.E_ratio.empty() && m.fibre_direction.empty() && m.fibre_ratio.empty() && m.obstacle.empty()
                       && m.ligand.empty() && m.attractant.empty();
  const bool nuclei = std::ranges::any_of(s.cells, [](const Cell& cell) { return cell.nucleus.size() > 0; });
  if (nuclei) return checkpoint_version;
  return one && uniform ? one_cell_version : cells_version;
}

/// Without a cell: as if of one without particles.
Json small_parts(const State& s) {
  Json json{{"step", s.step}, {"t_s", s.t}, {"V0_um2", s.ecm.V0}, {"period_x_um", s.ecm.period_x}};
  if (version_of(s) == one_cell_version) {
    json.update(small_parts(s.cells.empty() ? Cell{} : s.cells.front()));
    return json;
  }
  Json cells = Json::array();
  for (const Cell& cell : s.cells) {
    Json parts{{"id", cell.id}};
    parts.update(small_parts(cell));
    cells.push_back(std::move(parts));
  }
  json["cells"] = std::move(cells);
  return json;
}

State small_parts_of(const Json& json) {
  State s;
  s.step = integer<std::uint64_t>(json.at("step"));
  s.t = json.at("t_s");
  s.ecm.V0 = json.at("V0_um2");
  s.ecm.period_x = json.at("period_x_um");
  if (!json.contains("cells")) {
    s.cells.push_back(small_parts_of_cell(json));
    return s;
  }
  for (const Json& parts : json.at("cells")) {
    s.cells.push_back(small_parts_of_cell(parts));
    s.cells.back().id = integer<std::uint32_t>(parts.at("id"));
  }
  return s;
}

/// Where the arrays of a cell are.
std::string cell_path(int version, std::size_t k) {
  return version == one_cell_version ? "/cortex/" : fmt::format("/cells/{}/", k);
}

void write_ring(MemoryFile& file, const CortexState& c, const std::string& path) {
  file.write(path + "x", c.x, "um");
  file.write(path + "v", c.v, "um/s");
  file.write(path + "l0", c.l0, "um");
}

CortexState read_ring(const MemoryFile& file, const std::string& path) {
  return {.x = file.vectors(path + "x"), .v = file.vectors(path + "v"), .l0 = file.doubles(path + "l0")};
}

void write_arrays(MemoryFile& file, const Cell& cell, int version, std::size_t k) {
  write_ring(file, cell.cortex, cell_path(version, k));
  if (cell.nucleus.size() > 0) write_ring(file, cell.nucleus, cell_path(version, k) + "nucleus/");
}

void read_arrays(const MemoryFile& file, Cell& cell, int version, std::size_t k) {
  const std::string path = cell_path(version, k);
  cell.cortex = read_ring(file, path);
  if (file.has(path + "nucleus/x")) cell.nucleus = read_ring(file, path + "nucleus/");
}

/// Whether this is the cell without particles that stands for none.
bool is_empty(const std::vector<Cell>& cells) {
  return cells.size() == 1 && cells.front().cortex.size() == 0 && cells.front().protrusions.empty();
}

/// What a whole file may still have wrong: arrays that do not belong together.
void require_consistent(const State& s) {
  const std::size_t n = s.ecm.size();
  const SolverMemory& memory = s.solver_memory;
  const bool knows_before = memory.v_before.empty() || memory.v_before.size() == node_count(s);
  const bool lags = memory.x_drag.empty() || memory.x_drag.size() == n;
  const auto one_each = [n](const auto& field) { return field.empty() || field.size() == n; };
  const bool matrix = one_each(s.ecm.E_ratio) && one_each(s.ecm.fibre_direction) && one_each(s.ecm.fibre_ratio)
                      && one_each(s.ecm.obstacle) && one_each(s.ecm.ligand) && one_each(s.ecm.attractant)
                      && one_each(s.ecm.attractant_source) && lags && knows_before && s.ecm.x.size() == n
                      && s.ecm.v.size() == n && s.ecm.rho.size() == n && s.ecm.S.size() == n && s.ecm.f.size() == n
                      && s.ecm.clamped.size() == n;
  const bool cortices = std::ranges::all_of(s.cells, [](const Cell& cell) {
    const auto whole = [](const CortexState& c) { return c.v.size() == c.size() && c.l0.size() == c.size(); };
    return cell.cortex.size() > 0 && whole(cell.cortex) && whole(cell.nucleus);
  });
  if (!matrix || !cortices || n == 0) throw std::invalid_argument("its arrays do not belong together");
  for (const Cell& cell : s.cells)
    for (const Protrusion& p : cell.protrusions)
      if (p.centre >= cell.cortex.size()) throw std::invalid_argument("a protrusion has no place on the cortex");
  if (!std::ranges::all_of(s.ecm.E_ratio, [](double ratio) { return std::isfinite(ratio) && ratio > 0.0; }))
    throw std::invalid_argument("a Young's modulus of the matrix is not above 0");
  if (!(std::isfinite(s.t) && s.t >= 0.0)) throw std::invalid_argument("its time is no time");
}

} // namespace

std::string checkpoint_image(const Checkpoint& checkpoint) {
  const State& s = checkpoint.state;
  const int version = version_of(s);
  MemoryFile file;
  file.write("/ecm/X", s.ecm.X, "um");
  file.write("/ecm/x", s.ecm.x, "um");
  file.write("/ecm/x_drag", s.solver_memory.x_drag, "um");
  file.write("/ecm/v", s.ecm.v, "um/s");
  file.write("/ecm/rho", s.ecm.rho, "1");
  file.write("/ecm/S", s.ecm.S, "kPa");
  file.write("/ecm/f", s.ecm.f, "1");
  file.write("/ecm/clamped", s.ecm.clamped);
  if (!s.ecm.E_ratio.empty()) file.write("/ecm/E_ratio", s.ecm.E_ratio, "1");
  if (!s.ecm.fibre_direction.empty()) file.write("/ecm/fibre_direction", s.ecm.fibre_direction, "rad");
  if (!s.ecm.fibre_ratio.empty()) file.write("/ecm/fibre_ratio", s.ecm.fibre_ratio, "1");
  if (!s.ecm.obstacle.empty()) file.write("/ecm/obstacle", s.ecm.obstacle);
  if (!s.ecm.ligand.empty()) file.write("/ecm/ligand", s.ecm.ligand, "1");
  if (!s.ecm.attractant.empty()) file.write("/ecm/attractant", s.ecm.attractant, "1");
  if (!s.ecm.attractant_source.empty()) file.write("/ecm/attractant_source", s.ecm.attractant_source, "1/s");
  file.write("/v_before", s.solver_memory.v_before, "um/s");
  if (s.cells.empty()) write_arrays(file, {}, version, 0);
  for (std::size_t k = 0; k < s.cells.size(); ++k) write_arrays(file, s.cells[k], version, k);
  file.write_text("/state.json", small_parts(s).dump());
  file.write_text("/scenario.toml", checkpoint.scenario);
  file.write_text("/configuration_hash", checkpoint.configuration_hash);
  file.write_text("/program", checkpoint.program);
  file.write_text("/memory.json", checkpoint.memory);
  const std::string_view content = file.view();
  std::string image = first_line(version, content);
  image += content;
  return image;
}

State parse_state_parts(const std::string& text) {
  try {
    require_shallow(text);
    return small_parts_of(Json::parse(text));
  } catch (const Json::exception& error) {
    throw InputOutputError(fmt::format("the state cannot be read: {}", error.what()));
  } catch (const std::invalid_argument& error) {
    throw InputOutputError(fmt::format("the state cannot be read: {}", error.what()));
  }
}

Checkpoint parse_checkpoint(std::string_view image, const std::string& name) {
  const std::string_view content = checked_content(image, name);
  try {
    const MemoryFile file(content);
    Checkpoint checkpoint;
    State& s = checkpoint.state;
    s = parse_state_parts(file.text("/state.json"));
    s.ecm.X = file.vectors("/ecm/X");
    s.ecm.x = file.vectors("/ecm/x");
    s.solver_memory.x_drag = file.vectors("/ecm/x_drag");
    s.ecm.v = file.vectors("/ecm/v");
    s.ecm.rho = file.doubles("/ecm/rho");
    s.ecm.S = file.matrices("/ecm/S");
    s.ecm.f = file.doubles("/ecm/f");
    s.ecm.clamped = file.bytes("/ecm/clamped");
    if (file.has("/ecm/E_ratio")) s.ecm.E_ratio = file.doubles("/ecm/E_ratio");
    if (file.has("/ecm/fibre_direction")) s.ecm.fibre_direction = file.doubles("/ecm/fibre_direction");
    if (file.has("/ecm/fibre_ratio")) s.ecm.fibre_ratio = file.doubles("/ecm/fibre_ratio");
    if (file.has("/ecm/obstacle")) s.ecm.obstacle = file.bytes("/ecm/obstacle");
    if (file.has("/ecm/ligand")) s.ecm.ligand = file.doubles("/ecm/ligand");
    if (file.has("/ecm/attractant")) s.ecm.attractant = file.doubles("/ecm/attractant");
    if (file.has("/ecm/attractant_source")) s.ecm.attractant_source = file.doubles("/ecm/attractant_source");
    s.solver_memory.v_before = file.vectors("/v_before");
    const int version = file.has("/cortex/x") ? one_cell_version : checkpoint_version;
    for (std::size_t k = 0; k < s.cells.size(); ++k) read_arrays(file, s.cells[k], version, k);
    if (version == one_cell_version && is_empty(s.cells)) s.cells.clear(); // the matrix alone
    require_consistent(s);
    checkpoint.scenario = file.text("/scenario.toml");
    checkpoint.configuration_hash = file.text("/configuration_hash");
    checkpoint.program = file.text("/program");
    checkpoint.memory = file.text("/memory.json");
    return checkpoint;
  } catch (const std::invalid_argument& error) {
    throw InputOutputError(fmt::format("{}: {}", name, error.what()));
  } catch (const InputOutputError& error) {
    throw InputOutputError(fmt::format("{}: {}", name, error.what()));
  }
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
  const std::string start = read_start(file, block); // before all of a large file is read
  const int version = version_in(start, file.string());
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size >= block && !start.starts_with(promise_of(version, size - block)))
    throw InputOutputError(fmt::format("{}: {}", file.string(), other_length));
  return parse_checkpoint(read_file(file, max_checkpoint_bytes), file.string());
}

void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint,
                      const std::optional<std::filesystem::path>& kept) {
  const std::filesystem::path file = folder / checkpoint_name;
  const std::filesystem::path next = folder / "checkpoint_next.h5";
  const std::string image = checkpoint_image(checkpoint);
  if (kept) write_file(*kept, image);
  write_file(next, image);
  std::error_code error;
  if (std::filesystem::exists(file, error)) rename_file(file, folder / previous_checkpoint_name);
  rename_file(next, file);
}

} // namespace matrigrate::store
