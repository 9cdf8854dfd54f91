#include "store/checkpoint.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "state/dof.hpp"
#include "state/members.hpp"
#include "store/hdf5.hpp"
#include "tables/state_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <xxhash.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <variant>
#include <vector>

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

std::string first_line(std::string_view content) {
  std::string line = fmt::format("{}{} bytes {} xxh128 {}\n", checkpoint_magic, checkpoint_version, content.size(),
                                 fingerprint(content));
  line.resize(block, '\0');
  return line;
}

/// @throws InputOutputError if a file that starts so is no checkpoint that can be read
void require_readable(std::string_view start, const std::string& name) {
  int version = 0;
  const char* const end = start.data() + start.size();
  const bool ours = start.starts_with(checkpoint_magic);
  if (!ours || std::from_chars(start.data() + checkpoint_magic.size(), end, version).ec != std::errc())
    throw InputOutputError(fmt::format("{}: is no checkpoint of matrigrate", name));
  if (version != checkpoint_version)
    throw InputOutputError(fmt::format("{}: is a checkpoint of format {}; this program reads format {}: resume with "
                                       "the version that wrote it, or start the run again from its scenario",
                                       name, version, checkpoint_version));
}

/// How a checkpoint begins that has so many bytes behind its first line.
std::string promise_of(std::uintmax_t bytes) {
  return fmt::format("{}{} bytes {} ", checkpoint_magic, checkpoint_version, bytes);
}

/// The HDF5 file behind a user block that promises it. @throws InputOutputError with the reason
std::string_view checked_content(std::string_view image, const std::string& name) {
  const auto refuse = [&name](std::string_view why) { throw InputOutputError(fmt::format("{}: {}", name, why)); };
  require_readable(image, name);
  if (image.size() < block) refuse("is cut short");
  const std::string_view content = image.substr(block);
  if (image.substr(0, block) == first_line(content)) return content;
  refuse(image.starts_with(promise_of(content.size())) ? "has been changed: its fingerprint does not match"
                                                       : other_length);
  return {};
}

/// Writes a state: its arrays into the file, all else as JSON of the same structure. Arrays without entries are left
/// out.
struct StateWriter {
  MemoryFile& file;

  template <class T>
  Json operator()(const T& s, const std::string& path) const {
    if constexpr (!Listed<T>) {
      return s;
    } else {
      Json json = Json::object();
      each_member(s, [&](const StateMember& member, const auto& value) {
        const std::string at = path + "/" + member.name;
        if constexpr (!Array<std::remove_cvref_t<decltype(value)>>)
          json[member.name] = (*this)(value, at);
        else if (!value.empty())
          file.write(at, value, member.unit);
      });
      return json;
    }
  }
  template <Listed T>
  Json operator()(const std::vector<T>& list, const std::string& path) const {
    Json json = Json::array();
    for (const T& one : list) json.push_back((*this)(one, fmt::format("{}/{}", path, json.size())));
    return json;
  }
  Json operator()(const Phase& phase, const std::string& path) const {
    Json json{{"name", name(phase)}};
    json.update(std::visit([&](const auto& one) { return (*this)(one, path); }, phase));
    return json;
  }
  Json operator()(const std::optional<double>& value, const std::string&) const {
    return value ? Json(*value) : Json();
  }
  Json operator()(const Vec2& x, const std::string&) const { return to_json(x); }
  Json operator()(EndCause cause, const std::string&) const { return name(cause); }
};

/// Reads what StateWriter has written.
struct StateReader {
  const MemoryFile* file; ///< none: the arrays stay empty

  template <class T>
  void operator()(T& s, const Json& json, const std::string& path) const {
    if constexpr (std::is_floating_point_v<T>)
      s = number(json);
    else if constexpr (std::is_integral_v<T>)
      s = integer<T>(json);
    else
      each_member(s, [&](const StateMember& member, auto& value) {
        const std::string at = path + "/" + member.name;
        if constexpr (!Array<std::remove_reference_t<decltype(value)>>)
          (*this)(value, json.at(member.name), at);
        else if (file != nullptr && file->has(at))
          value = file->array<typename std::remove_reference_t<decltype(value)>::value_type>(at);
      });
  }
  template <Listed T>
  void operator()(std::vector<T>& list, const Json& json, const std::string& path) const {
    for (const Json& one : json) {
      const std::string at = fmt::format("{}/{}", path, list.size());
      (*this)(list.emplace_back(), one, at);
    }
  }
  void operator()(Phase& phase, const Json& json, const std::string& path) const {
    const std::string word = json.at("name");
    for (const Phase& kind : {Phase(Growing()), Phase(Maturing()), Phase(Contracting()), Phase(Finishing())})
      if (word == name(kind)) {
        phase = kind;
        std::visit([&](auto& one) { (*this)(one, json, path); }, phase);
        return;
      }
    throw std::invalid_argument("there is no phase \"" + word + "\"");
  }
  void operator()(std::optional<double>& value, const Json& json, const std::string&) const {
    if (!json.is_null()) value = json.get<double>();
  }
  void operator()(Vec2& x, const Json& json, const std::string&) const { x = vector(json); }
  void operator()(EndCause& cause, const Json& json, const std::string&) const {
    const std::string word = json;
    for (const EndCause known :
         {EndCause::none, EndCause::unadhered, EndCause::disassembly, EndCause::rupture, EndCause::lost})
      if (word == name(known)) {
        cause = known;
        return;
      }
    throw std::invalid_argument("an adhesion does not end by \"" + word + "\"");
  }
};

