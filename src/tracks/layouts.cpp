#include "tracks/layouts.hpp"

#include <algorithm>
#include <cstddef>

namespace matrigrate::tracks {

namespace {

struct UnitSize {
  double size;
  std::vector<std::string_view> names;
};
using UnitSizes = std::vector<UnitSize>;

const UnitSizes& lengths() {
  static const UnitSizes sizes{
      {1.0,
       {"um", "\u00b5m", "\u03bcm", "micron", "microns", "micrometer", "micrometers", "micrometre", "micrometres",
        "mikrometer", "microm\u00e8tre", "microm\u00e8tres", "micr\u00f3metro", "micr\u00f3metros", "micras"}},
      {1e-3, {"nm"}},
      {1e3, {"mm"}},
      {1e4, {"cm"}}};
  return sizes;
}

const UnitSizes& times() {
  static const UnitSizes sizes{
      {1e-3, {"ms", "msec"}},
      {1.0,
       {"s", "sec", "secs", "second", "seconds", "sek", "sekunde", "sekunden", "seconde", "secondes", "seg", "segundo",
        "segundos"}},
      {60.0, {"min", "mins", "minute", "minutes", "minuten", "minuto", "minutos"}},
      {3600.0, {"h", "hr", "hrs", "hour", "hours", "std", "stunde", "stunden", "heure", "heures", "hora", "horas"}},
      {86400.0, {"d", "day", "days"}}};
  return sizes;
}

/// A unit without the brackets around it, in lower case.
std::string bare_unit(std::string_view unit) {
  unit = trimmed(unit);
  while (unit.size() >= 2
         && ((unit.front() == '(' && unit.back() == ')') || (unit.front() == '[' && unit.back() == ']')))
    unit = trimmed(unit.substr(1, unit.size() - 2));
  return lower(unit);
}

std::optional<double> size_of_unit(const UnitSizes& sizes, std::string_view unit) {
  const std::string bare = bare_unit(unit);
  for (const auto& [size, names] : sizes)
    if (std::ranges::find(names, bare) != names.end()) return size;
  return std::nullopt;
}

bool is_unit(std::string_view text) {
  return length_unit(text) || time_unit(text) || counts_frames(text) || text == "px" || text == "pixel"
         || text == "pixels";
}

/// In lower case, of ASCII alone, with single blanks.
std::string plain_name(std::string_view written) {
  std::string name;
  for (const char c : lower(trimmed(written))) {
    if (static_cast<unsigned char>(c) >= 0x80) continue;
    if (c == ' ' && (name.empty() || name.back() == ' ')) continue;
    name += c;
  }
  return std::string(trimmed(name));
}

/// Names of several programs, and as people write them. What is not ASCII is left out: "clula" is "C\u00e9lula".
Layout any_table() {
  return {.name = "any",
          .track = {"unique_id",  "track_id",    "track id",   "trackid",     "track",      "track n*", "track number",
                    "track name", "track no",    "particle",   "particle_id", "trajectory", "cell_id",  "cell id",
                    "cellid",     "cell",        "cell no",    "cell number", "tid",        "spur",     "spur-id",
                    "zelle",      "zellen-id",   "zell-id",    "zellnummer",  "zelle nr",   "bahn",     "piste",
                    "cellule",    "trajectoire", "id cellule", "clula",       "celula",     "pista",    "trayectoria",
                    "traza",      "id"},
          .t = {"t", "time", "position_t", "position t", "time point", "timepoint", "time_point", "zeit", "zeitpunkt",
                "uhrzeit", "temps", "heure", "tiempo", "hora"},
          .frame = {"frame", "frames", "frame number", "frame_number", "frame no", "slice", "slice n*", "image",
                    "imagenumber", "bild", "bildnummer", "einzelbild", "imagen", "cadre", "trame", "fotograma",
                    "cuadro"},
          .x = {"x", "position_x", "position x", "pos_x", "x position", "x_position", "x-position", "centroid_x",
                "centroid x", "x_centroid", "x-koordinate", "x koordinate", "coordonne x", "coordenada x", "posicin x",
                "location_center_x"},
          .y = {"y", "position_y", "position y", "pos_y", "y position", "y_position", "y-position", "centroid_y",
                "centroid y", "y_centroid", "y-koordinate", "y koordinate", "coordonne y", "coordenada y", "posicin y",
                "location_center_y"},
          .z = {"z", "position_z", "position z", "pos_z", "z position", "z-position"}};
}

} // namespace

const std::vector<Layout>& layouts() {
  static const std::vector<Layout> all{
      {.name = "celltrackscolab",
       .track = {"unique_id"},
       .t = {"position_t"},
       .frame = {"frame"},
       .x = {"position_x"},
       .y = {"position_y"},
       .z = {"position_z"},
       .unique = true},
      {.name = "trackmate",
       .track = {"track_id"},
       .t = {"position_t"},
       .frame = {"frame"},
       .x = {"position_x"},
       .y = {"position_y"},
       .z = {"position_z"}},
      {.name = "plain", .track = {"track"}, .t = {"t"}, .frame = {"frame"}},
      {.name = "btrack", .track = {"id"}, .t = {"t"}, .required = {"parent", "root"}},
      {.name = "trackpy", .track = {"particle"}, .frame = {"frame"}},
      {.name = "mosaic", .track = {"trajectory"}, .frame = {"frame"}},
      {.name = "manual-tracking", .track = {"track n*"}, .frame = {"slice n*"}},
      {.name = "mtrackj", .track = {"tid"}, .t = {"t"}, .required = {"pid"}},
      {.name = "ilastik",
       .track = {"trackid", "track_id1"},
       .frame = {"frame", "timestep"},
       .x = {"center_of_the_object_0", "object_center_0", "center of the object_0", "object center_0"},
       .y = {"center_of_the_object_1", "object_center_1", "center of the object_1", "object center_1"},
       .z = {"center_of_the_object_2", "object_center_2", "center of the object_2", "object center_2"}},
      {.name = "imaris",
       .track = {"trackid"},
       .t = {"time"},
       .x = {"position x"},
       .y = {"position y"},
       .z = {"position z"}},
      {.name = "cellprofiler",
       .track = {"*trackobjects_label"},
       .frame = {"metadata_frame", "metadata_t", "metadata_timepoint", "imagenumber"},
       .x = {"location_center_x", "areashape_center_x"},
       .y = {"location_center_y", "areashape_center_y"},
       .z = {"location_center_z"}},
      {.name = "napari", .track = {"track_id"}, .t = {"t"}},
      {.name = "celltrackr", .track = {"id"}, .t = {"t"}, .frame = {"frame"}},
      any_table()};
  return all;
}

bool holds_steps(std::string_view plain) {
  static const std::vector<std::string_view> names{"dx",      "dy",     "delta_x", "delta_y",        "delta x",
                                                   "delta y", "step_x", "step_y",  "displacement_x", "displacement_y"};
  return plain.find("trackobjects_trajectory") != std::string_view::npos
         || std::ranges::find(names, plain) != names.end();
}

bool names_time(std::string_view plain) {
  const Layout::Names& names = layouts().back().t;
  return std::ranges::find(names, plain) != names.end();
}

bool tells_movies_apart(std::string_view plain) {
  static const std::vector<std::string_view> names{
      "movie",    "video",     "file",       "filename",      "file_name",  "file name", "well",
      "position", "condition", "experiment", "experiment_nb", "repeat",     "replicate", "run",
      "series",   "fov",       "field",      "site",          "scene",      "plate",     "dish",
      "sample",   "embryo",    "donor",      "image",         "image_name", "cid"};
  return std::ranges::find(names, plain) != names.end()
         || (plain.starts_with("metadata_") && plain != "metadata_frame" && plain != "metadata_t"
             && plain != "metadata_timepoint");
}

bool tells_made_up(std::string_view plain) {
  static const std::vector<std::string_view> names{"dummy", "interpolated", "is_interpolated", "predicted"};
  return std::ranges::find(names, plain) != names.end();
}

ColumnTitle column_title(std::string_view written) {
  const std::string_view text = trimmed(written);
  ColumnTitle title{.whole = plain_name(text), .name = {}, .unit = {}};
  title.name = title.whole;
  if (const std::size_t open = text.find_last_of("[(");
      open != std::string_view::npos && open > 0 && (text.back() == ']' || text.back() == ')')) {
    title.name = plain_name(text.substr(0, open));
    title.unit = bare_unit(text.substr(open));
  } else if (const std::size_t bar = text.find_last_of('_');
             bar != std::string_view::npos && bar > 0 && is_unit(lower(text.substr(bar + 1)))) {
    title.name = plain_name(text.substr(0, bar));
    title.unit = lower(text.substr(bar + 1));
  }
  return title;
}

std::optional<double> length_unit(std::string_view unit) { return size_of_unit(lengths(), unit); }
std::optional<double> time_unit(std::string_view unit) { return size_of_unit(times(), unit); }

bool counts_frames(std::string_view unit) {
  const std::string bare = bare_unit(unit);
  return bare == "frame" || bare == "frames";
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\n\r\f\v");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\n\r\f\v") - first + 1);
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

} // namespace matrigrate::tracks
