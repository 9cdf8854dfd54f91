"""The tracks of a study in one table, against the columns that the code of its readers demands.

CellTracksColab, data type CellTracksColab: its loader demands TRACK_ID, POSITION_X, POSITION_Y, POSITION_T, and Condition,
experiment_nb and Repeat that are the same throughout a File_name; it keeps tracks of two spots or more by Unique_ID.
celltrackR: read.tracks.csv takes columns of any name for id, time and places. TrackMate's importer lets one choose them.
CELLTRACKSCOLAB and CELLTRACKR name checkouts of these projects: their code then reads the files as well.
"""
import csv
import importlib
import os
import subprocess
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
    assert times == sorted(set(times)) and times[-1] == float(row["TRACK_STOP"])
    for key in ("TRACK_ID", "Condition", "experiment_nb", "Repeat", "File_name"):
        assert {spot[key] for spot in own} == {row[key]}, (name, key)
assert {row["Condition"] for row in tracks.values()} == {"soft, or so", "stiff"}
assert len({row["File_name"] for row in tracks.values()}) == 4
assert len({spot["ID"] for spot in spots}) == len(spots)
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
if "CELLTRACKR" in os.environ:
    code = (
        "for (f in c('internal.R', 'data-structures.R', 'functions.R', 'track-measures.R'))\n"
        "  try(source(file.path(Sys.getenv('CELLTRACKR'), 'R', f)), silent = TRUE)\n"
        f"t <- read.tracks.csv('{folder}/tracks_spots.csv', id.column = 'Unique_ID', time.column = 'POSITION_T',\n"
        "  pos.columns = c('POSITION_X', 'POSITION_Y'), sep = ',')\n"
        f"stopifnot(inherits(t, 'tracks'), length(t) == 4, sum(sapply(t, nrow)) == {len(spots)}, all(is.finite(sapply(t, speed))))\n"
    )
    subprocess.run(["Rscript", "-e", code], check=True)
    print("celltrackR has read it")
print(f"{len(spots)} positions of {len(tracks)} tracks")
