#!/usr/bin/env python3
"""Opens every exported format with an independent reader and compares the numbers.

Usage:  pip install h5py ase MDAnalysis vtk numpy
        ./daphnis run shear-cell --until 2.5 --set output.snapshotEvery=50 --out /tmp/v
        for f in xyz vtp h5md cartandrad; do ./daphnis export /tmp/v --format $f; done
        ./daphnis export /tmp/v --format h5md --units si    # when the scenario has units, such as ring-patch
        python3 tools/verify-exports.py /tmp/v

Readers: h5py, MDAnalysis (H5MD); ASE (extended XYZ); VTK (.vtp, .pvd); NumPy (CartAndRad). Ends with a line an export.
"""
import pathlib
import sys
import warnings
import xml.etree.ElementTree

import h5py
import numpy as np

warnings.filterwarnings("ignore")
run = pathlib.Path(sys.argv[1])
export = run / "export"


def snapshot(path):
    with h5py.File(path) as f:
        group = f["particles/all"]
        return {
            "step": int(group["position/step"][0]),
            "time": float(group["position/time"][0]),
            "x": group["position/value"][0],
            "v": group["velocity/value"][0],
            "id": group["id"][:],
            "radius": group["radius"][:],
            "mass": group["mass"][:],
            "edges": group["box/edges/value"][0] if "edges" in group["box"] else None,
        }


frames = [snapshot(p) for p in sorted((run / "snapshots").glob("*.h5"))]
assert frames, "no snapshots"
n = len(frames[0]["id"])
print(f"snapshots      h5py {h5py.__version__}: {len(frames)} frames of {n} particles, steps {[f['step'] for f in frames]}")

with h5py.File(export / "trajectory.h5") as f:
    assert list(f["h5md"].attrs["version"]) == [1, 1] and len(f["h5md"].attrs) == 1
    assert f["h5md/creator"].attrs["name"] in ("daphnis", b"daphnis")
    value = f["particles/all/position/value"]
    assert value.shape == (len(frames), n, 3) and value.dtype == np.float64
    for t, frame in enumerate(frames):
        assert np.array_equal(value[t], frame["x"])
        assert np.array_equal(f["particles/all/velocity/value"][t], frame["v"])
    boundary = [b.decode() if isinstance(b, bytes) else b for b in f["particles/all/box"].attrs["boundary"]]
    assert all(b in ("periodic", "none") for b in boundary) and len(boundary) == 3
    assert int(f["particles/all/box"].attrs["dimension"]) == 3
    print(f"h5md           h5py: identical, boundary {boundary}, compression {value.compression}, chunks {value.chunks}")

si = export / "trajectory-si.h5"
if si.exists():
    with h5py.File(si) as f:
        assert f["h5md/modules/units"].attrs["system"] == b"SI"
        particles = f["particles/all"]
        for path, unit in (("position/value", b"m"), ("position/time", b"s"), ("velocity/value", b"m s-1"), ("mass", b"kg"), ("radius", b"m")):
            assert particles[path].attrs["unit"] == unit, path
        assert particles["position/value"].shape == (len(frames), n, 3)
    print("h5md, si       h5py: every dataset has its unit, by H5MD's module units 1.0")

import MDAnalysis  # noqa: E402

# Version 2.11 knows no metre and takes no text of fixed length, which the module units prescribes, for a unit: it refuses every file that
# names such units, and a file without units unless it is told not to convert them.

universe = MDAnalysis.Universe.empty(n, trajectory=True)
universe.load_new(str(export / "trajectory.h5"), format="H5MD", convert_units=False)
assert len(universe.trajectory) == len(frames)
for ts, frame in zip(universe.trajectory, frames):
    assert np.allclose(ts.positions, frame["x"], rtol=1e-6, atol=1e-6)
    assert np.allclose(ts.velocities, frame["v"], rtol=1e-6, atol=1e-6)
print(f"h5md           MDAnalysis {MDAnalysis.__version__}: {len(universe.trajectory)} frames, dimensions {universe.trajectory[0].dimensions}")

import ase  # noqa: E402
import ase.io  # noqa: E402

images = ase.io.read(export / "trajectory.xyz", index=":", format="extxyz")
assert len(images) == len(frames)
for atoms, frame in zip(images, frames):
    scale = atoms.info["Scale"]
    assert np.array_equal(atoms.positions, frame["x"] * scale)
    assert np.array_equal(atoms.arrays["velo"], frame["v"] * scale)
    assert np.array_equal(atoms.arrays["radius"], frame["radius"] * scale)
    assert np.array_equal(atoms.arrays["id"], frame["id"])
    assert atoms.info["Time"] == frame["time"]
    if frame["edges"] is not None:
        edges = frame["edges"] if frame["edges"].ndim == 2 else np.diag(frame["edges"])
        assert np.array_equal(atoms.cell.array, edges * scale)
print(f"extended XYZ   ASE {ase.__version__}: {len(images)} frames identical, pbc {images[0].pbc}, last cell {images[-1].cell.array.round(3).tolist()}")

from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonCore import vtkVersion  # noqa: E402
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader  # noqa: E402

index = xml.etree.ElementTree.parse(export / "trajectory.pvd").getroot()
datasets = index.findall("./Collection/DataSet")
assert [float(d.get("timestep")) for d in datasets] == [f["time"] for f in frames]
for dataset, frame in zip(datasets, frames):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(export / dataset.get("file")))
    reader.Update()
    data = reader.GetOutput()
    assert data.GetNumberOfPoints() == n and data.GetNumberOfVerts() == n
    assert np.array_equal(vtk_to_numpy(data.GetPoints().GetData()), frame["x"])
    for name, key in (("velocity", "v"), ("radius", "radius"), ("mass", "mass"), ("id", "id")):
        assert np.array_equal(vtk_to_numpy(data.GetPointData().GetArray(name)), frame[key]), name
    assert data.GetFieldData().GetArray("TimeValue").GetValue(0) == frame["time"]
print(f"VTP + PVD      VTK {vtkVersion.GetVTKVersion()}: {len(datasets)} files identical")

for frame in frames:
    raw = (export / f"CartAndRad.{frame['step']}.bin").read_bytes()
    count = int(np.frombuffer(raw, "<i4", 1)[0])
    table = np.frombuffer(raw, "<f8", 6 * count, 4).reshape(count, 6)
    radius = np.frombuffer(raw, "<f8", count, 4 + 48 * count)
    assert count == n and len(raw) == 4 + 56 * n
    assert np.array_equal(table, np.hstack([frame["x"], frame["v"]])) and np.array_equal(radius, frame["radius"])
print(f"CartAndRad     NumPy {np.__version__}: {len(frames)} files identical")
print("every export was read back identical")
