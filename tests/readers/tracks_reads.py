"""Exported tracks against the columns that celltrackR and TrackMate document, and against tracks.csv.

celltrackR, read.tracks.csv(file, sep = ",", pos.columns = 3:4): track, time and two coordinates, in this order, under a
line of names; its defaults are blanks between columns, and three coordinates.
TrackMate, spots as CSV: named columns, among them ID, TRACK_ID, POSITION_X, POSITION_Y, POSITION_T, FRAME; two lines of
titles and one of units. Its importer leaves these out, and takes FRAME times the interval of an open picture for the time.
TrackMate, "Export tracks to XML file": Tracks(nTracks, spaceUnits, frameInterval, timeUnits, from) of
particle(nSpots) of detection(t, x, y, z), with t the number of the frame.
"""
import csv
import sys
import xml.etree.ElementTree as xml

folder = sys.argv[1]


def table(name):
    with open(f"{folder}/{name}", newline="") as text:
        return list(csv.DictReader(text))


def same(a, b):
    return abs(float(a) - float(b)) < 1e-9


ours = table("tracks.csv")
assert len(ours) == 16, len(ours)

for row, written in zip(ours, table("export/tracks_celltrackr.csv"), strict=True):
    assert list(written) == ["id", "t_s", "x_um", "y_um"]
    assert written["id"] == "1" and all(same(written[key], row[key]) for key in ("t_s", "x_um", "y_um"))

*titles, units = table("export/tracks_trackmate.csv")[:3]
assert len(titles) == 2 and units["POSITION_X"] == "(micron)" and units["POSITION_T"] == "(sec)", units
for k, (row, spot) in enumerate(zip(ours, table("export/tracks_trackmate.csv")[3:], strict=True)):
    assert {"ID", "TRACK_ID", "POSITION_X", "POSITION_Y", "POSITION_Z", "POSITION_T", "FRAME", "RADIUS"} == set(spot)
    assert int(spot["ID"]) == k and int(spot["FRAME"]) == k and spot["TRACK_ID"] == "0"
    assert same(spot["POSITION_X"], row["x_um"]) and same(spot["POSITION_Y"], row["y_um"]) and float(spot["POSITION_Z"]) == 0
    assert same(spot["POSITION_T"], row["t_s"]) and same(12 * k, row["t_s"]) and float(spot["RADIUS"]) > 0

root = xml.parse(f"{folder}/export/tracks_trackmate.xml").getroot()
assert root.tag == "Tracks" and int(root.get("nTracks")) == len(root) == 1
assert root.get("spaceUnits") and root.get("timeUnits") == "s" and root.get("from")
interval = float(root.get("frameInterval"))
for particle in root:
    assert particle.tag == "particle" and int(particle.get("nSpots")) == len(particle) == len(ours)
    for row, spot in zip(ours, particle, strict=True):
        assert spot.tag == "detection" and set(spot.keys()) == {"t", "x", "y", "z"}
        assert same(int(spot.get("t")) * interval, row["t_s"])
        assert same(spot.get("x"), row["x_um"]) and same(spot.get("y"), row["y_um"])
print(f"{len(ours)} positions in three formats")
