"""Files of tracks in the layouts of other programs, made of four cells whose speeds are known.

In the unit of the file, cell k (from 0) makes seven steps of 0.5 (k + 1), along (3, 4), (4, -3), (5, 0) and such, so that
its positions are exact in a few digits: 1.25 a picture on average over cells, 37.5 um/h if the unit is um and pictures come
every 120 s. `layouts` is the manifest: each file, what the reader is told, and what it must find or say.

The layouts are those that these programs document or write:
TrackMate (spots as CSV with four lines of head; "Export tracks to XML file"; before its version 7 "Spots in tracks
statistics", by tabs), trackpy (a table of pandas), celltrackR (text by blanks or commas), Manual Tracking and MTrackJ of
ImageJ, the particle tracker of MOSAIC, CellProfiler (ExportToSpreadsheet), Imaris ("Position", four lines of head), btrack
(export to CSV, by blanks, all columns as numbers), napari (numpy.savetxt, pandas, ultrack), CellTracksColab (merged spots).
"""
from __future__ import annotations

import zipfile
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from io import BytesIO
from typing import Any, NamedTuple

cells, pictures = 4, 8
_steps = [(3, 4), (4, -3), (5, 0), (-3, 4), (0, 5), (4, 3), (3, -4)]
speed = 37.5  #: [um/h] of one unit a um, 120 s
of_pixels = 0.65 * speed


class Spot(NamedTuple):
    """A position: cell and picture from 0; tenths of the unit of the file."""

    cell: int
    frame: int
    x10: int
    y10: int

    @property
    def x(self) -> str:
        return f"{self.x10 / 10:.1f}"

    @property
    def y(self) -> str:
        return f"{self.y10 / 10:.1f}"


def spots(by_frame: bool = False) -> list[Spot]:
    """All positions, by cell or by picture."""
    found = []
    for cell in range(cells):
        x, y = 1000 + 300 * cell, 700 + 200 * cell
        for frame in range(pictures):
            found.append(Spot(cell, frame, x, y))
            if frame < len(_steps):
                x, y = x + _steps[frame][0] * (cell + 1), y + _steps[frame][1] * (cell + 1)
    return sorted(found, key=lambda spot: spot.frame) if by_frame else found


def table(head: str, row: Callable[[Spot], str], of: Iterable[Spot] | None = None, tail: str = "") -> str:
    return "".join([head, "\n" if head else "", *(row(spot) + "\n" for spot in of or spots()), tail])


# TrackMate ------------------------------------------------------------------------------------------------------------

def trackmate(length: str, time: str, per_frame: float, of: Iterable[Spot] | None = None, tail: str = "") -> str:
    """Spots of TrackMate 7 with its four lines of head, some columns that the reader does not need among them."""
    head = ("LABEL,ID,TRACK_ID,QUALITY,POSITION_X,POSITION_Y,POSITION_Z,POSITION_T,FRAME,RADIUS,VISIBILITY,"
            "MANUAL_SPOT_COLOR,MEAN_INTENSITY_CH1\n"
            "Label,Spot ID,Track ID,Quality,X,Y,Z,T,Frame,Radius,Visibility,Manual spot color,Mean intensity ch1\n"
            "Label,Spot ID,Track ID,Quality,X,Y,Z,T,Frame,R,Visibility,Spot color,Mean ch1\n"
            f",,,(quality),{length},{length},{length},{time},,{length},,,(counts)")
    return table(head, lambda s: f"ID{s.frame}{s.cell},{s.frame}{s.cell},{s.cell},12.4,{s.x},{s.y},0.0,"
                 f"{s.frame * per_frame},{s.frame},5.0,1,,135.8", of, tail)


def divided() -> str:
    """Cell 3 has two positions from picture 5 on."""
    return trackmate("(micron)", "(sec)", 120.0, tail="".join(
        f"ID9{frame},9{frame},3,12.4,{300 + frame}.5,20.5,0.0,{frame * 120.0},{frame},5.0,1,,135.8\n" for frame in (5, 6, 7)))


def trackmate_xml(length: str, step: str, time: str) -> str:
    body = "".join(f'  <particle nSpots="{pictures}">\n' + "".join(
        f'    <detection t="{s.frame}" x="{s.x}" y="{s.y}" z="0.0" />\n' for s in spots() if s.cell == cell)
        + "  </particle>\n" for cell in range(cells))
    return ('<?xml version="1.0" encoding="UTF-8"?>\n'
            f'<Tracks nTracks="{cells}" spaceUnits="{length}" frameInterval="{step}" timeUnits="{time}" '
            f'generationDateTime="Tue, 16 Apr 2024 18:36:11" from="TrackMate v7.12.1">\n{body}</Tracks>\n')


