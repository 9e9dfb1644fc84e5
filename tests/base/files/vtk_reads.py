"""Opens the field files of a run folder with VTK's own reader and checks counts, values and times.

usage: vtk_reads.py FOLDER   (as test_vtkhdf_sample wrote it)
"""
import json
import os
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader
import numpy as np

NX, NY, NZ, POINTS = 6, 4, 5, 37


def series(folder, name):
    with open(os.path.join(folder, "fields", name)) as f:
        listing = json.load(f)
    assert listing["file-series-version"] == "1.0"
    return [(os.path.join(folder, "fields", e["name"]), e["time"]) for e in listing["files"]]


def read(path):
    reader = vtkHDFReader()
    assert reader.CanReadFile(path), path
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def array(data, name):
    a = data.GetPointData().GetArray(name)
    assert a is not None, name
    return vtk_to_numpy(a)


def check_fluid(path, step):
    data = read(path)
    assert data.GetClassName() == "vtkImageData", data.GetClassName()
    assert data.GetDimensions() == (NX, NY, NZ)
    assert np.allclose(data.GetOrigin(), (0.05, 0.1, 0.15)) and np.allclose(data.GetSpacing(), (0.1, 0.2, 0.3))
    k, j, i = np.meshgrid(range(NZ), range(NY), range(NX), indexing="ij")
    velocity = np.stack([i.ravel() + step, 10 * j.ravel(), -100 * k.ravel()], axis=1)
    assert np.array_equal(array(data, "velocity"), velocity)
    assert np.array_equal(array(data, "pressure"), (i + 10 * j + 100 * k).ravel())


def check_solid(path, step):
    data = read(path)
    g = np.arange(POINTS)
    assert data.GetClassName() == "vtkUnstructuredGrid", data.GetClassName()
    assert data.GetNumberOfPoints() == POINTS and data.GetNumberOfCells() == POINTS
    for cell in range(POINTS):
        assert data.GetCellType(cell) == 1  # VTK_VERTEX
        assert data.GetCell(cell).GetPointId(0) == cell
    assert np.array_equal(vtk_to_numpy(data.GetPoints().GetData()), g[:, None] + 0.25 * np.arange(3))
    assert np.array_equal(array(data, "id"), g)
    assert np.array_equal(array(data, "body"), g % 2)
    assert np.array_equal(array(data, "damage"), (g + step) / 64)
    assert np.array_equal(array(data, "stress"), 8 * g[:, None] + np.arange(6))


def main(folder):
    for name, check in (("fluid.hdf.series", check_fluid), ("solid.hdf.series", check_solid)):
        files = series(folder, name)
        assert [time for _, time in files] == [0.0, 0.125, 0.25], files
        for k, (path, _) in enumerate(files):
            check(path, 10 * k)
    print("VTK read 3 fluid and 3 solid files")


main(sys.argv[1])
