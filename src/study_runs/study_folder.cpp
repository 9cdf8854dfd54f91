#include "study_runs/study_folder.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "parameters/write.hpp"
#include "run/run_record.hpp"
#include "study_runs/child.hpp"

#include <fmt/format.h>

namespace matrigrate::study {

namespace {

constexpr std::size_t largest_file = std::size_t{1} << 25;
constexpr const char* study_file = "study.resolved.toml";
constexpr const char* scenario_file = "scenario.resolved.toml";

/// The base as it is written: its seed and threads have no meaning in a study.
Parameters neutral(Parameters p) {
  p.run.seed = RunParameters{}.seed;
  p.run.threads = RunParameters{}.threads;
  return p;
}

void write_if_new(const std::filesystem::path& file, const std::string& text) {
  if (std::filesystem::exists(file) && read_file(file, largest_file) == text) return;
  write_file(file, text);
}

} // namespace

StudyFolder planned(Study study, std::filesystem::path folder) {
  StudyFolder made{std::move(folder), std::move(study), {}};
  made.runs = planned_runs(made.study, run::configuration_hash);
  return made;
}

std::filesystem::path default_study_folder(const std::filesystem::path& file) {
  if (file.filename() == study_file) return file.has_parent_path() ? file.parent_path() : ".";
  return file.stem().string() + "-study";
}

void make_study_folder(const std::filesystem::path& folder) {
  const bool known = std::filesystem::exists(folder / study_file) || std::filesystem::exists(folder / ".lock");
  try {
    make_output_folder(folder, known);
  } catch (const InputOutputError&) {
    if (std::filesystem::is_directory(folder))
      throw InputOutputError(
          fmt::format("{}: holds other files, and no study; choose another folder with -o", folder.string()));
    throw;
  }
  make_output_folder(folder / "runs", true);
}

void write_study(const StudyFolder& study) {
  write_if_new(study.folder / scenario_file, to_toml(neutral(study.study.base)));
  write_if_new(study.folder / study_file, to_toml(study.study, scenario_file));
}

StudyFolder open_study(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / study_file;
  if (!std::filesystem::exists(file))
    throw InputOutputError(fmt::format("{}: is no folder of a study: it has no {}", folder.string(), study_file));
  return planned(read_study(file), folder);
}

std::vector<std::string> run_command(const StudyFolder& study, const Run& run, int threads) {
  std::vector<std::string> command{this_program(), "run", (study.folder / scenario_file).string()};
  for (const Setting& s : study.study.points[run.point].settings) {
    command.emplace_back("--set");
    command.push_back(s.key + "=" + s.value);
  }
  for (const std::string& word :
       {std::string("--seed"), fmt::format("{}", run.seed), std::string("--threads"), fmt::format("{}", threads),
        std::string("-o"), run_folder(study.folder, run).string(), std::string("--quiet")})
    command.push_back(word);
  return command;
}

std::string title_of(const StudyFolder& study, const Run& run) {
  return fmt::format("{}, replicate {}", study.study.points[run.point].label, run.replicate);
}

} // namespace matrigrate::study
