#include "store/run_memory.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "store/trajectory_hash.hpp"
#include "tables/run_files.hpp"
#include "tables/state_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <stdexcept>

namespace matrigrate::store {

namespace {

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

constexpr std::string_view so_far = "what the run has written so far";

} // namespace

std::string to_text(const RunMemory& memory) {
  const auto& [solve, density_bounds, orphans, torn, engulfed, list_builds] = memory.counts;
  Json json; // what is not defined is null
  for (const auto& [name, text] : memory.tables) json["tables"][name] = {text.size(), text_hash(text)};
  json["watch"] = {memory.watch.max_iterations, memory.watch.largest_residual};
  json["counts"] = {solve.iterations, solve.residual, solve.converged, density_bounds,
                    orphans,          torn,           engulfed,        list_builds};
  json["step"] = memory.step;
  json["force_imbalance"] = memory.force_imbalance;
  json["frames"] = memory.frames;
  json["trajectory"] = memory.trajectory;
  json["march_wall_time_s"] = memory.march_wall_time;
  return json.dump();
}

void require_whole_tables(const std::string& text, const std::filesystem::path& folder) {
  require_shallow(text);
  understood(so_far, [&] {
    const Json json = Json::parse(text);
    for (const auto& [name, mark] : json.at("tables").items()) {
      const std::filesystem::path file = folder / name;
      table_at(file, integer<std::size_t>(mark.at(0)), mark.at(1));
      if (const std::string all = read_file(file, max_table); !all.empty() && all.back() != '\n')
        throw InputOutputError(fmt::format("{}: has been cut within its last line", file.string()));
    }
  });
}

RunMemory parse_memory(const std::string& text, const std::filesystem::path& folder) {
  require_shallow(text);
  return understood(so_far, [&] {
    const Json json = Json::parse(text); // earlier versions kept drawings as well, which nobody reads
    RunMemory memory;
    const Json &watch = json.at("watch"), &counts = json.at("counts");
    memory.watch = {.max_iterations = integer<int>(watch.at(0)), .largest_residual = number(watch.at(1))};
    memory.counts = {.solve = {.iterations = integer<int>(counts.at(0)),
                               .residual = number(counts.at(1)),
                               .converged = counts.at(2).get<bool>()},
                     .density_bounds = integer<std::size_t>(counts.at(3)),
                     .orphans = integer<std::size_t>(counts.at(4)),
                     .torn = integer<std::size_t>(counts.at(5)),
                     .engulfed = integer<std::size_t>(counts.at(6)),
                     .list_builds = integer<std::size_t>(counts.at(7))};
    memory.step = integer<std::uint64_t>(json.at("step"));
    memory.force_imbalance = number(json.at("force_imbalance"));
    for (const Json& t : json.at("frames")) memory.frames.push_back(number(t));
    memory.trajectory = integer<std::uint64_t>(json.at("trajectory"));
    memory.march_wall_time = number(json.at("march_wall_time_s"));
    for (const char* name : {"tracks.csv", "health.csv"}) // those of each run
      if (!json.at("tables").contains(name)) throw std::invalid_argument(fmt::format("{} is not named", name));
    for (const auto& [name, mark] : json.at("tables").items())
      memory.tables[name] = table_at(folder / name, integer<std::size_t>(mark.at(0)), mark.at(1));
    memory.rows = naming(folder / "tracks.csv", [&] { return track_rows_of(memory.tables.at("tracks.csv")); });
    if (const auto group = memory.tables.find("group.csv"); group != memory.tables.end())
      memory.group = naming(folder / "group.csv", [&] { return group_rows_of(group->second); });
    return memory;
  });
}

} // namespace matrigrate::store
