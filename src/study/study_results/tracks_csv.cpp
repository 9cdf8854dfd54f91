#include "study_results/results.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace matrigrate::study {

namespace {

/// tracks.csv of a run, whole.
std::string tracks_of(const std::filesystem::path& file) {
  std::string text = read_file(file, largest_table);
  if (!text.ends_with('\n')) throw InputOutputError(fmt::format("{}: is damaged: it is cut short", file.string()));
  try {
    store::read_csv(text);
  } catch (const InputOutputError& error) {
    throw InputOutputError(fmt::format("{}: is damaged: {}", file.string(), error.what()));
  }
  return text;
}

/// A line without its end.
std::string line_of(const std::vector<store::Field>& fields) {
  std::string line = store::csv_line(fields);
  line.pop_back();
  return line;
}

/// The columns before those of tracks.csv.
std::string front_names(const Study& study) {
  const auto names = concatenated<std::string>({{"run", "label"}, swept_columns(study), {"replicate", "seed"}});
  return line_of({names.begin(), names.end()});
}

std::string front_values(const Study& study, const Run& run) {
  const Point& point = study.points[run.point];
  const std::vector<std::string> swept = swept_values(study, point);
  return line_of(concatenated<store::Field>({{std::string_view(run.hash), std::string_view(point.label)},
                                             {swept.begin(), swept.end()},
                                             {std::uint64_t{run.replicate}, run.seed}}));
}

} // namespace

std::string tracks_csv(const Study& study, const std::vector<Result>& results,
                       const std::filesystem::path& study_folder) {
  std::string widest; // columns: runs with a nucleus have further ones behind those of the others
  std::vector<std::pair<const Run*, std::string>> all;
  for (const Result& r : results) {
    if (!r.standing.done()) continue;
    const std::filesystem::path file = run_folder(study_folder, r.run) / "tracks.csv";
    std::string tracks = tracks_of(file);
    const std::string own = tracks.substr(0, tracks.find('\n'));
    if (!(own + ",").starts_with(widest.empty() ? "" : widest + ",") && !(widest + ",").starts_with(own + ","))
      throw InputOutputError(fmt::format("{}: has other columns than earlier runs", file.string()));
    if (own.size() > widest.size()) widest = own;
    all.emplace_back(&r.run, std::move(tracks));
  }
  const auto commas = [](std::string_view line) { return static_cast<std::size_t>(std::ranges::count(line, ',')); };
  std::string text;
  for (const auto& [run, tracks] : all) {
    std::size_t at = tracks.find('\n') + 1;
    const std::string missing(commas(widest) - commas(tracks.substr(0, at)), ',');
    const std::string front = front_values(study, *run);
    while (at < tracks.size()) {
      const std::size_t end = tracks.find('\n', at);
      text.append(front).append(1, ',').append(tracks, at, end - at).append(missing).append(1, '\n');
      at = end + 1;
    }
  }
  return widest.empty() ? std::string() : front_names(study) + "," + widest + "\n" + text;
}

std::vector<exchange::RunTracks> run_tracks(const Study& study, const std::vector<Result>& results,
                                            const std::filesystem::path& study_folder) {
  std::vector<exchange::RunTracks> all;
  for (const Result& r : results) {
    if (!r.standing.done()) continue;
    const std::filesystem::path file = run_folder(study_folder, r.run) / "tracks.csv";
    const store::CsvTable table = store::read_csv(tracks_of(file));
    const auto column = [&](const char* name) {
      if (const auto at = table.column(name)) return *at;
      throw InputOutputError(fmt::format("{}: is damaged: it has no column {}", file.string(), name));
    };
    const std::size_t cell = column("track"), t = column("t_s"), x = column("x_um"), y = column("y_um"),
                      area = column("area_um2");
    const Point& point = study.points[r.run.point];
    exchange::RunTracks run{
        .name = r.run.hash, .condition = point.label, .replicate = r.run.replicate, .seed = r.run.seed, .rows = {}};
    for (const Setting& setting : point.settings) run.settings.emplace_back(setting.key, setting.value);
    for (const std::vector<std::string>& row : table.rows) {
      const auto number = [&](std::size_t at) { return store::csv_number(row[at]); };
      run.rows.push_back({.t = number(t),
                          .cell = static_cast<std::uint32_t>(std::max(1.0, number(cell))) - 1,
                          .centre = {number(x), number(y)},
                          .area = number(area),
                          .polarization = {}});
    }
    all.push_back(std::move(run));
  }
  return all;
}

} // namespace matrigrate::study
