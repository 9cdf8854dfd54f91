#include "tracks/layouts.hpp"
#include "tracks/options.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace matrigrate::tracks {
namespace {

TEST(TrackColumns, KeysAndNames) {
  ColumnNames names;
  add_columns("track=Track n\u00b0,t=Time, of frame [s],x=X [\u00b5m],group=Well,group=Day", names);
  EXPECT_EQ(names.track, "Track n\u00b0");
  EXPECT_EQ(names.t, "Time, of frame [s]") << "a comma that no key follows is one of the name";
  EXPECT_EQ(names.x, "X [\u00b5m]");
  EXPECT_EQ(names.group, (std::vector<std::string>{"Well", "Day"}));
  add_columns("y=Y", names);
  EXPECT_EQ(names.y, "Y");
  EXPECT_THROW(add_columns("y=Z", names), std::invalid_argument) << "named twice";
  EXPECT_THROW(add_columns("z=", names), std::invalid_argument);
  EXPECT_THROW(add_columns("place=X", names), std::invalid_argument);
}

TEST(TrackOptions, OutOfRange) {
  TrackOptions options;
  EXPECT_TRUE(faults_of(options).empty());
  options.pixel = 0.0;
  options.interval = -1.0;
  options.jitter = 0.5;
  options.time_unit = "sec";
  options.layout = "imarys";
  EXPECT_EQ(faults_of(options).size(), 5U);
}

TEST(TrackOptions, AreSpelledAsTheirCallerWritesThem) {
  TrackOptions options;
  const auto words = [&](Spelling spelling) {
    options.spelling = spelling;
    return options.say("time-unit", "s") + "; " + options.say("interval", "S") + "; "
           + options.say("columns", "track=A,t=2") + "; " + options.say("drift", "true") + "; "
           + options.say("interval");
  };
  EXPECT_EQ(words(Spelling::options), "--time-unit s; --interval S; --columns \"track=A,t=2\"; --drift; --interval");
  EXPECT_EQ(words(Spelling::keys),
            "time_unit = \"s\"; interval = S; columns = \"track=A,t=2\"; drift = true; interval");
  EXPECT_EQ(words(Spelling::python),
            "time_unit=\"s\"; frame_interval=S; columns={\"track\": \"A\", \"t\": 2}; drift=True; frame_interval");
  EXPECT_EQ(words(Spelling::r),
            "time_unit = \"s\"; frame_interval = S; columns = c(track = \"A\", t = 2); drift = TRUE; frame_interval");
}

TEST(ColumnTitles, NamesAndUnits) {
  const auto is = [](std::string_view written, std::string_view name, std::string_view unit) {
    const ColumnTitle title = column_title(written);
    EXPECT_EQ(title.name, name) << written;
    EXPECT_EQ(title.unit, unit) << written;
  };
  is("x_um", "x", "um");
  is("POSITION_X", "position_x", "");
  is(" Time [min] ", "time", "min");
  is("X (\u00b5m)", "x", "\u00b5m");
  is("Track n\u00b0", "track n", "");
  is("t_frame", "t", "frame");
  is("(px)", "(px)", "");
  is("", "", "");
}

TEST(TrackUnits, AreKnownOrNot) {
  for (const char* unit : {"um", "\u00b5m", "\u03bcm", "(micron)", "[UM]"}) EXPECT_EQ(length_unit(unit), 1.0) << unit;
  EXPECT_EQ(length_unit("nm"), 1e-3);
  EXPECT_EQ(length_unit("pixel"), std::nullopt);
  EXPECT_EQ(time_unit("(Sec)"), 1.0);
  EXPECT_EQ(time_unit("hours"), 3600.0);
  EXPECT_EQ(time_unit("frame"), std::nullopt);
  EXPECT_TRUE(counts_frames("(frame)"));
}

} // namespace
} // namespace matrigrate::tracks
