#include "store/run_memory.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "state/members.hpp"
#include "store/trajectory_hash.hpp"
#include "tables/run_files.hpp"
#include "tables/state_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <stdexcept>
#include <tuple>
#include <type_traits>

namespace matrigrate::store {

namespace {

// The members of each struct, in the order of their values in JSON.
auto parts(Like<StepHealth> auto& s) {
  return std::tie(s.solve.iterations, s.solve.residual, s.solve.converged, s.density_bounds, s.orphans, s.torn,
                  s.engulfed, s.list_builds);
}
auto parts(Like<HealthWatch> auto& s) { return std::tie(s.max_iterations, s.largest_residual); }

/// What is not defined is null.
struct Writer {
  template <class T>
  Json operator()(const T& value) const {
    if constexpr (std::is_arithmetic_v<T>)
      return value;
    else
      return std::apply([this](const auto&... part) { return Json::array({(*this)(part)...}); }, parts(value));
  }
  Json operator()(const std::vector<double>& all) const { return all; }
};

/// Reads what Writer has written.
struct Reader {
  template <class T>
  void operator()(const Json& json, T& value) const {
    if constexpr (std::is_same_v<T, bool>)
      value = json.get<bool>();
    else if constexpr (std::is_floating_point_v<T>)
      value = number(json);
    else if constexpr (std::is_integral_v<T>)
      value = integer<T>(json);
    else
      std::apply([&, k = std::size_t{0}](auto&... part) mutable { ((*this)(json.at(k++), part), ...); }, parts(value));
  }
  void operator()(const Json& json, std::vector<double>& all) const {
    for (const Json& one : json) all.push_back(number(one));
  }
};

/// Visits what is kept, but for the tables. Earlier versions kept drawings as well, which nobody reads.
void each_part(Like<RunMemory> auto& memory, const auto& visit) {
  visit("watch", memory.watch);
  visit("counts", memory.counts);
  visit("step", memory.step);
  visit("force_imbalance", memory.force_imbalance);
  visit("frames", memory.frames);
  visit("trajectory", memory.trajectory);
  visit("march_wall_time_s", memory.march_wall_time);
}

constexpr std::size_t max_table = std::size_t{1} << 28U;

/// The beginning of a table, as long as it was at a checkpoint.
std::string table_at(const std::filesystem::path& file, std::size_t bytes, const std::string& hash) {
  std::string text = read_start(file, bytes);
  if (text.size() < bytes)
    throw InputOutputError(fmt::format("{}: has been cut: {} bytes are left of the {} at the checkpoint", file.string(),
                                       text.size(), bytes));
  if (text_hash(text) != hash)
    throw InputOutputError(fmt::format("{}: has been changed since the checkpoint was written", file.string()));
  return text;
}

} // namespace

std::string to_text(const RunMemory& memory) {
  Json json;
  for (const auto& [name, text] : memory.tables) json["tables"][name] = {text.size(), text_hash(text)};
  each_part(memory, [&json](const char* name, const auto& part) { json[name] = Writer()(part); });
  return json.dump();
}

void require_whole_tables(const std::string& text, const std::filesystem::path& folder) {
  constexpr std::string_view key = "\"tables\":{";
  const std::size_t start = text.find(key);
  const std::size_t end = text.find('}', start);
  if (start == std::string::npos || end == std::string::npos)
    throw InputOutputError("what the run has written so far cannot be read");
  const std::size_t open = start + key.size() - 1;
  const Json tables = parse_json(text.substr(open, end + 1 - open));
  if (!tables.is_object()) throw InputOutputError("what the run has written so far cannot be read");
  try {
    for (const auto& [name, mark] : tables.items()) {
      const std::filesystem::path file = folder / name;
      table_at(file, integer<std::size_t>(mark.at(0)), mark.at(1));
      if (const std::string all = read_file(file, max_table); !all.empty() && all.back() != '\n')
        throw InputOutputError(fmt::format("{}: has been cut within its last line", file.string()));
    }
  } catch (const Json::exception& error) {
    throw InputOutputError(fmt::format("what the run has written so far cannot be read: {}", error.what()));
  }
}

RunMemory parse_memory(const std::string& text, const std::filesystem::path& folder) {
  try {
    require_shallow(text);
    const Json json = Json::parse(text);
    RunMemory memory;
    each_part(memory, [&json](const char* name, auto& part) { Reader()(json.at(name), part); });
    for (const char* name : {"tracks.csv", "health.csv"}) // those of each run
      if (!json.at("tables").contains(name)) throw std::invalid_argument(fmt::format("{} is not named", name));
    for (const auto& [name, mark] : json.at("tables").items())
      memory.tables[name] = table_at(folder / name, integer<std::size_t>(mark.at(0)), mark.at(1));
    memory.rows = naming(folder / "tracks.csv", [&] { return track_rows_of(memory.tables.at("tracks.csv")); });
    if (const auto group = memory.tables.find("group.csv"); group != memory.tables.end())
      memory.group = naming(folder / "group.csv", [&] { return group_rows_of(group->second); });
    return memory;
  } catch (const Json::exception& error) {
    throw InputOutputError(fmt::format("what the run has written so far cannot be read: {}", error.what()));
  } catch (const std::invalid_argument& error) {
    throw InputOutputError(fmt::format("what the run has written so far cannot be read: {}", error.what()));
  }
}

} // namespace matrigrate::store
