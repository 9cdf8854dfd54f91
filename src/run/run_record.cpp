#include "run/run_record.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "parameters/changes.hpp"
#include "parameters/laws/law.hpp"
#include "parameters/schema.hpp"
#include "parameters/version.hpp"
#include "parameters/write.hpp"
#include "run/provenance.hpp"
#include "store/trajectory_hash.hpp"
#include "tables/state_json.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::run {

namespace {

using WallClock = std::chrono::system_clock;
namespace fs = std::filesystem;

/// ISO 8601, UTC: "2026-01-31T12:00:00Z".
std::string utc(WallClock::time_point time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(WallClock::to_time_t(time)));
}

constexpr double Pa = 1e3;                                // in a kPa
constexpr std::size_t max_result = std::size_t{1} << 30U; // bytes of a table

/// The last part of a path that is no dot; the current folder's own name for "".
std::string name_of(const fs::path& folder) {
  std::error_code error;
  fs::path path = fs::absolute(folder.empty() ? fs::path(".") : folder, error).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  return path.filename().string();
}

/// "2026-01-31 12:00 UTC" of "2026-01-31T12:00:00Z".
std::string minute_of(const std::string& time) {
  return time.size() < 16 ? time : fmt::format("{} {} UTC", time.substr(0, 10), time.substr(11, 5));
}

std::vector<std::string> words_of(const Json& list) {
  std::vector<std::string> words;
  if (list.is_array())
    for (const Json& word : list)
      if (word.is_string()) words.push_back(word.get<std::string>());
  return words;
}

/// A value of a record; null where there is none.
Json value_of(const Json& record, const char* key) {
  return record.is_object() && record.contains(key) ? record.at(key) : Json();
}

/// "200 Pa", or the field: "max(50, 200 + 2*x) Pa"
std::string stiffness_text(const Parameters& p) {
  if (!p.ecm.fields.youngs_modulus.empty()) return p.ecm.fields.youngs_modulus + " Pa";
  return fmt::format("{:.6g} Pa", Pa * p.ecm.youngs_modulus);
}

} // namespace

Json record_of(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_regular_file(folder / "run.json", error)) return {};
  const Json json = store::parse_json(read_file(folder / "run.json", max_record));
  return json.is_object() ? json : Json();
}

Json parse_record(std::string_view text) {
  Json record = store::parse_json_object(text);
  const auto require = [&](const char* key, bool right, const char* wanted) {
    if (record.contains(key) && !record.at(key).is_null() && !right)
      throw InputOutputError(fmt::format("{} is of type {}; {} is expected", key, record.at(key).type_name(), wanted));
  };
  for (const char* key : {"status", "reason", "cause", "trajectory_hash", "configuration_hash", "scenario",
                          "scenario_version", "start", "end"})
    require(key, value_of(record, key).is_string(), "a text");
  for (const char* key : {"t_s", "wall_time_s", "steps"}) require(key, value_of(record, key).is_number(), "a number");
  return record;
}

Json read_record(const fs::path& folder) {
  const fs::path file = folder / "run.json";
  const std::string text = read_file(file, max_record);
  return naming(file, [&text] { return parse_record(text); });
}

void RunRecord::note_end() {
  end = WallClock::now();
  steady_end = std::chrono::steady_clock::now();
}

double RunRecord::wall_time() const {
  const auto now = steady_end.value_or(std::chrono::steady_clock::now());
  return earlier_wall_time + std::chrono::duration<double>(now - steady_start).count();
}