# The others -----------------------------------------------------------------------------------------------------------

def manual_tracking(separator: str) -> str:
    """The results of ImageJ's Manual Tracking: whole pixels, pictures from 1, a nameless first column."""
    head = separator.join([" ", "Track n\u00b0", "Slice n\u00b0", "X", "Y", "Distance", "Velocity", "Pixel Value"])
    return table(head, lambda s: separator.join(map(str, [
        s.cell * pictures + s.frame + 1, s.cell + 1, s.frame + 1, s.x10, s.y10, "-1", "-1", "120"])))


def mtrackj() -> str:
    """MTrackJ's data file: tracks 1 and 2 in each of two clusters; Point ID x y z t c."""
    text = "MTrackJ 1.5.1 Data File\nDisplaying true true true 1 2 0 4 100 10 0 0 0 2 1 12 0 true true true false\nAssembly 1 FF0000\n"
    for spot in spots():
        if spot.frame == 0:
            text += "" if spot.cell % 2 else f"Cluster {spot.cell // 2 + 1} FF0000\n"
            text += f"Track {spot.cell % 2 + 1} FF0000 true\n"
        text += f"Point {spot.frame + 1} {spot.x} {spot.y} 1.0 {spot.frame + 1}.0 1.0\n"
    return text + "End of MTrackJ Data File\n"


def imaris(separator: str = ",", comma: bool = False) -> str:
    """Imaris's statistics "Position": an empty line, a title, a rule, a head that ends with a separator; Time is the number of
    the picture, from 1."""
    def number(text: str) -> str:
        return text.replace(".", ",") if comma else text

    names = ["Position X", "Position Y", "Position Z", "Unit", "Category", "Collection", "Time", "TrackID", "ID", ""]
    return "\nPosition\n==================== \n" + table(separator.join(names), lambda s: separator.join([
        number(s.x), number(s.y), number("1.0"), "um", "Spot", "Position", str(s.frame + 1), f"{1000000000 + s.cell}",
        f"{s.frame * cells + s.cell}", ""]), spots(by_frame=True))


def cellprofiler(prefix: str = "") -> str:
    """CellProfiler's table of objects: one that is in no track has no label."""
    columns = ["AreaShape_Area", "AreaShape_Center_X", "AreaShape_Center_Y", "Location_Center_X", "Location_Center_Y",
               "Location_Center_Z", "Number_Object_Number", "TrackObjects_Displacement_50", "TrackObjects_Label_50",
               "TrackObjects_Lifetime_50", "TrackObjects_ParentImageNumber_50", "TrackObjects_ParentObjectNumber_50"]
    head = ",".join(["ImageNumber", "ObjectNumber", *(prefix + column for column in columns)])
    return table(head, lambda s: f"{s.frame + 1},{s.cell + 1},310,{s.x},{s.y},{s.x},{s.y},0,{s.cell + 1},1.5,{s.cell + 1},"
                 f"{s.frame + 1},{s.frame},{s.cell + 1}", spots(by_frame=True), "3,5,12,1.0,1.0,1.0,1.0,0,5,nan,nan,nan,0,0\n")


def btrack(separator: str, made_up: str, seen: str) -> str:
    """btrack puts positions on a straight line where it did not see the cell, and marks them as dummies: here pictures 3 and 4
    of cell 1, far off."""
    def row(s: Spot) -> str:
        dummy = s.cell == 1 and s.frame in (3, 4)
        x = str(float(s.x) + 100.0) if dummy else s.x
        return separator.join([str(s.cell + 1), str(s.frame), x, s.y, "0.0", str(s.cell + 1), str(s.cell + 1),
                               "5" if dummy else "0", "0", made_up if dummy else seen])
    return table(separator.join("ID t x y z parent root state generation dummy".split()), row)


def colab() -> str:
    """CellTracksColab's merged spots of two movies: TRACK_ID counts anew in each."""
    def row(s: Spot) -> str:
        movie, track = f"gel_movie{s.cell // 2 + 1}", s.cell % 2
        return f"ID,{track},{s.x},{s.y},0.0,{s.frame * 120.0},{s.frame},{movie}.csv,gel,1,1,{movie}.csv_{track}"
    return table("LABEL,TRACK_ID,POSITION_X,POSITION_Y,POSITION_Z,POSITION_T,FRAME,File_name,Condition,experiment_nb,Repeat,"
                 "Unique_ID", row)


def plain(of: Iterable[Spot] | None = None) -> str:
    return table("track,t_s,x_um,y_um", lambda s: f"{s.cell},{s.frame * 120},{s.x},{s.y}", of)


