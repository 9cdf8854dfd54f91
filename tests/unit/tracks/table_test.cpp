#include "unit/tracks/reading.hpp"

#include <gtest/gtest.h>

/// Which columns of a table are taken for what.
namespace matrigrate::tracks {
namespace {

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
                                    "[px], Ort y [px], dt. Name them: --columns \"track=NAME,t=NAME,x=NAME,y=NAME\"");
  const Tracks cells = of_text(own, with_columns("track=Zelle,frame=Bild,x=Ort x [px],y=ort Y [px]"));
  EXPECT_EQ(cells.layout, "named");
  EXPECT_EQ(speed(cells), 300.0);
  EXPECT_EQ(speed(of_text(own, with_columns("track=1,frame=2,x=3,y=4"))), 300.0) << "by their numbers";
  EXPECT_EQ(faults(own, with_columns("track=Zele,frame=Bild,x=Ort x [px],y=Ort y [px]")),
            "f:1:1: --columns: there is no column \"Zele\"; did you mean Zelle?; the columns are Zelle, Bild, Ort x "
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
                                                       "--columns \"track=NAME,t=NAME,x=NAME,y=NAME\"");
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
  EXPECT_NE(faults("1.5 0 5 0\n2 0 5 0\n", own_units).find("--columns \"track=1,t=2,x=3,y=4\""), std::string::npos);
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
