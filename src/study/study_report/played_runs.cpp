#include "study_report/study_files.hpp"

#include "base/failure.hpp"
#include "run/finished_run.hpp"
#include "study_report/drawn_study.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace matrigrate::study {

namespace {

constexpr std::size_t max_runs = 5;           ///< that are chosen unasked
constexpr std::size_t max_bytes = 12'000'000; ///< of all of them

struct Choice {
  const Result* result;
  std::string why;
};

/// Of the runs of a point that are done, the one in the middle by the first read-out.
std::optional<Choice> typical(const StudyFolder& study, const std::vector<Result>& results, std::size_t point) {
  const std::string& readout = study.study.readouts.front();
  const std::size_t column = readout_column(readout);
  std::vector<const Result*> runs;
  for (const Result& r : results)
    if (r.run.point == point && r.standing.done() && std::isfinite(r.readouts[column])) runs.push_back(&r);
  if (runs.empty()) return {};
  const auto by_value = [&](const Result* r) { return r->readouts[column]; };
  std::ranges::sort(runs, {}, by_value);
  return Choice{runs[(runs.size() - 1) / 2],
                fmt::format("the middle one by {}", readouts_json(study.study).at(0).at("meaning").get<std::string>())};
}

/// Up to max_runs points, spread over all of them.
std::vector<Choice> typical_ones(const StudyFolder& study, const std::vector<Result>& results) {
  std::vector<Choice> chosen;
  const std::size_t points = study.study.points.size();
  const std::size_t n = std::min(points, max_runs);
  for (std::size_t k = 0; k < n; ++k)
    if (auto choice = typical(study, results, evenly(k, n, points))) chosen.push_back(*choice);
  return chosen;
}

const Result* find(const std::vector<Result>& results, const std::string& id) {
  const auto found = std::ranges::find_if(results, [&](const Result& r) { return r.run.hash == id; });
  return found == results.end() ? nullptr : &*found;
}

/// Every `stride`-th frame, and the last one.
void thin(observe::Film& film, std::size_t stride) {
  std::vector<observe::Frame> kept;
  for (std::size_t k = 0; k < film.frames.size(); ++k)
    if (k % stride == 0 || k + 1 == film.frames.size()) kept.push_back(std::move(film.frames[k]));
  film.frames = std::move(kept);
}

nlohmann::ordered_json page_of(const std::filesystem::path& folder, std::size_t stride) {
  run::FinishedRun run = run::read_run(folder);
  if (stride > 1) thin(run.film, stride);
  return page_data(run);
}

} // namespace

std::string fault_of_wanted(const std::vector<Result>& results, const std::vector<std::string>& wanted) {
  for (const std::string& id : wanted) {
    const Result* result = find(results, id);
    if (result == nullptr) return fmt::format("there is no run \"{}\" in this study", id);
    if (!result->standing.done()) return fmt::format("run {} is not done", id);
  }
  return {};
}

nlohmann::ordered_json played_runs(const StudyFolder& study, const std::vector<Result>& results,
                                   const std::vector<std::string>& wanted,
                                   const std::vector<tracks::CellTrack>& tracks) {
  std::vector<Choice> chosen;
  if (wanted.empty()) chosen = typical_ones(study, results);
  for (const std::string& id : wanted) chosen.push_back({find(results, id), "chosen"});
  nlohmann::ordered_json played = nlohmann::ordered_json::array();
  std::size_t stride = 1;
  for (const auto& [result, why] : chosen) {
    try {
      const std::filesystem::path folder = run_folder(study.folder, result->run);
      nlohmann::ordered_json page = page_of(folder, stride);
      if (played.empty()) {
        stride = page.dump().size() * chosen.size() / max_bytes + 1;
        if (stride > 1) page = page_of(folder, stride);
      }
      page["measured"] = measured_json(tracks_at(study.study, tracks, result->run.point));
      played.push_back({{"id", result->run.hash},
                        {"label", fmt::format("{}: {}", title_of(study, result->run), why)},
                        {"run", std::move(page)}});
    } catch (const InputOutputError&) { // its checkpoint or its frames were deleted
      if (!wanted.empty()) throw;
    }
  }
  return played;
}

} // namespace matrigrate::study
