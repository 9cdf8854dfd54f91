#include "study_runs/study_folder.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/platform.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "parameters/write.hpp"
#include "run/estimate.hpp"
#include "run/folder_state.hpp"
#include "run/resume.hpp"
#include "run/run_record.hpp"
#include "statistics/sample.hpp"
#include "study_plan/names.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>

namespace matrigrate::study {

namespace {

namespace fs = std::filesystem;

constexpr const char* study_file = "study.resolved.toml";
constexpr const char* scenario_file = "scenario.resolved.toml";

/// The base as it is written: its seed and threads have no meaning in a study.
Parameters neutral(Parameters p) {
  p.run.seed = RunParameters{}.seed;
  p.run.threads = run::threads_in_texts;
  return p;
}

std::string base_text(const StudyFolder& study) { return to_toml(neutral(study.study.base)); }

bool is_text(const fs::path& file, const std::string& text) {
  return fs::exists(file) && read_file(file, largest_file) == text;
}

/// Whether a file of a study is there, and means the same, in whatever version's words: it is the record of who wrote
/// it, and stays.
template <class Same>
bool holds(const fs::path& file, const Same& same) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  try {
    return same(file);
  } catch (const ConfigurationError&) { // was damaged, or changed
    return false;
  }
}

bool holds_base(const StudyFolder& study) {
  return holds(study.folder / scenario_file,
               [&](const fs::path& file) { return same(neutral(read_unjudged(file)), neutral(study.study.base)); });
}

bool holds_points(const StudyFolder& study) {
  return holds(study.folder / study_file, [&](const fs::path& file) {
    const std::string text = to_toml(study.study, scenario_file);
    return is_text(file, text) || to_toml(read_study(file), scenario_file) == text;
  });
}

/// The points of a study by what decides on their first runs, and how people call them.
std::map<std::string, std::string> points_of(const StudyFolder& study) {
  std::map<std::string, std::string> points;
  const Names names(study.study);
  for (const Run& run : study.runs)
    if (run.replicate == 1) points.emplace(run.hash, label_of(study.study.points[run.point].settings, names, true));
  return points;
}

/// What those of the points are called that others have not.
std::vector<std::string> without(const std::map<std::string, std::string>& points,
                                 const std::map<std::string, std::string>& others) {
  std::vector<std::string> names;
  for (const auto& [hash, name] : points)
    if (!others.contains(hash)) names.push_back(name);
  std::ranges::sort(names);
  return names;
}

/// In what two studies differ, a line each.
std::vector<std::string> differences(const StudyFolder& there, const StudyFolder& here,
                                     const std::vector<std::string>& only_there,
                                     const std::vector<std::string>& only_here) {
  std::vector<std::string> lines = run::differences(neutral(there.study.base), neutral(here.study.base));
  if (there.study.seed != here.study.seed)
    lines.push_back(fmt::format("seed: {} there, {} here", there.study.seed, here.study.seed));
  if (there.study.common_random_numbers != here.study.common_random_numbers)
    lines.push_back(fmt::format("common_random_numbers: {} there, {} here", there.study.common_random_numbers,
                                here.study.common_random_numbers));
  if (!lines.empty() && only_there == only_here) return lines; // the points are called the same
  for (const std::string& name : only_there) lines.push_back("only there: " + name);
  for (const std::string& name : only_here) lines.push_back("only here: " + name);
  return lines;
}

/// Notes in what the study of a folder differs, if neither extends the other and something was computed of it.
void compare_with(const StudyFolder& study, run::FolderState& state) {
  if (holds_points(study) && holds_base(study)) return;
  try {
    const StudyFolder there = open_study(study.folder);
    const auto points_there = points_of(there);
    const auto points_here = points_of(study);
    const std::vector<std::string> only_there = without(points_there, points_here);
    const std::vector<std::string> only_here = without(points_here, points_there);
    const auto is_missing = [&](const Run& run) { return standing(there.folder, run).status == RunState::missing; };
    if (only_there.empty() || only_here.empty() || std::ranges::all_of(there.runs, is_missing)) return;
    state.holds |= run::Holds::other_study;
    state.detail = (there.study.title.empty() ? std::string() : fmt::format(", \"{}\"", there.study.title)) + ":\n  "
                   + run::listed(differences(there, study, only_there, only_here), "\n  ");
  } catch (const ConfigurationError& error) {
    state.holds |= run::Holds::unclear_study;
    state.detail = error.what();
  }
}

/// What was written of a study before its file: of a pool that was killed early.
void forget_own_names(const StudyFolder& study, run::FolderState& state) {
  if (holds_base(study)) std::erase(state.names, scenario_file);
  const auto sets = measured_sets(study.study);
  for (std::size_t k = 0; k < sets.size(); ++k)
    if (is_text(study.folder / measured_file(k), tracks::measured_csv(*sets[k])))
      std::erase(state.names, measured_file(k));
  std::erase(state.names, "runs");
  if (state.names.empty()) state.holds &= ~unsigned{run::Holds::something};
}

/// The seed that the scenario in a folder of a run names; none if there is no such file.
std::optional<std::uint64_t> written_seed(const fs::path& folder) {
  const fs::path file = folder / scenario_file;
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};
  const std::string text = read_file(file, largest_file);
  constexpr std::string_view key = "\nseed = ";
  const std::size_t at = text.find(key);
  std::uint64_t seed = 0;
  if (at == std::string::npos) return {};
  const auto end = std::from_chars(text.data() + at + key.size(), text.data() + text.size(), seed);
  return end.ec == std::errc() ? std::optional(seed) : std::nullopt;
}

