"""fields.xdmf in ParaView: each of its readers finds points, arrays and times; frames are rendered."""
import sys

from paraview.simple import *
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkIOImage import vtkPNGReader

folder = sys.argv[1]
times = [0.0, 36.0, 72.0, 108.0, 144.0, 180.0]
matrix = {"displacement": 3, "velocity": 3, "f_degr": 1, "pressure": 1, "von_mises": 1, "solid": 1}
adhesion = {"id": 1, "f_mat": 1, "force": 1}
outline = {"front": 1, "protrusion": 1, "phase": 1, "f_mat": 1, "curvature": 1, "actomyosin_force": 1}


def arrays(source):
    info = source.GetDataInformation().GetPointDataInformation()
    return {
        info.GetArrayInformation(k).GetName(): info.GetArrayInformation(k).GetNumberOfComponents()
        for k in range(info.GetNumberOfArrays())
    }


def check(source, wanted, name):
    assert list(source.TimestepValues) == times, (name, list(source.TimestepValues))
    source.UpdatePipeline(times[-1])
    found = arrays(source)
    assert wanted.items() <= found.items(), (name, found)
    info = source.GetDataInformation()
    bounds = info.GetBounds()
    assert bounds[1] - bounds[0] > (100 if "displacement" in wanted else 20 if "front" in wanted else -1), (name, bounds)
    print(f"{name}: {info.GetNumberOfPoints()} points, {len(times)} times, {sorted(found)}")
    return info.GetNumberOfPoints()


xdmf = f"{folder}/fields.xdmf"
every = {**matrix, **outline, **adhesion}
counts = {
    check(XDMFReader(FileNames=[xdmf]), every, "XDMF Reader"),
    check(Xdmf3ReaderS(FileName=[xdmf]), every, "Xdmf3 Reader S"),
    check(Xdmf3ReaderT(FileName=[xdmf]), every, "Xdmf3 Reader T"),
}
assert len(counts) == 1, counts
particles = XDMFReader(FileNames=[xdmf])

view = CreateRenderView(ViewSize=[800, 800], Background=[1, 1, 1], UseColorPaletteForBackground=0)
shown = Show(particles, view, Representation="Points", PointSize=6)
ColorBy(shown, ("POINTS", "displacement", "Magnitude"))
view.ViewTime = times[-1]
particles.UpdatePipeline(times[-1])
shown.RescaleTransferFunctionToDataRange(False)
shown.SetScalarBarVisibility(view, True)
legend = GetScalarBar(GetColorTransferFunction("displacement"), view)
legend.TitleColor = legend.LabelColor = [0, 0, 0]
colours = []
for t in (times[0], times[-1]):
    view.ViewTime = t
    ResetCamera(view)
    picture = f"{folder}/paraview_{t:.0f}s.png"
    SaveScreenshot(picture, view)
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    pixels = dataset_adapter.WrapDataObject(reader.GetOutput()).PointData[0]
    colours.append(pixels.copy())
    assert len({tuple(p) for p in pixels[::37]}) > 20, "a blank picture"
assert (colours[0] != colours[1]).any(), "nothing moves"
print("rendered", picture)
