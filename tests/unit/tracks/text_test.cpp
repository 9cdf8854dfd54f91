#include "tracks/table.hpp"
#include "unit/tracks/reading.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

using namespace std::string_literals;

namespace matrigrate::tracks {
namespace {

Text read_text(std::string_view bytes) {
  Findings findings("f");
  Text text = decoded(bytes, findings);
  findings.raise();
  return text;
}

std::string refusal(std::string_view bytes) {
  try {
    read_text(bytes);
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "none";
}

TEST(TrackText, EncodingsAndEndsOfLines) {
  EXPECT_EQ(read_text("\xef\xbb\xbf"
                      "a\r\nb\rc\n")
                .utf8,
            "a\nb\nc\n");
  EXPECT_EQ(read_text("\xff\xfe"
                      "\xb5\0m\0"s)
                .utf8,
            "\u00b5m");
  EXPECT_EQ(read_text("\xfe\xff"
                      "\0\xb5\0m"s)
                .utf8,
            "\u00b5m");
  EXPECT_EQ(read_text("\xff\xfe"
                      "\x3d\xd8\x00\xde"s)
                .utf8,
            "\U0001F600")
      << "a surrogate pair";
  EXPECT_EQ(read_text("n\xb0 \x80").utf8, "n\u00b0 \u20ac");
  EXPECT_EQ(read_text("n\xb0").encoding, "Windows-1252");
  EXPECT_EQ(read_text("\u00b5").encoding, "UTF-8");
  EXPECT_EQ(read_text("\U0001F600").encoding, "UTF-8");
  for (const char* bytes : {"a\xc0\xaf", "a\xe0\x80\xaf", "a\xf0\x80\x80\xaf", "a\xed\xa0\x80", "a\xf4\x90\x80\x80"})
    EXPECT_EQ(read_text(bytes).encoding, "Windows-1252")
        << "longer than it need be, half of a pair, or beyond the last";
}

TEST(TrackText, SignsOfTypesetting) {
  EXPECT_EQ(read_text("\u22125,1\u00a0080,1\u202f080,\u20131,a\ufeffb,\u00b5,\u2026").utf8,
            "-5,1 080,1 080,-1,ab,\u00b5,\u2026");
  EXPECT_EQ(read_text("\x96"
                      "5,1\xa0"
                      "0")
                .utf8,
            "-5,1 0")
      << "of Windows-1252";
}

TEST(TrackText, WhatIsNoTextIsCalledByItsName) {
  EXPECT_EQ(refusal("PK\x03\x04..."), "f: is a workbook (.xlsx) or another archive: save the sheet as CSV");
  EXPECT_EQ(refusal("\xd0\xcf\x11\xe0..."), "f: is a workbook (.xls): save the sheet as CSV");
  EXPECT_EQ(refusal("\x1f\x8b..."), "f: is compressed (gzip): unpack it");
  EXPECT_EQ(refusal("a\n\0b"s), "f:2:1: is no text, or UTF-16 without its mark: save it as CSV in UTF-8");
  EXPECT_EQ(refusal("a\x01"), "f:1:1: has a control character: is it a text?");
}

std::vector<std::string> fields(std::string_view text, char separator) {
  const std::vector<SheetRow> rows = sheet_rows(text, separator);
  return rows.empty() ? std::vector<std::string>{} : rows[0].fields;
}

TEST(Sheet, Fields) {
  using Fields = std::vector<std::string>;
  EXPECT_EQ(fields("a, b ,c", ','), (Fields{"a", "b", "c"}));
  EXPECT_EQ(fields("\"a,1\",\"b\"\"\",", ','), (Fields{"a,1", "b\"", ""}));
  EXPECT_EQ(fields(" \ta\tb", '\t'), (Fields{"", "a", "b"})) << "ImageJ begins its lines so";
  EXPECT_EQ(fields("  a  b\tc  ", ' '), (Fields{"a", "b", "c"}));
  const std::vector<SheetRow> rows = sheet_rows("\n,,\n\"a\nb\",c\n\nd,e", ',');
  ASSERT_EQ(rows.size(), 2U) << "empty ones do not count";
  EXPECT_EQ(rows[0].line, 3U);
  EXPECT_EQ(rows[1].line, 6U);
  EXPECT_TRUE(sheet_rows("\"a,b", ',')[0].open_quote);
}

TEST(Sheet, NumbersAreDecimalNumbersAlone) {
  EXPECT_EQ(sheet_number(" +1.5e2 ", false), 150.0);
  EXPECT_EQ(sheet_number("-.5", false), -0.5);
  EXPECT_EQ(sheet_number("1,5", true), 1.5);
  for (const char* text :
       {"1_000", "\uff11\uff12", "0x10", "inf", "nan", "1e999", "1,5", "", "-", "1 000", "--1", "1.2.3", "+-1"})
    EXPECT_EQ(sheet_number(text, false), std::nullopt) << text;
  EXPECT_EQ(sheet_number("1.234,5", true), std::nullopt);
}

TEST(Sheet, SignsBetweenThousandsAreKnown) {
  for (const char* text : {"1.000,5", "1,000.5", " -12,345,678 ", "1 000", "1'000.25"})
    EXPECT_TRUE(has_thousands_sign(text)) << text;
  for (const char* text : {"1.2.3", "1000", "1,00", "12345,678.9", "", ",000", "a,000", "1,000.x", "1.000.5"})
    EXPECT_FALSE(has_thousands_sign(text)) << text;
}

TEST(Sheet, ASeparatorMayBeNamed) {
  std::string_view text = "sep=;\na;b";
  EXPECT_EQ(named_separator(text), ';');
  EXPECT_EQ(sheet_rows(text, ';')[0].line, 2U);
  text = "a;b";
  EXPECT_EQ(named_separator(text), std::nullopt);
}

} // namespace
} // namespace matrigrate::tracks

namespace matrigrate::tracks {
namespace {

/// A cell that goes 1 um along x every 120 s, 30 times, from x = 985 um on.
std::string passing(char separator, const char* thousands) {
  std::string text = fmt::format("track{0}t_s{0}x_um{0}y_um\n", separator);
  const auto number = [&](int value) {
    return value < 1000 ? std::to_string(value) : fmt::format("\"{}{}{:03d}\"", value / 1000, thousands, value % 1000);
  };
  for (int k = 0; k < 30; ++k) text += fmt::format("1{0}{1}{0}{2}{0}0\n", separator, number(120 * k), number(985 + k));
  return text;
}

TEST(TrackNumbers, SignsBetweenThousands) {
  for (const char separator : {'\t', ';', ','})
    for (const char* sign : {",", ".", "'", " ", "\u00a0", "\u202f"}) {
      if (separator == ',' && *sign == '.') continue;
      const Tracks cells = of_text(passing(separator, sign), few());
      EXPECT_EQ(cells.interval, 120.0) << separator << sign;
      EXPECT_DOUBLE_EQ(speed(cells), 30.0) << separator << sign;
    }
  EXPECT_TRUE(notes(of_text(passing(';', "."), few()), "points separate thousands: 1.000 is 1000"));
  EXPECT_TRUE(notes(of_text(passing('\t', ","), few()), "commas separate thousands: 1,080 is 1080")
              || notes(of_text(passing('\t', ","), few()), "commas separate thousands: 1,000 is 1000"));
}

TEST(TrackNumbers, DecimalsOfThreeDigitsAreNoThousands) {
  const std::string three = "track;t_s;x_um;y_um\n1;0;100,000;1,125\n1;60;100,500;1,125\n";
  EXPECT_DOUBLE_EQ(speed(of_text(three, few())), 30.0);
  EXPECT_EQ(of_text("track;t_s;x_um;y_um\n1;0;0;0\n1;60;0.125;0\n1;120;1.125;0\n", few()).tracks[0].x.back(), 1.125);
  EXPECT_EQ(of_text("track,t_s,x_um,y_um\n1,0,0,0\n1,60,1.125,0\n1,120,2.125,0\n", few()).tracks[0].x.back(), 2.125)
      << "with commas between columns a point is a decimal sign";
  EXPECT_EQ(faults("track;t_s;x_um;y_um\n1;0;0;0\n1;60;1.125;0\n", few()),
            "f:3:1: 1.125 may be a thousand or have decimals: write numbers without signs between their thousands");
}

TEST(TrackNumbers, BothSigns) {
  EXPECT_EQ(of_text("track;t_s;x_um;y_um\n1;0;999,5;0\n1;1.200;1.000,25;0\n", few()).tracks[0].x.back(), 1000.25);
  EXPECT_EQ(of_text("track,t_s,x_um,y_um\n1,0,\"133,288\",\"0,5\"\n1,60,\"134,288\",\"0,5\"\n", few()).tracks[0].x[0],
            133.288)
      << "quoted decimal commas";
  EXPECT_EQ(faults("track;t_s;x_um;y_um\n0;0;1,5;1.5\n0;60;1;1\n", few()),
            "f:2:1: has numbers with a comma, 1,5, and others with a point, 1.5: write points alone");
}

TEST(TrackColumns, TwoOfOneMeaning) {
  EXPECT_EQ(faults("track,t_s,x_um,y_um,x_um\n1,0,0,0,0\n1,60,1,0,2\n", few()),
            "f:3:1: x_um stands there twice, and the two contradict each other, 1 and 2: name the right one, {columns "
            "x=3}");
  TrackOptions fifth = few();
  add_columns("x=5", fifth.columns);
  EXPECT_EQ(of_text("track,t_s,x_um,y_um,x_um\n1,0,0,0,0\n1,60,1,0,2\n", fifth).tracks[0].x.back(), 2.0);
  EXPECT_TRUE(notes(of_text("track,t_s,x_um,y_um,x_um\n1,0,0,0,0\n1,60,1,0,1\n", few()),
                    "x_um stands there twice; both say the same"));
  EXPECT_EQ(faults("track,t_min,t_s,x_um,y_um\n1,0,0,0,0\n1,3,120,1,0\n", few()),
            "f:3:1: t_min and t_s contradict each other, 3 and 120: name the right one, {columns t=t_min}");
  EXPECT_TRUE(notes(of_text("track,time (min),t_s,x_um,y_um\n1,0,0,0,0\n1,2,120,1,0\n", few()),
                    "time (min) and t_s say the same")
              || notes(of_text("track,time (min),t_s,x_um,y_um\n1,0,0,0,0\n1,2,120,1,0\n", few()),
                       "t_s and time (min) say the same"));
}

/// The interval [s] of a cell at these times.
double interval(const std::vector<std::string>& times, const std::string& title = "time") {
  std::string text = "track," + title + ",x_um,y_um\n";
  for (std::size_t k = 0; k < times.size(); ++k) text += fmt::format("1,\"{}\",{},0\n", times[k], k);
  return of_text(text, few()).interval;
}

TEST(TrackClock, FormsOfTimes) {
  EXPECT_EQ(interval({"00:00:00", "00:02:00", "00:04:00"}), 120.0);
  EXPECT_EQ(interval({"0:59:00", "1:01:00", "1:03:00"}), 120.0);
  EXPECT_EQ(interval({"00:00.0", "02:00.5", "04:01.0"}), 120.5);
  EXPECT_EQ(interval({"58:00", "59:30", "1:01:00"}), 90.0);
  EXPECT_EQ(interval({"0 days 23:58:00", "1 days 00:00:00", "1 day, 0:02:00"}), 120.0);
  EXPECT_EQ(interval({"2024-05-03 23:58:00", "2024-05-04 00:00:00", "2024-05-04T00:02:00Z"}), 120.0);
  EXPECT_EQ(interval({"2024-02-28", "2024-02-29", "2024-03-01"}), 86400.0);
  EXPECT_EQ(interval({"03.05.2024 23:58", "04.05.2024 00:00", "04.05.2024 00:02"}), 120.0);
  EXPECT_EQ(interval({"5/3/2024 11:58:00 AM", "5/3/2024 12:00:00 PM", "5/3/2024 12:02:00 PM"}), 120.0);
  EXPECT_EQ(interval({"2024-05-03 10:05:00.25+02:00", "2024-05-03 10:05:01.50+02:00"}), 1.25);
  EXPECT_EQ(interval({"00:00", "00:02", "00:04"}, "time (h:min)"), 120.0);
  EXPECT_EQ(interval({"00:00", "00:02", "00:04"}, "time (mm:ss)"), 2.0);
}

TEST(TrackClock, WhatCanBeReadInTwoWaysIsAsked) {
  EXPECT_EQ(faults("track,time,x_um,y_um\n1,00:00,0,0\n1,00:02,1,0\n", few()),
            "f: time: times of two parts may be h:min or min:s: write all three, h:min:s");
  EXPECT_EQ(faults("track,time,x_um,y_um\n1,5/3/2024 10:00,0,0\n1,5/4/2024 10:00,1,0\n", few()),
            "f: time: dates with / may be read in two ways: write 2024-05-03");
  EXPECT_EQ(faults("track,time,x_um,y_um\n1,00:00:00,0,0\n1,00:02:0x,1,0\n1,00:04:00,1,0\n", few()),
            "f:3:1: time: \"00:02:0x\" is no time of the clock, as others are");
  EXPECT_EQ(faults("track,time,x_um,y_um\n1,23:58:00,0,0\n1,23:59:00,0,0\n1,00:00:00,1,0\n", few()),
            "f:4:1: time: times of the clock go over midnight: write them with the date");
}

// Lines of a table that are rows, and those that are none.

const std::string plain_head = "track,t_s,x_um,y_um\n";

/// Rows of a track that goes 1 um a minute along x.
std::string rows(const std::string& id, int n, double y = 0.0) {
  std::string text;
  for (int k = 0; k < n; ++k) text += fmt::format("{},{},{},{}\n", id, 60 * k, k, y);
  return text;
}

TEST(TrackComments, AnIdMayBeginAsOne) {
  for (const char* sign : {"#", "%", "//", ";"}) {
    EXPECT_EQ(of_text(plain_head + rows(sign + std::string("1"), 3) + rows("\"" + std::string(sign) + "2\"", 3), few())
                  .positions(),
              6U)
        << sign;
    const std::string comment = sign + std::string(" by hand, twice, with care, in May\n");
    const Tracks cells = of_text(plain_head + rows("1", 3) + comment + rows(sign + std::string("2"), 3), few());
    EXPECT_EQ(cells.positions(), 6U) << sign;
    EXPECT_TRUE(notes(cells, "1 comment within the table is left out (line 5)")) << sign;
  }
  EXPECT_TRUE(notes(of_text(plain_head + "# a\n#b,c,d,e\n# f\n#g\n" + rows("1", 3), few()),
                    "4 comments within the table are left out (lines 2, 3, 4 ...)"));
  EXPECT_EQ(of_text("% track_id\tt_s\tx_um\ty_um\n#1\t0\t0\t0\n#1\t60\t1\tNaN\n#1\t120\t2\t0\n", few()).positions(),
            2U);
  EXPECT_EQ(of_text("# track t_s x_um y_um\n1 0 0 0\n1 60 1 1\n", few()).positions(), 2U);
}

TEST(TrackIds, ThatMeanNoTrack) {
  const Tracks cells = of_text(plain_head + rows("-1", 2) + rows("1", 3) + rows("0", 3) + rows("-2.0", 1), few());
  EXPECT_EQ(cells.tracks.size(), 2U) << "0 is an id";
  EXPECT_TRUE(notes(cells, "3 positions in no track (id -1, -2) are left out"));
  for (const char* id : {"", "NaN", "none", "NULL", "\"\u22121\"", "-1.00", "<NA>"})
    EXPECT_EQ(of_text(plain_head + rows(id, 3) + rows("1", 3), few()).tracks.size(), 1U) << id;
  EXPECT_EQ(of_text(plain_head + rows("-a", 3), few()).tracks.size(), 1U) << "no number";
}

TEST(TrackIds, ObjectsOfIlastik) {
  TrackOptions options = few(calibrated(1.0, 60.0));
  for (const char* place : {"Center_of_the_object", "Object_Center", "Center of the object"}) {
    const Tracks cells = of_text(fmt::format("frame,labelimageId,trackId,lineageId,{0}_0,{0}_1\n0,1,2,2,0,0\n0,2,-1,-1,"
                                             "7,7\n1,1,2,2,3,4\n1,2,-1,-1,90,90\n",
                                             place),
                                 options);
    EXPECT_EQ(cells.layout, "ilastik");
    EXPECT_EQ(speed(cells), 300.0) << place;
  }
}

TEST(TrackHeaders, InTheMiddleAreNoRows) {
  const Tracks cells =
      of_text("movie," + plain_head + "a,1,0,0,0\na,1,60,1,0\nmovie," + plain_head + "b,1,0,5,5\nb,1,60,6,5\n", few());
  EXPECT_EQ(cells.tracks.size(), 2U);
  EXPECT_TRUE(notes(cells, "line 4 repeats the header: 2 files were joined"));
  const std::string trackmate = "TRACK_ID,POSITION_X,POSITION_Y,FRAME\nTrack ID,X,Y,Frame\n,(um),(um),\n";
  EXPECT_EQ(of_text(trackmate + "1,0,0,0\n1,1,1,1\n" + trackmate + "2,0,0,0\n2,1,1,1\n", few(calibrated(1.0, 60.0)))
                .positions(),
            4U);
}

TEST(TrackFooters, AreLeftOut) {
  const Tracks cells = of_text(plain_head + rows("1", 3) + "Mean,,1.0,0\nSD,,0.8,0\nexported in May\n", few());
  EXPECT_EQ(cells.positions(), 3U);
  EXPECT_TRUE(notes(cells, "3 lines below the table are left out (lines 5, 6, 7)"));
  EXPECT_EQ(faults(plain_head + rows("1", 3) + "1,240,1\n", few()), "f:5:1: has 3 fields, the header 4") << "cut short";
  EXPECT_EQ(faults(plain_head + rows("a", 3) + "a,240\n", few()), "f:5:1: has 2 fields, the header 4");
}

TEST(TrackFaults, OfOneKindAreCounted) {
  std::string text = plain_head;
  for (int k = 0; k < 600; ++k) text += fmt::format("{},0,\"?{}\",0\n", k, k);
  EXPECT_EQ(faults(text), "f:2:1: x_um: \"?0\" is no finite number (and 599 more)");
}

// Which columns of a table are taken for what.

TrackOptions with_columns(const std::string& columns, TrackOptions options = calibrated(1.0, 60.0)) {
  add_columns(columns, options.columns);

  return few(options);
}

const TrackOptions own_units = with_columns("");

std::string layout(const std::string& header, const std::string& row = "1,0,0,0\n1,1,1,1\n") {
  return of_text(header + "\n" + row, own_units).layout;
}

TEST(TrackTable, LayoutsByTheirNames) {
  EXPECT_EQ(layout("TRACK_ID,FRAME,POSITION_X,POSITION_Y"), "trackmate");
  EXPECT_EQ(layout("track,t,x,y"), "plain");
  EXPECT_EQ(layout("particle,frame,x,y"), "trackpy");
  EXPECT_EQ(layout("id,t,x,y"), "celltrackr");
  EXPECT_EQ(layout("track_id,t,y,x"), "napari");
  EXPECT_EQ(layout("Trajectory,Frame,x,y"), "mosaic");
  EXPECT_EQ(layout("TrackObjects_Label_50,ImageNumber,Location_Center_X,Location_Center_Y"), "cellprofiler");
  EXPECT_EQ(layout("TrackID,Time,Position X,Position Y"), "imaris");
  EXPECT_EQ(layout("Track number,Slice,X position,Y position"), "any");
  EXPECT_EQ(layout("Nr,TID,PID,x [pixel],y [pixel],t [frame]", "1,1,1,0,0,1\n2,1,2,1,1,2\n"), "mtrackj");
}

TEST(TrackTable, UnitsOfTheHeader) {
  TrackOptions own = own_units;
  own.pixel.reset();
  own.interval.reset();
  const Tracks cells = of_text("Track ID;Time [min];X [\u00b5m];Y [\u00b5m]\n1;0;0;0\n1;5;3;4\n", own);
  EXPECT_EQ(cells.interval, 300.0);
  EXPECT_EQ(speed(cells), 60.0);
  EXPECT_EQ(faults("track,t_s,x_um,y_px\n1,0,0,0\n1,1,1,1\n", own), "f: x_um is in um, y_px in px");
}

TEST(TrackTable, ColumnsWithAUnitBeforeThoseWithout) {
  TrackOptions own = own_units;
  own.pixel.reset();
  own.interval.reset();
  const Tracks cells = of_text("track_id,t,y,x,t_s,y_um,x_um\n1,0,9,7,0,0,0\n1,1,8,8,300,3,4\n", own);
  EXPECT_EQ(cells.columns.t, "t_s");
  EXPECT_EQ(speed(cells), 60.0);
}

TEST(TrackTable, ObjectsOfCellProfilerAreNotMixedUp) {
  const std::string header = "ImageNumber,Cells_Location_Center_X,Cells_Location_Center_Y,Nuclei_Location_Center_X,"
                             "Nuclei_Location_Center_Y,Nuclei_TrackObjects_Label_50\n";
  const Tracks cells = of_text(header + "1,9,9,0,0,1\n2,8,8,3,4,1\n", own_units);
  EXPECT_EQ(cells.layout, "cellprofiler");
  EXPECT_EQ(cells.columns.x, "Nuclei_Location_Center_X");
  EXPECT_EQ(cells.columns.y, "Nuclei_Location_Center_Y");
  EXPECT_EQ(cells.tracks[0].x.back(), 3.0);
}

TEST(TrackTable, LinesBeforeTheHeader) {
  EXPECT_EQ(layout("# my cells, 2024\ntrack,t,x,y"), "plain");
  EXPECT_EQ(layout("sep=,\ntrack,t,x,y"), "plain");
  EXPECT_EQ(layout("#track,t,x,y"), "plain");
  EXPECT_EQ(layout("Experiment;7\n\ntrack,t,x,y"), "plain");
}

TEST(TrackTable, NamesOfRowsAsRWritesThem) {
  EXPECT_EQ(of_text("id t x y\n\"1\" 1 0 0 0\n\"2\" 1 1 3 4\n", own_units).tracks[0].x.back(), 3.0);
  EXPECT_EQ(of_text("\"\",\"id\",\"t\",\"x\",\"y\"\n\"1\",1,0,0,0\n\"2\",1,1,3,4\n", own_units).tracks[0].x.back(),
            3.0);
}

TEST(TrackTable, ColumnsOfTheCaller) {
  const std::string own = "Zelle;Bild;Ort x [px];Ort y [px];dt\n1;0;0;0;7\n1;1;3;4;7\n";
  EXPECT_EQ(faults(own, own_units), "f:1:1: has no column for x, y that is known; its columns are Zelle, Bild, Ort x "
                                    "[px], Ort y [px], dt. Name them: {columns track=NAME,t=NAME,x=NAME,y=NAME}");
  const Tracks cells = of_text(own, with_columns("track=Zelle,frame=Bild,x=Ort x [px],y=ort Y [px]"));
  EXPECT_EQ(cells.layout, "named");
  EXPECT_EQ(speed(cells), 300.0);
  EXPECT_EQ(speed(of_text(own, with_columns("track=1,frame=2,x=3,y=4"))), 300.0) << "by their numbers";
  EXPECT_EQ(faults(own, with_columns("track=Zele,frame=Bild,x=Ort x [px],y=Ort y [px]")),
            "f:1:1: {columns}: there is no column \"Zele\"; did you mean Zelle?; the columns are Zelle, Bild, Ort x "
            "[px], Ort y "
            "[px], dt");
  // One of the names of the caller, the others of the layout.
  EXPECT_EQ(of_text("cell;frame;x;y;x0\n1;0;0;0;0\n1;1;9;9;3\n", with_columns("x=x0")).tracks[0].x.back(), 3.0);
}

TEST(TrackTable, OneLayoutAlone) {
  TrackOptions options = own_units;
  options.layout = "trackpy";
  EXPECT_EQ(faults("track,t,x,y\n1,0,0,0\n", options), "f:1:1: has no column for the track, the time that is known of "
                                                       "trackpy; its columns are track, t, x, y. Name them: "
                                                       "{columns track=NAME,t=NAME,x=NAME,y=NAME}");
}

TEST(TrackTable, TitlesInOtherLanguages) {
  for (const char* head : {"Zelle;Zeit [min];X [\u00b5m];Y [\u00b5m]",
                           "Spur;Zeit (Minuten);x-Position (Mikrometer);y-Position (Mikrometer)",
                           "Cellule;Temps (min);X (\u00b5m);Y (\u00b5m)",
                           "Piste;Temps [minutes];Position X [microm\u00e8tres];Position Y [microm\u00e8tres]",
                           "C\u00e9lula;Tiempo (min);Posici\u00f3n X (\u00b5m);Posici\u00f3n Y (\u00b5m)",
                           "Trayectoria;Tiempo [minutos];X [micras];Y [micras]"})
    EXPECT_DOUBLE_EQ(speed(of_text(std::string(head) + "\n1;0;0;0\n1;5;3;4\n", few())), 60.0) << head;
  EXPECT_DOUBLE_EQ(speed(of_text("Zelle,Bild,x_um,y_um\n1,0,0,0\n1,1,3,4\n", few(calibrated(1.0, 300.0)))), 60.0);
}

TEST(TrackTable, OtherTables) {
  EXPECT_NE(faults("frame,x0,y0,x1,y1\n0,1,1,2,2\n1,1,1,2,2\n", own_units).find("a pair of columns for each track"),
            std::string::npos);
  EXPECT_NE(
      faults("t,Cell 1 x,Cell 1 y,Cell 2 x,Cell 2 y\n0,1,1,2,2\n", own_units).find("a pair of columns for each track"),
      std::string::npos);
  EXPECT_NE(faults("1 0 5 0\n2 0 5 0\n", own_units).find("man_track.txt: label, begin, end, parent"),
            std::string::npos);
  EXPECT_NE(faults("1.5 0 5 0\n2 0 5 0\n", own_units).find("{columns track=1,t=2,x=3,y=4}"), std::string::npos);
  const std::string steps =
      "ImageNumber,TrackObjects_Label_15,TrackObjects_TrajectoryX_15,TrackObjects_TrajectoryY_15\n1,1,0,0\n2,1,3,4\n";
  EXPECT_NE(faults(steps, own_units).find("CellProfiler's table without Location_Center_X and _Y"), std::string::npos);
  EXPECT_EQ(
      faults(steps, with_columns("track=TrackObjects_Label_15,frame=ImageNumber,x=TrackObjects_TrajectoryX_15,y=4")),
      "f: TrackObjects_TrajectoryX_15 holds steps, and no positions\nf: TrackObjects_TrajectoryY_15 holds steps, and "
      "no positions");
  EXPECT_NE(faults("track,frame,x,y,dx,dy\n1,0,0,0,0,0\n1,1,1,1,1,1\n", with_columns("x=dx,y=dy")), "none");
}

TEST(TrackTable, OtherTablesOfTrackMate) {
  EXPECT_EQ(faults("LABEL,TRACK_INDEX,TRACK_ID,NUMBER_SPOTS,TRACK_DURATION\na,0,0,5,5\n", own_units),
            "f:1:1: is TrackMate's table of Tracks; export the table of Spots");
  EXPECT_EQ(faults("LABEL,TRACK_ID,SPOT_SOURCE_ID,SPOT_TARGET_ID,EDGE_TIME\na,0,0,1,5\n", own_units),
            "f:1:1: is TrackMate's table of Edges; export the table of Spots");
  EXPECT_EQ(faults("", own_units), "f: is empty");
  EXPECT_EQ(faults("track,t,x,y\n", own_units), "f: has a header, but no rows");
}

TEST(TrackTable, TrackMateTitlesAreNoRows) {
  const std::string head = "TRACK_ID,POSITION_X,POSITION_Y,FRAME\n";
  EXPECT_EQ(of_text(head + "Track ID,X,Y,Frame\nTrack ID,X,Y,Frame\n,(pixel),(pixel),\n0,0,0,0\n0,1,1,1\n", own_units)
                .positions(),
            2U);
  EXPECT_EQ(faults(head + "0,a,0,0\n0,1,1,1\n", own_units), "f:2:1: POSITION_X: \"a\" is no finite number")
      << "a bad row is no title";
}

} // namespace
} // namespace matrigrate::tracks