std::string text_of(const Json& record, const char* key) {
  const Json value = value_of(record, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}

std::optional<double> number_in(const Json& record, const char* key) {
  const Json value = value_of(record, key);
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

std::string program_of(const Json& record) {
  const std::string version = text_of(record, "version");
  if (version.empty()) return {};
  return fmt::format("matrigrate {} ({}{})", version, text_of(record, "git_hash").substr(0, 8),
                     value_of(record, "git_dirty") == true ? ", changed sources" : "");
}

std::optional<RunStatus> status_of(const Json& record) { return parse_run_status(text_of(record, "status")); }

std::vector<Json> lineage_of(const Json& record) {
  const Json lineage = value_of(record, "lineage");
  return lineage.is_array() ? lineage.get<std::vector<Json>>() : std::vector<Json>();
}

std::vector<std::string> programs_of(const Json& record) {
  std::vector<std::string> programs;
  const auto add = [&](std::string program) {
    if (!program.empty() && std::ranges::find(programs, program) == programs.end())
      programs.push_back(std::move(program));
  };
  for (const Json& one : lineage_of(record)) add(text_of(one, "written_by"));
  add(program_of(record));
  return programs;
}

std::string command_text(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    const std::string shown = text.empty() ? fs::path(word).filename().string() : word;
    const bool plain = !shown.empty() && shown.find_first_of(" \t\"'$`\\!*?[](){}<>|&;#~") == std::string::npos;
    std::string quoted;
    for (const char c : shown) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += (text.empty() ? "" : " ") + (plain ? shown : fmt::format("'{}'", quoted));
  }
  return text;
}

std::string time_now() { return utc(WallClock::now()); }

std::string minute_text(WallClock::time_point time) { return minute_of(utc(time)); }

std::string configuration_hash(const Parameters& p) {
  Parameters q = p;
  q.run.threads = threads_in_texts;
  return store::text_hash(values_text(q));
}

std::map<std::string, std::string> result_fingerprints(const fs::path& folder) {
  std::map<std::string, std::string> all;
  std::error_code error;
  for (const char* name : {"tracks.csv", "protrusions.csv", "group.csv", "msd.csv", "summary.json"})
    if (fs::is_regular_file(folder / name, error)) all[name] = store::text_hash(read_file(folder / name, max_result));
  return all;
}

void require_unchanged(const fs::path& folder, const Json& record) {
  const Json files = value_of(record, "files");
  if (!files.is_object()) return;
  for (const auto& [name, hash] : files.items()) {
    const fs::path file = folder / fs::path(name).filename();
    if (!hash.is_string() || store::text_hash(read_file(file, max_result)) != hash.get<std::string>())
      throw InputOutputError(fmt::format("{}: has been cut or changed since the run ended", file.string()));
  }
}

std::string scenario_name(const Json& record, const fs::path& folder) {
  if (std::string name = text_of(record, "scenario"); !name.empty()) return name;
  for (const fs::path file : words_of(value_of(record, "command_line"))) {
    if (file.extension() != ".toml") continue;
    if (file.filename() != "scenario.resolved.toml") return file.stem().string();
    return name_of(file.parent_path());
  }
  const std::string name = name_of(folder);
  return name.substr(0, name.rfind("-seed"));
}

std::vector<std::vector<std::string>> commands_of(const Json& record) {
  std::vector<std::vector<std::string>> commands;
  if (const Json all = value_of(record, "commands"); all.is_array())
    for (const Json& command : all) commands.push_back(words_of(command));
  if (!commands.empty()) return commands;
  if (std::vector<std::string> words = words_of(value_of(record, "command_line")); !words.empty())
    commands.push_back(std::move(words));
  return commands;
}

store::FieldOrigin field_origin(Parameters p, std::string trajectory_hash) {
  p.run.threads = threads_in_texts;
  return {.program = "matrigrate",
          .version = version_text(),
          .seed = p.run.seed,
          .trajectory_hash = std::move(trajectory_hash),
          .scenario = to_toml(p)};
}

std::string run_title(const Parameters& p, const std::string& scenario) {
  return fmt::format("{}: {}, seed {}", scenario,
                     p.ecm.fields.youngs_modulus.empty() ? "E = " + stiffness_text(p) : "stiffness by a field",
                     p.run.seed);
}

std::string bias_sentence(const Json& record) {
  const auto n = number_in(record, "steps_without_bias"), steps = number_in(record, "steps");
  if (n.value_or(0.0) <= 0.0 || !steps) return {};
  return fmt::format("laws.initiation_bias was 0 along the whole cortex in {:.0f} of {:.0f} steps; protrusions began "
                     "there as without a bias",
                     *n, *steps);
}

std::vector<report::Fact> run_facts(const Parameters& p, const Json& record, const std::string& scenario) {
  std::vector<report::Fact> facts{
      {"scenario", scenario}, {"Young's modulus E", stiffness_text(p)}, {"seed", fmt::format("{}", p.run.seed)}};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) facts.push_back({name, value});
  };
  if (const std::string version = text_of(record, "scenario_version"); !version.empty())
    facts.push_back({"scenario written by", fmt::format("matrigrate {}; {}", version, model_text(version))});
  facts.push_back({"closures", closures_of(p).text});
  for (const auto& [path, value] : p.origin.gone) facts.push_back({path, value + ", a reading that has gone"});
  add("bias of initiation", bias_sentence(record));
  for (const Row* law : changed_laws(p)) {
    const std::string constants = constants_of(*law, p);
    facts.push_back({std::string(law->path), value_text(*law, p) + (constants.empty() ? "" : ", " + constants)});
  }
  for (const ChangeWords& change : words_of_changes(p)) facts.push_back({"from " + change.when, change.what});
  const auto commands = commands_of(record);
  for (std::size_t i = 0; i < commands.size(); ++i) add(i == 0 ? "command" : "branched by", command_text(commands[i]));
  const std::string end = text_of(record, "end");
  add("date", minute_of(end.empty() ? text_of(record, "start") : end));
  if (const auto time = number_in(record, "wall_time_s")) add("wall time", wall_time_text(*time));
  if (value_of(record, "git_dirty") == true) add("program", "built from changed sources");
  add("trajectory hash", text_of(record, "trajectory_hash"));
  return facts;
}

