#include "study_report/measured_json.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace matrigrate::study {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_tracks = 200;
constexpr std::size_t most_positions = 100;

/// Index of the k-th of `chosen` out of n, the first and the last among them.
std::size_t evenly(std::size_t k, std::size_t chosen, std::size_t n) {
  return chosen < 2 ? 0 : k * (n - 1) / (chosen - 1);
}

double rounded(double um) { return std::round(100.0 * um) / 100.0; }

void add_track(const tracks::CellTrack& track, Json& json) {
  if (!json["t_s"].empty())
    for (const char* column : {"t_s", "x_um", "y_um"}) json[column].push_back(nullptr);
  const std::size_t n = std::min(track.t.size(), most_positions);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = evenly(k, n, track.t.size());
    json["t_s"].push_back(rounded(track.t[i]));
    json["x_um"].push_back(rounded(track.x[i] - track.x[0]));
    json["y_um"].push_back(rounded(track.y[i] - track.y[0]));
  }
}

/// True if a target with these tracks holds at a condition.
bool hold_at(const Study& study, const std::vector<tracks::CellTrack>* tracks, std::size_t condition) {
  return std::ranges::any_of(study.targets, [&](const Target& t) {
    return t.tracks.get() == tracks && (t.at.empty() || std::ranges::find(t.at, condition) != t.at.end());
  });
}

} // namespace

Json measured_json(const std::vector<tracks::CellTrack>& tracks) {
  if (tracks.empty()) return {};
  Json json{{"total", tracks.size()}, {"t_s", Json::array()}, {"x_um", Json::array()}, {"y_um", Json::array()}};
  const std::size_t n = std::min(tracks.size(), most_tracks);
  for (std::size_t k = 0; k < n; ++k) add_track(tracks[evenly(k, n, tracks.size())], json);
  return json;
}

std::vector<tracks::CellTrack> tracks_at(const Study& study, const std::vector<tracks::CellTrack>& further,
                                         std::size_t point) {
  std::vector<tracks::CellTrack> all = further;
  for (const auto& set : measured_sets(study))
    if (hold_at(study, set.get(), study.points[point].condition)) std::ranges::copy(*set, std::back_inserter(all));
  return all;
}

Json measured_json(const Study& study, const std::vector<tracks::CellTrack>& further, const std::vector<Json>& places) {
  Json list = Json::array();
  if (!further.empty()) {
    list.push_back(measured_json(further));
    list.back()["points"] = places;
  }
  for (const auto& set : measured_sets(study)) {
    list.push_back(measured_json(*set));
    list.back()["points"] = Json::array();
    for (std::size_t i = 0; i < places.size(); ++i)
      if (hold_at(study, set.get(), study.points[i].condition)) list.back()["points"].push_back(places[i]);
  }
  return list;
}

} // namespace matrigrate::study