def excel(separator: str, names: str = "Track ID;Time [min];X [\u00b5m];Y [\u00b5m]") -> str:
    """As a spreadsheet saves it in Belgium, Germany or France."""
    return table(names.replace(";", separator), lambda s: separator.join(
        [str(s.cell), str(2 * s.frame), s.x.replace(".", ","), s.y.replace(".", ",")]))


def jittered(share: float) -> str:
    """Time stamps before and after the whole intervals by turns, but for the first and the last."""
    def off(frame: int) -> float:
        return share * (-1) ** frame if 0 < frame < pictures - 1 else 0.0
    return table("track,t_s,x_um,y_um", lambda s: f"{s.cell},{120.0 * (s.frame + off(s.frame)):.3f},{s.x},{s.y}")


def gaps(word: str) -> str:
    """Pictures 3 and 4 of cell 1 have no position."""
    return table("track,t_s,x_um,y_um", lambda s: f"{s.cell},{s.frame * 120}," + (
        f"{word},{word}" if s.cell == 1 and s.frame in (3, 4) else f"{s.x},{s.y}"))


def workbook() -> bytes:
    whole = BytesIO()
    with zipfile.ZipFile(whole, "w") as parts:
        parts.writestr("xl/worksheets/sheet1.xml", "<worksheet/>")
    return whole.getvalue()


# The manifest ---------------------------------------------------------------------------------------------------------

@dataclass(frozen=True)
class Layout:
    """A file, what the reader is told (the arguments of `matrigrate.tracks.read`), and what it must find, or say if it
    refuses the file."""

    file: str
    content: str | bytes
    told: dict[str, Any] = field(default_factory=dict)
    speed: float = speed
    tracks: int = cells
    positions: int = cells * pictures
    missing: int = 0
    interval: float = 120.0
    refused: str = ""  #: an expression that one line of the message matches
    said: str = ""  #: an expression that a note matches
    encoding: str = "utf-8"

    @property
    def bytes(self) -> bytes:
        return self.content if isinstance(self.content, bytes) else self.content.encode(self.encoding)


_px = {"pixel": 0.65, "interval": 120}
_um = {"pixel": 1, "time_unit": "s"}
_here = {"speed": of_pixels}
_gap = {"positions": cells * pictures - 2, "missing": 2}
_whole = {"speed": 10 * of_pixels}
_by_track = "track,t_s,x_um,y_um"

