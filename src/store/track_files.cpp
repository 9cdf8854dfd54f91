#include "store/track_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace matrigrate::io {

namespace {

/// Of a disc of the same area [um].
double radius(const TrackRow& row) { return std::sqrt(row.area / std::numbers::pi); }

} // namespace

std::string celltrackr_csv(std::span<const TrackRow> rows) {
  std::string text = "id,t,x,y\n";
  for (const TrackRow& row : rows) text += fmt::format("1,{},{},{}\n", row.t, row.centre.x(), row.centre.y());
  return text;
}

std::string trackmate_csv(std::span<const TrackRow> rows) {
  std::string text = "ID,TRACK_ID,POSITION_X,POSITION_Y,POSITION_Z,POSITION_T,FRAME,RADIUS\n";
  for (std::size_t k = 0; k < rows.size(); ++k)
    text += fmt::format("{},0,{},{},0,{},{},{}\n", k, rows[k].centre.x(), rows[k].centre.y(), rows[k].t, k,
                        radius(rows[k]));
  return text;
}

std::string trackmate_xml(std::span<const TrackRow> rows) {
  const double interval = rows.size() > 1 ? rows[1].t - rows[0].t : 0.0;
  std::string text = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Tracks nTracks=\"1\" spaceUnits=\"um\" "
                                 "frameInterval=\"{}\" timeUnits=\"s\" from=\"matrigrate\">\n"
                                 "  <particle nSpots=\"{}\">\n",
                                 interval, rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    text += fmt::format("    <detection t=\"{}\" x=\"{}\" y=\"{}\" z=\"0\" />\n", k, rows[k].centre.x(),
                        rows[k].centre.y());
  return text + "  </particle>\n</Tracks>\n";
}

} // namespace matrigrate::io
