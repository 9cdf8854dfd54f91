"""The tracks of a study in one table, against the columns that the code of its readers demands.

CellTracksColab, data type CellTracksColab: its loader demands TRACK_ID, POSITION_X, POSITION_Y, POSITION_T, and Condition,
experiment_nb and Repeat that are the same throughout a File_name; it keeps tracks of two spots or more by Unique_ID.
TrackMate's importer (trackmate-sc/TrackMate-CSVImporter) lets one choose the columns; it skips a line in which a place is no
number or frame, track or spot no integer, and one that begins with #.
CELLTRACKSCOLAB names a checkout of CellTracksColab: its code then reads the files as well. celltrackr_reads.R has celltrackR.
"""
import csv
import importlib
import math
import os
import sys
import types

folder = sys.argv[1] + "-study/export"
with open(f"{folder}/tracks_spots.csv", newline="") as text:
    spots = list(csv.DictReader(text))
with open(f"{folder}/tracks_tracks.csv", newline="") as text:
    tracks = {row["Unique_ID"]: row for row in csv.DictReader(text)}
assert len(tracks) == 4 and len({row["TRACK_ID"] for row in tracks.values()}) == 4
assert {row["Unique_ID"] for row in spots} == set(tracks)
for name, row in tracks.items():
    own = [spot for spot in spots if spot["Unique_ID"] == name]
    assert len(own) == int(row["NUMBER_SPOTS"]) > 2
    assert [int(spot["FRAME"]) for spot in own] == list(range(len(own)))
    times = [float(spot["POSITION_T"]) for spot in own]
    assert times == [12.0 * k for k in range(len(own))], times  # TrackMate takes frame times interval
    assert times == sorted(set(times)) and times[-1] == float(row["TRACK_STOP"])
    for key in ("TRACK_ID", "Condition", "experiment_nb", "Repeat", "File_name"):
        assert {spot[key] for spot in own} == {row[key]}, (name, key)
assert {row["Condition"] for row in tracks.values()} == {"soft, or so", "stiff: it's #2"}
assert len({row["File_name"] for row in tracks.values()}) == 4
assert len({int(spot["ID"]) for spot in spots}) == len(spots)
for spot in spots:
    assert all(math.isfinite(float(spot[key])) for key in ("POSITION_X", "POSITION_Y", "POSITION_Z", "RADIUS"))
    assert int(spot["TRACK_ID"]) >= 0 and not spot["Unique_ID"].startswith("#")
with open(f"{folder}/openvt.csv", newline="") as text:
    rows = list(csv.DictReader(text))
assert len(rows) == len(spots) and {row["simID"] for row in rows} == {"0", "1", "2", "3"}

if "CELLTRACKSCOLAB" in os.environ:
    for name, parts in {"tqdm": [], "tqdm.notebook": ["tqdm"], "requests": [], "ipywidgets": []}.items():
        module = sys.modules.setdefault(name, types.ModuleType(name))
        for part in parts:
            setattr(module, part, lambda items, **_: items)
    sys.path.insert(0, os.environ["CELLTRACKSCOLAB"])
    data = importlib.import_module("celltracks.data_loader").TrackingData()
    data.Folder_path, data.data_type = folder, "CellTracksColab"
    data.Spot_table, data.Track_table = "tracks_spots.csv", "tracks_tracks.csv"
    data.LoadTrackingData()
    assert len(data.spots_data) == len(spots) and len(data.tracks_data) == 4
    print("CellTracksColab has read it")
print(f"{len(spots)} positions of {len(tracks)} tracks")