layouts = [
    # TrackMate
    Layout("spots_calibrated.csv", trackmate("(micron)", "(sec)", 120.0)),
    Layout("spots_micro.csv", trackmate("(\u00b5m)", "(min)", 2.0)),
    Layout("spots_windows.csv", trackmate("(\u00b5m)", "(sec)", 120.0), encoding="cp1252"),
    Layout("spots_utf16.csv", trackmate("(\u00b5m)", "(sec)", 120.0), encoding="utf-16"),
    Layout("spots_pixels.csv", trackmate("(pixel)", "(frame)", 1.0), _px, **_here),
    Layout("spots_pixels_untold.csv", trackmate("(pixels)", "(frames)", 1.0), refused="pixel.*--pixel"),
    Layout("spots_uncalibrated.csv", trackmate("(pixel)", "(sec)", 1.0), _px, **_here),
    Layout("spots_loose.csv", trackmate("(micron)", "(sec)", 120.0, tail="ID999,999,,1.0,5.0,5.0,0.0,0.0,0,5.0,1,,1.0\n"),
           said="1 position"),
    Layout("spots_divided.csv", divided(), refused="--splits"),
    Layout("spots_divided_left_out.csv", divided(), {"splits": "drop"}, speed=30.0, tracks=3, positions=24, said="1 "),
    Layout("spots_divided_cut.csv", divided(), {"splits": "cut"}, positions=29, said="1 "),
    Layout("spots_one_head.csv", table("ID,TRACK_ID,POSITION_X,POSITION_Y,POSITION_T,FRAME", lambda s:
           f"{s.frame},{s.cell},{s.x},{s.y},{s.frame * 120.0},{s.frame}"), _um),
    Layout("spots_one_head_frames.csv", table("ID,TRACK_ID,POSITION_X,POSITION_Y,POSITION_T,FRAME", lambda s:
           f"{s.frame},{s.cell},{s.x},{s.y},{s.frame * 120.0},{s.frame}"), {"pixel": 1, "interval": 120}),
    Layout("spots_one_head_wrong.csv", table("ID,TRACK_ID,POSITION_X,POSITION_Y,POSITION_T,FRAME", lambda s:
           f"{s.frame},{s.cell},{s.x},{s.y},{s.frame * 120.0},{s.frame}"), {"pixel": 1, "interval": 1}, refused="120"),
    Layout("spots_old.txt", table(" \tLabel\tID\tTRACK_ID\tQUALITY\tPOSITION_X\tPOSITION_Y\tPOSITION_Z\tPOSITION_T\tFRAME", lambda s:
           f"{s.frame}\tID{s.frame}\t{s.frame}\t{s.cell}\t1\t{s.x}\t{s.y}\t0\t{s.frame * 120}\t{s.frame}"), _um),
    Layout("tracks.xml", trackmate_xml("micron", "2.0", "min")),
    Layout("tracks_uncalibrated.xml", trackmate_xml("pixel", "1.0", "sec"), _px, **_here),
    Layout("tracks_frames.xml", trackmate_xml("pixels", "1.0", "frame"), _px, **_here),
    Layout("session.xml", '<?xml version="1.0" encoding="UTF-8"?>\n<TrackMate version="7.12.1"><Model/></TrackMate>\n',
           refused="Export tracks to XML"),
    Layout("track_table.csv", "LABEL,TRACK_INDEX,TRACK_ID,NUMBER_SPOTS,TRACK_DURATION,TRACK_X_LOCATION,TRACK_Y_LOCATION\n"
           "Track_0,0,0,8,840.0,1.0,2.0\n", refused="[Ss]pots"),
    Layout("edge_table.csv", "LABEL,TRACK_ID,SPOT_SOURCE_ID,SPOT_TARGET_ID,LINK_COST,SPEED,EDGE_TIME,EDGE_X_LOCATION,"
           "EDGE_Y_LOCATION\nE1,0,1,2,0.1,0.2,0.5,1,2\n", refused="[Ss]pots"),
    # trackpy
    Layout("trackpy.csv", table(",y,x,mass,size,ecc,signal,raw_mass,ep,frame,particle", lambda s:
           f"{s.frame},{s.y},{s.x},300.1,2.5,0.1,14.2,900.0,0.05,{s.frame},{s.cell}.0", spots(True)), _px, **_here),
    Layout("trackpy_index.csv", table("frame,y,x,mass,frame,particle", lambda s:
           f"{s.frame},{s.y},{s.x},300.1,{s.frame},{s.cell}"), _px, **_here),
    # celltrackR
    Layout("celltrackr.csv", table('"","id","t","x","y"', lambda s:
           f'"{s.cell * pictures + s.frame + 1}","{s.cell}",{s.frame * 120},{s.x},{s.y}'), _um),
    Layout("celltrackr_as_frames.csv", table("id,t,x,y", lambda s: f"{s.cell},{s.frame * 120},{s.x},{s.y}"),
           {"pixel": 1, "interval": 24}, refused="120|time.unit"),
    Layout("celltrackr_blanks.txt", table("id t x y", lambda s: f"{s.cell} {s.frame * 120} {s.x} {s.y}"), _um),
    Layout("celltrackr_no_head.txt", table("", lambda s: f"{s.frame + 1} {s.cell} {s.frame * 120} {s.x} {s.y} -60.1"),
           {**_um, "columns": {"track": "2", "t": "3", "x": "4", "y": "5"}}),
    Layout("celltrackr_no_head_untold.txt", table("", lambda s: f"{s.frame + 1} {s.cell} {s.frame * 120} {s.x} {s.y} -60.1"),
           _um, refused="columns"),
    # ImageJ
    Layout("manual_tracking.xls", manual_tracking("\t"), _px, encoding="cp1252", **_whole),
    Layout("manual_tracking_mac.xls", manual_tracking("\t").replace("\n", "\r"), _px, encoding="mac_roman", **_whole),
    Layout("manual_tracking.csv", manual_tracking(","), _px, **_whole),
    Layout("mtrackj.mdf", mtrackj(), _px, **_here),
    Layout("mtrackj_points.csv", table("Nr,TID,PID,x [pixel],y [pixel],t [frame],I [val],Len [pixel],D2S [pixel]", lambda s:
           f"{s.frame + 1},{s.cell + 1},{s.frame + 1},{s.x},{s.y},{s.frame + 1},120,0,0"), _px, **_here),
    Layout("mtrackj_points_calibrated.csv", table("Nr,TID,PID,x [\u00b5m],y [\u00b5m],t [sec],I [val]", lambda s:
           f"{s.frame + 1},{s.cell + 1},{s.frame + 1},{s.x},{s.y},{s.frame * 120},120")),
    # MOSAIC
    Layout("mosaic.csv", table(",Trajectory,Frame,x,y,z,m0,m1,m2,m3,m4,NPscore", lambda s:
           f"{s.frame + 1},{s.cell + 1},{s.frame},{s.x},{s.y},0,4.2,2.1,5.3,15.3,48.2,9.4"), _px, **_here),
    Layout("mosaic.txt", table("Trajectory\tFrame\tx\ty\tz\tm0", lambda s:
           f"{s.cell + 1}\t{s.frame}\t{s.x}\t{s.y}\t0\t1.0"), _px, **_here),
    # CellProfiler
    Layout("cellprofiler.csv", cellprofiler(), _px, **_here, said="1 position"),
    Layout("cellprofiler_prefix.csv", cellprofiler("Nuclei_"), _px, **_here, said="1 position"),
    # Imaris
    Layout("imaris_Position.csv", imaris(), {"interval": 120}),
    Layout("imaris_german.csv", imaris(";", comma=True), {"interval": 120}),
    # btrack
    Layout("btrack.csv", btrack(" ", "1.0", "0.0"), _px, **_here, **_gap, said="2 "),
    Layout("btrack_pandas.csv", btrack(",", "True", "False"), _px, **_here, **_gap, said="2 "),
    # napari
    Layout("napari_savetxt.csv", table("# track_id,t,y,x", lambda s: f"{s.cell}.0,{s.frame}.0,{s.y},{s.x}"), _px, **_here),
    Layout("napari_pandas.csv", table(",track_id,t,y,x", lambda s: f"{s.frame},{s.cell},{s.frame},{s.y},{s.x}"), _px, **_here),
    Layout("ultrack.csv", table("track_id,t,y,x,id,parent_track_id,parent_id", lambda s:
           f"{s.cell + 1},{s.frame},{s.y},{s.x},{s.frame * 1000 + s.cell},-1,-1"), _px, **_here),
    # matrigrate.truth
    Layout("pixels_and_um.csv", table("track_id,t,y,x,t_s,y_um,x_um", lambda s:
           f"{s.cell},{s.frame},{s.y10},{s.x10},{s.frame * 120},{s.y},{s.x}")),
    # CellTracksColab
    Layout("merged_Spots.csv", colab(), _um),
    # Any table
    Layout("plain.csv", plain()),
    Layout("byte_order_mark.csv", plain(), encoding="utf-8-sig"),
    Layout("carriage_returns.csv", plain().replace("\n", "\r")),
    Layout("windows_lines.csv", plain().replace("\n", "\r\n")),
    Layout("comment.csv", "# gel A, 12 March\n" + plain()),
    Layout("separator_line.csv", "sep=,\n" + plain()),
    Layout("title.csv", "Cells in gel A\n\n" + plain()),
    Layout("semicolons_commas.csv", excel(";")),
    Layout("tabs_commas.txt", excel("\t")),
    Layout("tabs_commas_windows.txt", excel("\t"), encoding="cp1252"),
    Layout("unicode_text.txt", excel("\t").replace("\n", "\r\n"), encoding="utf-16"),
    Layout("big_endian.txt", "\ufeff" + excel("\t"), encoding="utf-16-be"),
    Layout("blanks.txt", plain().replace(",", "   ")),
    Layout("own_names.csv", table("Zelle;Bild;Ost;Nord", lambda s: f"{s.cell};{s.frame};{s.x};{s.y}"),
           {**_px, "columns": {"track": "Zelle", "frame": "Bild", "x": "Ost", "y": "Nord"}}, **_here),
    Layout("own_names_untold.csv", table("Zelle;Bild;Ost;Nord", lambda s: f"{s.cell};{s.frame};{s.x};{s.y}"), _px,
           refused="columns"),
    Layout("nan_in_gap.csv", gaps("NaN"), **_gap),
    Layout("nothing_in_gap.csv", gaps(""), **_gap),
    Layout("quoted.csv", table('"track","t_s","x_um","y_um"', lambda s: f'"cell {s.cell}, left","{s.frame * 120}","{s.x}","{s.y}"')),
    Layout("jitter.csv", jittered(0.013), said="time"),
    Layout("large_jitter.csv", jittered(0.1), refused="jitter"),
    Layout("misnamed.csv", plain(), {"columns": {"track": "cell"}}, refused="no column \"cell\""),
    Layout("mixed_signs.csv", excel(";").replace("100,0;70,0", "100.0;70.0"), refused="comma.*point"),
    Layout("workbook.xlsx", workbook(), refused="CSV"),
    Layout("empty.csv", "", refused="is empty"),
]
