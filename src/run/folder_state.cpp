#include "run/folder_state.hpp"

#include "base/failure.hpp"
#include "base/text.hpp"
#include "run/difference.hpp"
#include "run/own_files.hpp"
#include "run/resume.hpp"
#include "run/run_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <system_error>

namespace matrigrate::run {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_listed = 20;

template <class... Uses>
constexpr unsigned of(Uses... uses) {
  return (static_cast<unsigned>(uses) | ...);
}

/// A row of the table: what a folder is wanted for, what it holds, and what is then said; nothing if it is taken.
struct Refusal {
  unsigned uses;
  unsigned holds;
  std::string_view sentence;
};

constexpr unsigned writers =
    of(Use::run, Use::run_anew, Use::branch, Use::study, Use::exports, Use::results, Use::pictures);
constexpr unsigned anything = ~0U;
constexpr std::string_view taken{};

/// The first row that is true of a folder decides; without one it is taken.
constexpr Refusal refusals[] = {
    {of(Use::pictures), Holds::a_file, "is no folder; choose another one"},
    {writers, Holds::a_file, "is no folder; choose another one with -o"},
    {writers, Holds::closed, "cannot be read: {detail}"},

    {of(Use::run, Use::run_anew), Holds::a_study,
     "is the folder of a study; choose another folder for the run with -o"},
    {of(Use::run), Holds::this_run, taken},
    {of(Use::run), Holds::a_run,
     "holds another run ({status}):\n{detail}\n-o FOLDER writes the new run somewhere else; matrigrate resume {folder} "
     "{goes_on} that run; --force removes it and starts the new one"},
    {of(Use::run), Holds::checkpoint,
     "holds a run whose run.json is missing or damaged; it can be resumed: matrigrate resume {folder}\n"
     "-o FOLDER writes the new run somewhere else"},
    {of(Use::run), Holds::something,
     "exists and is not empty: it holds {names}; choose another folder with -o, or pass --force: only files of an "
     "older run are removed"},

    {of(Use::branch), Holds::begun_branch, taken},
    {of(Use::branch), Holds::this_branch,
     "exists and is not empty: it holds this branch, which goes on with: matrigrate resume {folder}; choose another "
     "folder with -o"},
    {of(Use::branch), Holds::something, "exists and is not empty; choose another folder with -o"},

    {of(Use::resume), Holds::missing, "there is no such folder"},
    {of(Use::resume), Holds::checkpoint, taken},
    {of(Use::resume), Holds::a_study,
     "is the folder of a study; matrigrate study run {folder}/study.resolved.toml computes what is missing of it"},
    {of(Use::resume), anything, "holds no checkpoint to resume from{begin_again}"},

    {of(Use::study), Holds::run_json | Holds::checkpoint,
     "is the folder of a run, and holds {names}; choose another folder for the study with -o"},
    {of(Use::study), Holds::other_study, "holds another study{detail}\n-o FOLDER computes this study somewhere else"},
    {of(Use::study), Holds::unclear_study,
     "holds a study that cannot be compared: {detail}\n-o FOLDER computes this study somewhere else"},
    {of(Use::study), Holds::a_study, taken},
    {of(Use::study), Holds::something, "holds other files, and no study: {names}; choose another folder with -o"},

    {of(Use::exports), Holds::run_json, "is the folder of a run; export into another one"},
    {of(Use::results), Holds::something,
     "exists and is not empty; choose another folder, or pass --force to write into it"},
    {of(Use::pictures), Holds::something, "exists and is not empty; choose another folder"},

    {of(Use::see_run), Holds::a_study, "is the folder of a study; name one of its runs, {folder}/runs/NAME"},
    {of(Use::see_run), Holds::run_json, taken},
    {of(Use::see_run), anything, "holds no run: it has no run.json"},
    {of(Use::see_study), Holds::a_study, taken},
    {of(Use::see_study), anything, "is no folder of a study: it has no study.resolved.toml"},
    {of(Use::see_either), Holds::a_study | Holds::run_json, taken},
    {of(Use::see_either), anything,
     "is the folder of neither a run (no run.json) nor a study (no study.resolved.toml)"},
    {of(Use::see_files), Holds::missing | Holds::a_file, "is no folder"},
};

/// A sentence of the table with what it names of the folder.
std::string filled(std::string_view sentence, const FolderState& state) {
  const auto time = [&](const char* key) { return time_text(number_in(state.record, key).value_or(0.0)); };
  const auto commands = commands_of(state.record);
  return fmt::format(
      fmt::runtime(sentence), fmt::arg("folder", state.folder.string()), fmt::arg("detail", state.detail),
      fmt::arg("names", listed(state.names, ", ")),
      fmt::arg("status", fmt::format("{}, {} of {}", text_of(state.record, "status"), time("t_s"), time("duration_s"))),
      fmt::arg("goes_on", status_of(state.record) == RunStatus::done ? "--hours H extends" : "continues"),
      fmt::arg("begin_again", commands.empty()
                                  ? std::string()
                                  : "; the command that began it begins it again: " + command_text(commands.back())));
}

/// Notes the entries of a folder, hidden files aside.
void list_entries(FolderState& state) {
  std::error_code error;
  for (fs::directory_iterator it(state.folder, error); !error && it != fs::directory_iterator(); it.increment(error))
    if (std::string name = it->path().filename().string(); !name.starts_with('.'))
      state.names.push_back(std::move(name));
  std::ranges::sort(state.names);
  if (!state.names.empty()) state.holds |= Holds::something;
  if (!error) return;
  state.holds |= Holds::closed;
  state.detail = error.message();
}

/// A value without quotes, "none" of an empty text.
std::string shown(std::string text) {
  std::erase_if(text, [](char c) { return c == '"' || c == '\\'; });
  return text.empty() ? "none" : text;
}

/// "  run.duration: 1 h there, 6 min here", a line for each parameter in which the run in a folder differs from p.
std::string lines_of_differences(const fs::path& folder, const Parameters& p, RunObserver& observer) {
  try {
    std::vector<std::string> lines = differences(scenario_of(folder, observer), p);
    return "  " + (lines.empty() ? "it was written by another version of the program" : listed(lines, "\n  "));
  } catch (const InputOutputError& trouble) {
    return fmt::format("  its parameters cannot be compared: {}", trouble.what());
  }
}

bool holds_run(const FolderState& state, const Parameters& p) {
  if (!state.has(Holds::a_run | Holds::checkpoint)) return false;
  const std::string wanted = configuration_hash(p);
  return text_of(state.record, "configuration_hash") == wanted || written_configuration(state.folder) == wanted;
}

/// Whether the last event of a run is the one that begins a branch.
bool began_with(const Json& record, const Json& event) {
  const std::vector<Json> lineage = lineage_of(record);
  return !lineage.empty()
         && std::ranges::all_of(std::array{"event", "from", "at_s", "configuration_hash"}, [&](const char* key) {
              return lineage.back().value(key, Json()) == event.value(key, Json());
            });
}

} // namespace

