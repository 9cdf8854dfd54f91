#include "store/checkpoint.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "store/hdf5.hpp"
#include "store/state_json.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace matrigrate::io {

namespace {

constexpr std::size_t block = 512; // HDF5 looks for its beginning at 0, 512, 1024, ...
constexpr std::string_view magic = "matrigrate checkpoint ";
constexpr std::size_t most_bytes = std::size_t{4} << 30U;

std::string fingerprint(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string first_line(std::string_view content) {
  std::string line =
      fmt::format("{}{} bytes {} xxh128 {}\n", magic, checkpoint_version, content.size(), fingerprint(content));
  line.resize(block, '\0');
  return line;
}

/// The HDF5 file behind a user block that promises it. @throws InputOutputError with the reason
std::string_view checked_content(std::string_view image, const std::string& name) {
  const auto refuse = [&name](std::string_view why) { throw InputOutputError(fmt::format("{}: {}", name, why)); };
  if (!image.starts_with(magic)) refuse("is no checkpoint of matrigrate");
  int version = 0;
  const char* const end = image.data() + image.size();
  const auto read = std::from_chars(image.data() + magic.size(), end, version);
  if (read.ec != std::errc()) refuse("is no checkpoint of matrigrate");
  if (version != checkpoint_version)
    refuse(fmt::format("is a checkpoint of format {}; this program reads format {}", version, checkpoint_version));
  if (image.size() < block) refuse("is cut short");
  const std::string_view content = image.substr(block);
  if (image.substr(0, block) == first_line(content)) return content;
  const std::string promised = fmt::format("{}{} bytes {} ", magic, checkpoint_version, content.size());
  refuse(image.starts_with(promised) ? "has been changed: its fingerprint is another"
                                     : "is cut short, or its first line has been changed");
  return {};
}

Json small_parts(const State& s) {
  Json protrusions = Json::array();
  for (const Protrusion& p : s.protrusions) protrusions.push_back(to_json(p));
  Json ended = Json::array();
  for (const ProtrusionRecord& r : s.ended) ended.push_back(to_json(r));
  return {{"step", s.step},
          {"t_s", s.t},
          {"V0_um2", s.ecm.V0},
          {"period_x_um", s.ecm.period_x},
          {"polarization_rad", s.polarization ? Json(*s.polarization) : Json()},
          {"initiated", s.initiated},
          {"protrusions", std::move(protrusions)},
          {"ended", std::move(ended)}};
}

State small_parts_of(const Json& json) {
  State s;
  s.step = integer<std::uint64_t>(json.at("step"));
  s.t = json.at("t_s");
  s.ecm.V0 = json.at("V0_um2");
  s.ecm.period_x = json.at("period_x_um");
  if (!json.at("polarization_rad").is_null()) s.polarization = json.at("polarization_rad").get<double>();
  s.initiated = integer<std::uint32_t>(json.at("initiated"));
  for (const Json& p : json.at("protrusions")) s.protrusions.push_back(protrusion_of(p));
  for (const Json& r : json.at("ended")) s.ended.push_back(record_of(r));
  return s;
}

/// What a whole file may still have wrong: arrays that do not belong together.
void require_consistent(const State& s) {
  const std::size_t n = s.ecm.size();
  const SolverMemory& memory = s.solver_memory;
  const bool knows_before = memory.v_before.empty() || memory.v_before.size() == n + s.cortex.size();
  const bool lags = memory.x_drag.empty() || memory.x_drag.size() == n;
  const bool matrix = lags && knows_before && s.ecm.x.size() == n && s.ecm.v.size() == n && s.ecm.rho.size() == n
                      && s.ecm.S.size() == n && s.ecm.f.size() == n && s.ecm.clamped.size() == n;
  const bool cortex = s.cortex.v.size() == s.cortex.size() && s.cortex.l0.size() == s.cortex.size();
  if (!matrix || !cortex || n == 0) throw std::invalid_argument("its arrays do not belong together");
  for (const Protrusion& p : s.protrusions)
    if (p.centre >= s.cortex.size()) throw std::invalid_argument("a protrusion has no place on the cortex");
  if (!(std::isfinite(s.t) && s.t >= 0.0)) throw std::invalid_argument("its time is no time");
}

} // namespace

std::string checkpoint_image(const Checkpoint& checkpoint) {
  const State& s = checkpoint.state;
  MemoryFile file;
  file.write("/ecm/X", s.ecm.X, "um");
  file.write("/ecm/x", s.ecm.x, "um");
  file.write("/ecm/x_drag", s.solver_memory.x_drag, "um");
  file.write("/ecm/v", s.ecm.v, "um/s");
  file.write("/ecm/rho", s.ecm.rho, "1");
  file.write("/ecm/S", s.ecm.S, "kPa");
  file.write("/ecm/f", s.ecm.f, "1");
  file.write("/ecm/clamped", s.ecm.clamped);
  file.write("/v_before", s.solver_memory.v_before, "um/s");
  file.write("/cortex/x", s.cortex.x, "um");
  file.write("/cortex/v", s.cortex.v, "um/s");
  file.write("/cortex/l0", s.cortex.l0, "um");
  file.write_text("/state.json", small_parts(s).dump());
  file.write_text("/scenario.toml", checkpoint.scenario);
  file.write_text("/configuration_hash", checkpoint.configuration_hash);
  file.write_text("/program", checkpoint.program);
  file.write_text("/memory.json", checkpoint.memory);
  const std::string_view content = file.view();
  std::string image = first_line(content);
  image += content;
  return image;
}

State parse_state_parts(const std::string& text) {
  try {
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
    s.solver_memory.v_before = file.vectors("/v_before");
    s.cortex.x = file.vectors("/cortex/x");
    s.cortex.v = file.vectors("/cortex/v");
    s.cortex.l0 = file.doubles("/cortex/l0");
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
  return parse_checkpoint(read_file(file, most_bytes), file.string());
}

void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint) {
  const std::filesystem::path file = folder / checkpoint_name;
  const std::filesystem::path next = folder / "checkpoint_next.h5";
  write_file(next, checkpoint_image(checkpoint));
  std::error_code error;
  if (std::filesystem::exists(file, error)) rename_file(file, folder / previous_checkpoint_name);
  rename_file(next, file);
}

} // namespace matrigrate::io
