#pragma once

#include "tracks/findings.hpp"
#include "tracks/options.hpp"
#include "tracks/table.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Positions as a file has them, in its own units. Test: tests/unit/tracks/reading_test.cpp
namespace matrigrate::tracks {

struct Spot {
  std::size_t track = 0; ///< index into Spots::names
  double t = 0.0;        ///< if there is a time
  double frame = 0.0;    ///< if there are frames
  double x = 0.0;
  double y = 0.0;
  std::size_t line = 0;          ///< 0 where it has none
  const SheetRow* row = nullptr; ///< of a table, while it is read
};

/// What the positions of a file were multiplied with.
struct Scales {
  double um_per_unit = 1.0;
  double s_per_unit = 1.0; ///< of t, or of the number of the frame
  bool by_frame = false;   ///< times are frame x s_per_unit
};

/// How a file was understood.
struct Understood {
  std::string encoding, layout;
  char separator = '\0'; ///< none of XML
  bool decimal_comma = false;
  ColumnNames columns; ///< what the columns were taken for; empty where there is none
  Scales scales;
};

struct Spots : Understood {
  std::vector<Spot> spots;
  std::vector<std::string> names; ///< of the tracks
  std::string length_unit;        ///< as the file states it; empty if it does not
  std::string time_unit;          ///< of t
  double t_digit = 0.0;           ///< the last one that t is written to; 0 if it is not known
  bool has_t() const { return !columns.t.empty(); }
  bool has_frames() const { return !columns.frame.empty(); }
  std::size_t nowhere = 0; ///< rows without a position
  std::size_t made_up = 0; ///< positions that a tracker has made up, and that are left out
  std::string apart;       ///< a column that would tell tracks of one id apart that are in two places at one time
};

/// The spots of a table of text.
Spots table_spots(std::string_view text, const TrackOptions& options, Findings& findings);

/// The spots of TrackMate's "Export tracks to XML file".
Spots xml_spots(std::string_view text, Findings& findings);

/// The points of MTrackJ's data file (.mdf): in pixels, at numbers of frames.
Spots mtrackj_spots(std::string_view text, Findings& findings);

/// Turns x and y into um, and t into s, and notes the scales. Nothing is guessed: what neither the file nor the caller
/// states is a fault. What the caller states counts; if the file states another, a note says so. Test:
/// tests/unit/tracks/reading_test.cpp
void calibrate(Spots& spots, const TrackOptions& options, Findings& findings);

// Steps that no cell makes: of tracks that go on in another movie. Test: tests/unit/tracks/reading_test.cpp

struct Tracks;

/// From one position of a track to the next one that is there.
struct Step {
  double dx, dy;
  double gap = 1.0; ///< intervals

  /// As of one interval, if the cell walks at random.
  double length() const;
};

/// Median length of the steps over one interval that move at all; 0 if there is none.
double usual_step(std::span<const Step> steps);

/// What steps of several tracks at one time are.
enum class Together {
  walks,
  shifts, ///< the stage moved: all step alike
  leaps   ///< half of them are longer than ten usual steps, nearly all than three
};
/// @param sure  whether a column changes with them: then half of it is enough for steps over one interval
Together together(std::span<const Step> steps, double usual, bool sure = false);

/// Looks for times at which all tracks leap, which is another movie, and for single leaps. A fault if all leap from one
/// interval to the next, unless the caller says that there are no movies; else a note.
void look_for_leaps(const Tracks& tracks, const TrackOptions& options, Findings& findings);

} // namespace matrigrate::tracks
