#include "apps/stopped_run.hpp"

#include "apps/provenance.hpp"
#include "apps/terminal.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "io/cell_picture.hpp"
#include "parameters/read.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <exception>
#include <optional>
#include <utility>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::size_t most_text = std::size_t{64} << 20U; // of run.json

} // namespace

Json record_of(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_regular_file(folder / "run.json", error)) return {};
  const Json json = Json::parse(read_file(folder / "run.json", most_text), nullptr, false);
  return json.is_object() ? json : Json();
}

std::string text_of(const Json& record, const char* key) {
  const bool there = record.is_object() && record.contains(key) && record.at(key).is_string();
  return there ? record.at(key).get<std::string>() : std::string();
}

std::vector<Json> lineage_of(const Json& record) {
  if (!record.is_object() || !record.contains("lineage") || !record.at("lineage").is_array()) return {};
  return record.at("lineage").get<std::vector<Json>>();
}

std::string time_now() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

FoundCheckpoint read_checkpoint_of(const fs::path& folder, const fs::path& file) {
  FoundCheckpoint found{.checkpoint = io::read_checkpoint(file), .p = {}, .file = file};
  found.p = parse_parameters(found.checkpoint.scenario, file.string());
  const fs::path scenario = folder / "scenario.resolved.toml";
  if (configuration_hash(read_parameters(scenario)) != configuration_hash(found.p))
    throw InputOutputError(
        fmt::format("{}: is a checkpoint of another scenario than {}", file.string(), scenario.string()));
  return found;
}

FoundCheckpoint last_checkpoint(const fs::path& folder, bool previous) {
  const fs::path last = folder / io::checkpoint_name;
  const fs::path before = folder / io::previous_checkpoint_name;
  std::error_code error;
  if (!fs::exists(folder, error)) throw InputOutputError(fmt::format("{}: there is no such folder", folder.string()));
  if (previous || (!fs::exists(last, error) && fs::exists(before, error))) return read_checkpoint_of(folder, before);
  if (!fs::exists(last, error))
    throw InputOutputError(fmt::format("{}: holds no checkpoint to go on from", folder.string()));
  try {
    return read_checkpoint_of(folder, last);
  } catch (const InputOutputError& trouble) {
    std::string offer = "there is no other one";
    try {
      const FoundCheckpoint found = read_checkpoint_of(folder, before);
      offer = fmt::format("the one before, at {}, is whole: go on from it with --previous",
                          io::time_text(found.checkpoint.state.t));
    } catch (const InputOutputError&) { // neither is
    }
    throw InputOutputError(fmt::format("{}; {}", trouble.what(), offer));
  }
}

FoundCheckpoint whole_checkpoint(const fs::path& folder) {
  try {
    return last_checkpoint(folder, false);
  } catch (const InputOutputError& trouble) {
    std::optional<FoundCheckpoint> before;
    try {
      before = last_checkpoint(folder, true);
    } catch (const InputOutputError&) { // then the trouble with the last one is the one to tell
    }
    if (!before) throw;
    print_error(fmt::format("{} {}\n", coloured("matrigrate:", Colour::warning, Stream::err), trouble.what()));
    return *std::move(before);
  }
}

bool has_checkpoint(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / io::checkpoint_name, error) || fs::exists(folder / io::previous_checkpoint_name, error);
}

bool has_only_broken_checkpoints(const fs::path& folder) {
  const auto whole = [&](std::string_view name) {
    try {
      read_checkpoint_of(folder, folder / name);
      return true;
    } catch (const std::exception&) { // whatever is wrong with it
      return false;
    }
  };
  return has_checkpoint(folder) && !whole(io::checkpoint_name) && !whole(io::previous_checkpoint_name);
}

Beginning beginning_of(const FoundCheckpoint& found, const Json& record) {
  Beginning beginning{.s = found.checkpoint.state,
                      .p = found.p,
                      .memory = io::parse_memory(found.checkpoint.memory),
                      .before = {},
                      .lineage = lineage_of(record)};
  if (record.is_object() && record.contains("wall_time_s") && record.at("wall_time_s").is_number())
    beginning.earlier_wall_time = record.at("wall_time_s");
  return beginning;
}

Json event(std::string_view kind, const FoundCheckpoint& found) {
  return {{"event", kind},
          {"checkpoint", found.file.string()},
          {"step", found.checkpoint.state.step},
          {"t_s", found.checkpoint.state.t},
          {"written_by", found.checkpoint.program},
          {"by", version_line()},
          {"when", time_now()}};
}

void tell_other_program(const FoundCheckpoint& found) {
  if (found.checkpoint.program == version_line()) return;
  print_error(fmt::format("{} {} was written by {}, this is {}: the bits may differ from here on\n",
                          coloured("matrigrate:", Colour::warning, Stream::err), found.file.string(),
                          found.checkpoint.program, version_line()));
}

} // namespace matrigrate::apps