/// The names of the folders in runs/ that no run of the study has.
std::set<std::string> other_folders(const StudyFolder& study) {
  std::set<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(study.folder / "runs", error))
    if (entry.is_directory(error)) names.insert(entry.path().filename().string());
  for (const Run& run : study.runs) names.erase(run.hash);
  return names;
}

/// A run that may lie in a folder of another name.
struct Wanted {
  Run* run;
  std::string hash; ///< of its configuration, with the seed by which it is known
};

/// Runs that are not where this program has them, by their seed, which is quickly read; those of a law that is spelled
/// otherwise than its meaning by the seed of earlier versions as well.
std::multimap<std::uint64_t, Wanted> wanted_runs(StudyFolder& study) {
  std::multimap<std::uint64_t, Wanted> wanted;
  std::error_code error;
  for (Run& run : study.runs) {
    if (fs::exists(run_folder(study.folder, run), error)) continue;
    wanted.emplace(run.seed, Wanted{&run, run.hash});
    Run typed = run;
    typed.seed = seed_as_typed(study.study, run);
    if (typed.seed != run.seed)
      wanted.emplace(typed.seed, Wanted{&run, run::configuration_hash(parameters_of(study.study, typed))});
  }
  return wanted;
}

/// Runs whose folders have another name than this program gives them, as another version may have: they are known by
/// their own scenario.
void find_by_scenario(StudyFolder& study) {
  const std::set<std::string> others = other_folders(study);
  if (others.empty()) return;
  auto wanted = wanted_runs(study);
  for (const std::string& name : others) {
    const fs::path folder = study.folder / "runs" / name;
    const auto seed = wanted.empty() ? std::nullopt : written_seed(folder);
    if (!seed || !wanted.contains(*seed)) continue;
    const std::string hash = run::written_configuration(folder);
    const auto [first, last] = wanted.equal_range(*seed);
    const auto own = std::find_if(first, last, [&](const auto& one) { return one.second.hash == hash; });
    if (own == last) continue;
    Run* run = own->second.run;
    run->hash = name;
    run->seed = *seed;
    std::erase_if(wanted, [&](const auto& one) { return one.second.run == run; });
  }
}

/// True if a process works in the folder of a run. A process that begins a run waits until this test is over.
bool is_worked_on(const fs::path& folder) {
  const int descriptor = ::open((folder / ".lock").c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool locked = platform::lock(descriptor, platform::Lock::shared) == EWOULDBLOCK;
  ::close(descriptor);
  return locked;
}

/// Simulated time of the last row of tracks.csv [s].
double time_reached(const fs::path& folder) {
  const std::vector<double> t = store::csv_column(read_file(folder / "tracks.csv", largest_table), "t_s");
  return t.empty() ? 0.0 : t.back();
}

/// Wall time that went into a run so far: what run.json says, and the time since that was written [s].
double time_spent(const fs::path& folder) {
  const nlohmann::ordered_json record = run::record_of(folder);
  const auto found = record.find("wall_time_s");
  const double before = found != record.end() && found->is_number() ? found->get<double>() : 0.0;
  const auto since = fs::file_time_type::clock::now() - fs::last_write_time(folder / "run.json");
  return before + std::max(0.0, std::chrono::duration<double>(since).count());
}

std::optional<RunningRun> running_run(const StudyFolder& study, std::size_t i) {
  const fs::path folder = run_folder(study.folder, study.runs[i]);
  if (!is_worked_on(folder)) return {};
  RunningRun run{.run = i, .share = 0.0, .left = {}};
  try {
    const double whole = study.study.points[study.runs[i].point].parameters.run.duration;
    const double share = std::min(1.0, time_reached(folder) / whole);
    if (share > 0.0) run.left = time_spent(folder) * (1.0 - share) / share;
    run.share = share;
  } catch (const std::runtime_error&) { // its first files are being written
  }
  return run;
}

/// Time left for all runs together, from the done and the running runs.
std::optional<double> time_left(const StudyProgress& progress, const std::vector<Standing>& standings) {
  double left = 0.0;
  std::vector<double> whole; // of the runs of which it is known
  for (const RunningRun& run : progress.running) {
    if (!run.left || run.share >= 1.0) continue;
    left += *run.left;
    whole.push_back(*run.left / (1.0 - run.share));
  }
  for (const Standing& s : standings)
    if (s.done()) whole.push_back(s.wall_time);
  if (progress.running.empty() || whole.empty()) return {};
  const double mean = statistics::moments(whole).mean;
  const auto closed = std::ranges::count_if(standings, &Standing::ended);
  const double waiting = static_cast<double>(standings.size() - progress.running.size()) - static_cast<double>(closed);
  for (const RunningRun& run : progress.running)
    if (!run.left) left += mean;
  return (left + mean * std::max(0.0, waiting)) / static_cast<double>(progress.running.size());
}

} // namespace

