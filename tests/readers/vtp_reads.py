"""The .vtp and .pvd files without ParaView: inline binary arrays are decoded and compared with fields.h5."""
import base64
import sys
import xml.etree.ElementTree as xml
import zlib

try:
    import h5py
    import numpy as np
except ImportError:
    sys.exit(77)

folder = sys.argv[1]
types = {"Float32": "<f4", "UInt8": "<u1", "UInt32": "<u4", "Int64": "<i8"}


def decoded(element):
    """Blocks, their size, that of a shorter last one, and their compressed sizes, all in base64; then the blocks, too."""
    text = element.text.strip()
    blocks = int(np.frombuffer(base64.b64decode(text[:16]), "<u4")[0])
    length = (4 * (3 + blocks) + 2) // 3 * 4
    head = np.frombuffer(base64.b64decode(text[:length]), "<u4")
    content = base64.b64decode(text[length:])
    raw = b""
    for size in head[3:]:
        raw += zlib.decompress(content[: int(size)])
        content = content[int(size) :]
    assert not content and len(raw) == int(head[1]) * blocks
    values = np.frombuffer(raw, types[element.get("type")])
    return values.reshape(-1, 3) if element.get("NumberOfComponents") == "3" else values


def piece(name):
    root = xml.parse(f"{folder}/export/{name}").getroot()
    assert root.get("header_type") == "UInt32" and root.get("byte_order") == "LittleEndian"
    assert root.get("compressor") == "vtkZLibDataCompressor"
    found = root.find("PolyData/Piece")
    assert all(array.get("format") == "binary" for array in found.iter("DataArray"))
    data = {array.get("Name"): decoded(array) for array in found.find("PointData")}
    points = decoded(found.find("Points/DataArray")) if int(found.get("NumberOfPoints")) else np.zeros((0, 3))
    assert len(points) == int(found.get("NumberOfPoints"))
    for kind, cells in (("Verts", found.get("NumberOfVerts")), ("Lines", found.get("NumberOfLines"))):
        if found.find(kind) is None or int(cells) == 0:
            continue
        connectivity, offsets = (decoded(array) for array in found.find(kind))
        assert len(offsets) == int(cells) and offsets[-1] == len(connectivity) and connectivity.max() == len(points) - 1
    return points, data


adhesions = 0
with h5py.File(f"{folder}/fields.h5") as file:
    times = file["time"][:]
    for name in ("matrix", "outline", "anchors"):
        listed = [(float(d.get("timestep")), d.get("file")) for d in xml.parse(f"{folder}/export/{name}.pvd").iter("DataSet")]
        assert listed == [(t, f"{name}_{k:04}.vtp") for k, t in enumerate(times)], listed
    for k in range(len(times)):
        for name in ("matrix", "outline"):
            points, data = piece(f"{name}_{k:04}.vtp")
            frame = file[f"frames/{k}/{name}"]
            assert np.array_equal(points, frame["position"][:])
            assert set(data) == set(frame) - {"position"}, (set(data), set(frame))
            for field, values in data.items():
                assert np.array_equal(values, frame[field][:]), (name, k, field)
        points, data = piece(f"anchors_{k:04}.vtp")
        rows = file["anchors/frame"][:] == k
        adhesions += len(points)
        assert np.array_equal(points, file["anchors/position"][:][rows])
        for field in ("id", "f_mat", "force"):
            assert np.array_equal(data[field], file[f"anchors/{field}"][:][rows]), (k, field)
assert adhesions > 0, "no protrusion adhered"
print(f"{len(times)} times, {adhesions} adhesions")