State state_from(const std::string& text, const MemoryFile* file) {
  require_shallow(text);
  return understood("the state", [&] {
    State s;
    StateReader{file}(s, Json::parse(text), "");
    return s;
  });
}

/// True if each array has n entries, or is empty where an empty array is allowed.
bool has_entries(const Listed auto& s, std::size_t n) {
  bool all = true;
  each_member(s, [&](const StateMember& member, const auto& value) {
    if constexpr (Array<std::remove_cvref_t<decltype(value)>>)
      all = all && (value.size() == n || (member.may_be_empty && value.empty()));
  });
  return all;
}

/// Refuses faults that a whole file may still have: arrays that do not match, values out of range.
void require_consistent(const State& s) {
  const std::size_t n = s.ecm.size();
  const SolverMemory& memory = s.solver_memory;
  const bool knows_before = memory.v_before.empty() || memory.v_before.size() == node_count(s);
  const bool lags = memory.x_drag.empty() || memory.x_drag.size() == n;
  const bool cells = std::ranges::all_of(s.cells, [](const Cell& cell) {
    return cell.cortex.size() > 0 && has_entries(cell.cortex, cell.cortex.size())
           && has_entries(cell.nucleus, cell.nucleus.size());
  });
  if (n == 0 || !has_entries(s.ecm, n) || !lags || !cells || !knows_before)
    throw InputOutputError("its arrays do not match in length");
  for (const Cell& cell : s.cells)
    for (const Protrusion& p : cell.protrusions)
      if (p.centre >= cell.cortex.size()) throw InputOutputError("the centre of a protrusion is not on the cortex");
  for (const MatrixField& field : matrix_field_table)
    if (!std::ranges::all_of(s.ecm.*field.member, [&](double a) { return std::isfinite(a) && field.allowed(a); }))
      throw InputOutputError(fmt::format("{} of its matrix is out of range", field.name));
  if (!std::isfinite(s.ecm.V0) || !std::isfinite(s.ecm.period_x))
    throw InputOutputError("the area or the period of its matrix is not a number");
  if (!(std::isfinite(s.t) && s.t >= 0.0)) throw InputOutputError("its time is negative or not finite");
}

/// The bytes of a file of the promised length.
std::string image_of(const std::filesystem::path& file) {
  const std::string start = read_start(file, block); // before all of a large file is read
  require_readable(start, file.string());
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size >= block && !start.starts_with(promise_of(size - block)))
    throw InputOutputError(fmt::format("{}: {}", file.string(), other_length));
  return read_file(file, max_checkpoint_bytes);
}

} // namespace

std::string checkpoint_image(const Checkpoint& checkpoint) {
  MemoryFile file;
  const Json numbers = StateWriter{file}(checkpoint.state, "");
  file.write_text("/state.json", numbers.dump());
  file.write_text("/scenario.toml", checkpoint.scenario);
  file.write_text("/configuration_hash", checkpoint.configuration_hash);
  file.write_text("/program", checkpoint.program);
  file.write_text("/memory.json", checkpoint.memory);
  const std::string_view content = file.view();
  std::string image = first_line(content);
  image += content;
  return image;
}

State parse_state_parts(const std::string& text) { return state_from(text, nullptr); }

Checkpoint parse_checkpoint(std::string_view image, const std::string& name) {
  const std::string_view content = checked_content(image, name);
  return naming(name, [&] {
    const MemoryFile file(content);
    Checkpoint checkpoint{.state = state_from(file.text("/state.json"), &file),
                          .scenario = file.text("/scenario.toml"),
                          .configuration_hash = file.text("/configuration_hash"),
                          .program = file.text("/program"),
                          .memory = file.text("/memory.json")};
    require_consistent(checkpoint.state);
    return checkpoint;
  });
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
  return parse_checkpoint(image_of(file), file.string());
}

std::string read_checkpoint_memory(const std::filesystem::path& file) {
  const std::string image = image_of(file);
  const std::string_view content = checked_content(image, file.string());
  return naming(file, [&] { return MemoryFile(content).text("/memory.json"); });
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