StudyFolder planned(Study study, std::filesystem::path folder) {
  StudyFolder made{std::move(folder), std::move(study), {}};
  made.runs = planned_runs(made.study, run::configuration_hash);
  if (!made.folder.empty()) find_by_scenario(made);
  return made;
}

std::filesystem::path default_study_folder(const std::filesystem::path& file) {
  if (file.filename() == study_file) return file.has_parent_path() ? file.parent_path() : ".";
  return file.stem().string() + "-study";
}

std::filesystem::path full_path(const std::filesystem::path& folder) {
  const fs::path place = fs::absolute(folder).lexically_normal();
  return place.has_filename() ? place : place.parent_path();
}

void require_own_folder(const StudyFolder& study) {
  run::FolderState state = run::look_at(study.folder);
  if (state.has(run::Holds::a_study))
    compare_with(study, state);
  else if (!state.has(run::Holds::run_json | run::Holds::checkpoint))
    forget_own_names(study, state);
  require(state, run::Use::study);
}

void make_study_folder(const StudyFolder& study) {
  require_own_folder(study);
  make_folder(study.folder);
  make_folder(study.folder / "runs");
}

void write_study(const StudyFolder& study) {
  require_own_folder(study);
  if (!holds_base(study)) write_file(study.folder / scenario_file, base_text(study));
  const auto sets = measured_sets(study.study);
  for (std::size_t k = 0; k < sets.size(); ++k)
    if (const std::string text = tracks::measured_csv(*sets[k]); !is_text(study.folder / measured_file(k), text))
      write_file(study.folder / measured_file(k), text);
  if (!holds_points(study)) write_file(study.folder / study_file, to_toml(study.study, scenario_file));
}

StudyFolder open_study(const std::filesystem::path& folder) {
  require(run::look_at(folder), run::Use::see_study);
  return planned(read_study(folder / study_file), folder);
}

std::vector<std::string> run_command(const StudyFolder& study, const Run& run, int threads) {
  std::vector<std::string> command{platform::this_program(), "run", (study.folder / scenario_file).string()};
  for (const Setting& s : study.study.points[run.point].settings) {
    command.emplace_back("--set");
    command.push_back(s.key + "=" + s.value);
  }
  command.insert(command.end(), {"--seed", fmt::to_string(run.seed), "--threads", fmt::to_string(threads), "-o",
                                 run_folder(study.folder, run).string(), "--quiet"});
  return command;
}

std::string title_of(const StudyFolder& study, const Run& run) {
  return fmt::format("{}, replicate {}", study.study.points[run.point].label, run.replicate);
}

StudyProgress progress_of(const StudyFolder& study, const std::vector<Standing>& standings) {
  StudyProgress progress;
  for (std::size_t i = 0; i < study.runs.size(); ++i)
    if (standings[i].status == RunState::unfinished)
      if (auto run = running_run(study, i)) progress.running.push_back(*run);
  progress.left = time_left(progress, standings);
  return progress;
}

StudyCost cost(const StudyFolder& study) {
  StudyCost c;
  const auto replicates = static_cast<double>(study.study.replicates);
  std::map<std::tuple<double, double, Lattice>, std::size_t> counted; // particles of each matrix
  for (const Point& point : study.study.points) {
    const EcmParameters& ecm = point.parameters.ecm;
    const auto [matrix, is_new] = counted.try_emplace({ecm.radius, ecm.particle_spacing, ecm.lattice}, 0);
    if (is_new) matrix->second = run::particle_count(point.parameters);
    const run::RunCost run = run::run_cost(point.parameters, matrix->second);
    c.run_times.push_back(run.wall_time);
    c.wall_time += replicates * run.wall_time;
    c.memory_bytes = std::max(c.memory_bytes, run.memory_bytes);
    c.disk_bytes += replicates * run.disk_bytes;
  }
  // warnings take milliseconds per point: of many points some are looked at, spread evenly over the list
  const std::vector<Point>& points = study.study.points;
  c.looked_at = std::min<std::size_t>(points.size(), 200);
  for (std::size_t k = 0; k < c.looked_at; ++k) {
    const Point& point = points[k * points.size() / c.looked_at];
    for (const std::string& warning : run::warnings(point.parameters, run::derived(point.parameters)))
      c.warnings.push_back(fmt::format("{}: {}", point.label, warning));
  }
  return c;
}

} // namespace matrigrate::study
