#include "run/occupied_folder.hpp"

#include "base/failure.hpp"
#include "base/time_text.hpp"
#include "parameters/gone.hpp"
#include "parameters/schema.hpp"
#include "run/own_files.hpp"
#include "run/stopped_run.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace matrigrate::run {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::size_t max_listed = 20;

std::string bare(std::string text) {
  std::erase_if(text, [](char c) { return c == '"' || c == '\\'; });
  return text;
}

/// "  run.duration: 1 h there, 6 min here", a line for each parameter that differs.
std::string lines_of_differences(const fs::path& folder, const Parameters& p, RunObserver& observer) {
  std::vector<std::string> lines = differences(scenario_of(folder, observer), p);
  if (lines.empty()) return "  it was written by another version of the program\n";
  return "  " + listed(std::move(lines), "\n  ") + "\n";
}

double number_of(const Json& record, const char* key) {
  return record.contains(key) && record.at(key).is_number() ? record.at(key).get<double>() : 0.0;
}

/// The run in the folder, and how it differs from the new one.
std::string description(const fs::path& folder, const Json& record, const Parameters& p, RunObserver& observer) {
  std::string text = fmt::format("{}: holds another run ({}, {} of {}):\n", folder.string(), text_of(record, "status"),
                                 time_text(number_of(record, "t_s")), time_text(number_of(record, "duration_s")));
  try {
    text += lines_of_differences(folder, p, observer);
  } catch (const InputOutputError& trouble) {
    text += fmt::format("  its parameters cannot be compared: {}\n", trouble.what());
  }
  return text;
}

} // namespace

std::string listed(std::vector<std::string> items, std::string_view separator) {
  if (items.size() > max_listed) {
    const std::size_t more = items.size() - max_listed;
    items.resize(max_listed);
    items.push_back(fmt::format("and {} more", more));
  }
  return fmt::format("{}", fmt::join(items, separator));
}

std::vector<std::string> visible_entries(const fs::path& folder) {
  std::error_code error;
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (!entry.path().filename().string().starts_with('.')) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> differences(const Parameters& there, const Parameters& here) {
  std::vector<std::string> all;
  for (const Row& row : schema()) {
    const std::string before = bare(value_text(row, there));
    const std::string now = bare(value_text(row, here));
    if (before != now && row.path != "run.threads")
      all.push_back(fmt::format("{}: {} there, {} here", row.path, before, now));
  }
  for (const auto& [path, before, now] : gone_that_differ(there, here))
    all.push_back(fmt::format("{}: {} there, {} here", path, bare(before), bare(now)));
  if (cells_text(there) != cells_text(here))
    all.push_back(fmt::format("cells: {} there, {} here", bare(cells_text(there)), bare(cells_text(here))));
  return all;
}

bool is_free(const fs::path& folder) { return visible_entries(folder).empty(); }

void require_no_study(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder / "study.resolved.toml", error))
    throw InputOutputError(
        fmt::format("{}: is the folder of a study; choose another folder for the run with -o", folder.string()));
}

void require_free(const fs::path& folder, const Parameters& p, RunObserver& observer) {
  if (is_free(folder)) return;
  const Json record = record_of(folder);
  const std::string resume = fmt::format("matrigrate resume {}", folder.string());
  if (record.is_object()) {
    const bool done = status_of(record) == RunStatus::done;
    throw InputOutputError(
        fmt::format("{}-o FOLDER writes the new run somewhere else; {}{} that run; --force removes it "
                    "and starts the new one",
                    description(folder, record, p, observer), resume, done ? " --hours H extends" : " continues"));
  }
  if (has_checkpoint(folder))
    throw InputOutputError(fmt::format("{}: holds a run whose run.json is missing or damaged; it can be resumed: {}\n"
                                       "-o FOLDER writes the new run somewhere else",
                                       folder.string(), resume));
  throw InputOutputError(fmt::format("{}: exists and is not empty: it holds {}; choose another folder with -o, or pass "
                                     "--force: only files of an older run are removed",
                                     folder.string(), listed(visible_entries(folder), ", ")));
}

void warn_of_other_files(const fs::path& folder, RunObserver& observer) {
  const std::vector<std::string> foreign = foreign_entries(folder);
  if (foreign.empty()) return;
  observer.warn(
      fmt::format("{}: these are not files of a run and are kept: {}", folder.string(), listed(foreign, ", ")));
}

} // namespace matrigrate::run