FolderState look_at(const fs::path& folder) {
  FolderState state{.folder = folder};
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) state.holds |= Holds::missing;
  if (fs::exists(status) && !fs::is_directory(status)) state.holds |= Holds::a_file;
  if (state.holds != 0) return state;
  list_entries(state);
  if (fs::exists(folder / "run.json", error)) state.holds |= Holds::run_json;
  if (has_checkpoint(folder)) state.holds |= Holds::checkpoint;
  if (fs::exists(folder / "study.resolved.toml", error)) state.holds |= Holds::a_study;
  state.record = record_of(folder);
  if (state.record.is_object()) state.holds |= Holds::a_run;
  return state;
}

FolderState look_at(const fs::path& folder, const Parameters& p, RunObserver& observer) {
  FolderState state = look_at(folder);
  if (holds_run(state, p))
    state.holds |= Holds::this_run;
  else if (state.has(Holds::a_run) && !state.has(Holds::a_study))
    state.detail = lines_of_differences(folder, p, observer);
  return state;
}

FolderState look_at_branch(const fs::path& folder, const Parameters& p, const Json& event) {
  FolderState state = look_at(folder);
  if (text_of(state.record, "configuration_hash") == configuration_hash(p) && began_with(state.record, event))
    state.holds |= state.has(Holds::checkpoint) ? Holds::this_branch : Holds::begun_branch;
  return state;
}

void require(const FolderState& state, Use use) {
  const auto row = std::ranges::find_if(refusals, [&](const Refusal& refusal) {
    return (refusal.uses & of(use)) != 0 && (refusal.holds == anything || state.has(refusal.holds));
  });
  if (row != std::end(refusals) && row->sentence != taken)
    throw InputOutputError(fmt::format("{}: {}", state.folder.string(), filled(row->sentence, state)));
}

void warn_of_other_files(const fs::path& folder, RunObserver& observer) {
  const std::vector<std::string> foreign = foreign_entries(folder);
  if (foreign.empty()) return;
  observer.warn(
      fmt::format("{}: these are not files of a run and are kept: {}", folder.string(), listed(foreign, ", ")));
}

std::vector<std::string> differences(const Parameters& there, const Parameters& here) {
  std::vector<std::string> all;
  for (const auto& [path, before, now] : parameters_that_differ(there, here))
    if (path != "run.threads") all.push_back(fmt::format("{}: {} there, {} here", path, shown(before), shown(now)));
  return all;
}

std::string listed(std::vector<std::string> items, std::string_view separator) {
  if (items.size() > max_listed) {
    const std::size_t more = items.size() - max_listed;
    items.resize(max_listed);
    items.push_back(fmt::format("and {} more", more));
  }
  return fmt::format("{}", fmt::join(items, separator));
}

} // namespace matrigrate::run
