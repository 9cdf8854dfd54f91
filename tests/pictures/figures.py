"""Draws the figures of the Python package for viewer/tests/all_pictures.test.ts: figures.py RUN STUDY FOLDER"""
import os
import pathlib
import sys

os.environ["MPLBACKEND"] = "agg"
import matrigrate  # noqa: E402

run, study, to = matrigrate.load(sys.argv[1]), matrigrate.load_study(sys.argv[2]), pathlib.Path(sys.argv[3])
tracks = matrigrate.tracks.of(study, interval=60)
figures = {
    "frame": lambda: matrigrate.plot.frame(run, t=900),
    "frame-all": lambda: matrigrate.plot.frame(run, t=900, field="von_mises", window="all"),
    "path": lambda: matrigrate.plot.path(run),
    "msd": lambda: matrigrate.plot.msd(run),
    "boxes": lambda: matrigrate.plot.boxes(study, "v_migr_path_60s_um_per_h"),
    "paths-of-a-study": lambda: matrigrate.plot.path(study.runs),
    "measured-paths": lambda: matrigrate.plot.path(tracks, together=True),
    "measured-quality": lambda: matrigrate.plot.quality(tracks),
}
for name, draw in figures.items():
    drawn = draw()
    getattr(drawn, "figure", drawn).savefig(to / f"python-{name}.png", dpi=110)
