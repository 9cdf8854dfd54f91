#include "exchange/track_files.hpp"

#include "observe/even_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace matrigrate::exchange {

namespace {

/// Radius of the disc of the same area [um].
double radius(const TrackRow& row) { return std::sqrt(row.area / std::numbers::pi); }

/// The ids of the cells, in the order of their first rows; without rows that of a single cell.
std::vector<std::uint32_t> cells_of(std::span<const TrackRow> rows) {
  std::vector<std::uint32_t> cells;
  for (const TrackRow& row : rows)
    if (std::ranges::find(cells, row.cell) == cells.end()) cells.push_back(row.cell);
  return cells.empty() ? std::vector<std::uint32_t>{0} : cells;
}

} // namespace

std::string celltrackr_csv(std::span<const TrackRow> rows) {
  std::string text = "id,t_s,x_um,y_um\n";
  for (const TrackRow& row : rows)
    text += fmt::format("{},{},{},{}\n", number_of(row.cell), row.t, row.centre.x(), row.centre.y());
  return text;
}

std::string trackmate_csv(std::span<const TrackRow> rows) {
  const bool even = observe::even_times(observe::times_of(rows)).is_even();
  const char* const frame = even ? "FRAME," : "";
  const char* const title = even ? "Frame," : "";
  std::string text = fmt::format(
      "ID,TRACK_ID,POSITION_X,POSITION_Y,POSITION_Z,POSITION_T,{0}RADIUS\nSpot ID,Track ID,X,Y,Z,T,{1}Radius\n"
      "Spot ID,Track ID,X,Y,Z,T,{1}R\n,,(micron),(micron),(micron),(sec),{2}(micron)\n",
      frame, title, even ? "," : "");
  std::map<std::uint32_t, std::size_t> frames; // rows so far of each cell
  for (std::size_t k = 0; k < rows.size(); ++k)
    text += fmt::format("{},{},{},{},0,{},{}{}\n", k, rows[k].cell, rows[k].centre.x(), rows[k].centre.y(), rows[k].t,
                        even ? fmt::format("{},", frames[rows[k].cell]++) : "", radius(rows[k]));
  return text;
}

std::string trackmate_xml(std::span<const TrackRow> rows) {
  const std::vector<std::uint32_t> cells = cells_of(rows);
  const observe::EvenTimes times = observe::even_times(observe::times_of(rows));
  if (!times.is_even()) throw std::invalid_argument(fmt::format("the rows are {}", times.text()));
  std::string particles;
  for (const std::uint32_t cell : cells) {
    const std::vector<TrackRow> own = rows_of(rows, cell);
    particles += fmt::format("  <particle nSpots=\"{}\">\n", own.size());
    for (std::size_t k = 0; k < own.size(); ++k)
      particles += fmt::format("    <detection t=\"{}\" x=\"{}\" y=\"{}\" z=\"0\" />\n", k, own[k].centre.x(),
                               own[k].centre.y());
    particles += "  </particle>\n";
  }
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Tracks nTracks=\"{}\" spaceUnits=\"um\" "
                     "frameInterval=\"{}\" timeUnits=\"s\" from=\"matrigrate\">\n{}</Tracks>\n",
                     cells.size(), times.interval, particles);
}

} // namespace matrigrate::exchange