Json laws_json(const Parameters& p) {
  Json laws = Json::object();
  for (const Row* law : changed_laws(p)) laws[std::string(law->path)] = Json::parse(meaning_text(*law, p));
  if (!laws.empty() && !p.laws.constants.empty())
    laws["laws.constants"] = Json::parse(meaning_text(*find_row("laws.constants"), p));
  return laws;
}

Json changes_json(const Parameters& p) {
  Json list = Json::array();
  for (const ChangeWords& change : words_of_changes(p)) list.push_back({{"at_s", change.at}, {"what", change.what}});
  return list;
}

Json to_json(const RunRecord& record, const Parameters& p) {
  const store::LostFrames& lost = record.lost_frames;
  Json json{{"status", to_string(record.status())},
            {"exit_code", record.ended ? Json(exit_code(*record.ended)) : Json()},
            {"reason", record.reason},
            {"cause", record.cause ? Json(to_string(*record.cause)) : Json()},
            {"seed", p.run.seed},
            {"steps", record.steps},
            {"t_s", record.t},
            {"duration_s", p.run.duration},
            {"wall_time_s", record.wall_time()},
            {"ms_per_step",
             record.steps > 0 ? Json(1e3 * record.march_wall_time / static_cast<double>(record.steps)) : Json()},
            {"trajectory_hash", record.trajectory_hash},
            {"configuration_hash", record.configuration_hash},
            {"closures", closures_of(p).text},
            {"scenario_version", p.origin.version.empty() ? Json() : Json(p.origin.version)},
            {"laws", laws_json(p)},
            {"changes", changes_json(p)},
            {"steps_without_bias", record.steps_without_bias},
            {"files", record.files},
            {"frames_lost", lost.count},
            {"frames_lost_s", lost.count > 0 ? Json{lost.first, lost.last} : Json()},
            {"command_line", record.command_line},
            {"scenario", record.scenario},
            {"commands", record.commands},
            {"start", utc(record.start)},
            {"end", record.end ? Json(utc(*record.end)) : Json()},
            {"lineage", record.lineage}};
  json.update(provenance());
  return json;
}

} // namespace matrigrate::run
