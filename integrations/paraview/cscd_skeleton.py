# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter `CSCD Skeleton` for ParaView, and for VTK alone: a surface or points in, its curve skeleton out."""

import pathlib
import sys
import tempfile

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkIdList, vtkIntArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

try:
    from paraview.util.vtkAlgorithm import smdomain, smproperty, smproxy
except ImportError:  # VTK alone: decorators that do nothing

    class Undecorated:
        def __getattr__(self, _name):
            return lambda *_arguments, **_options: lambda decorated: decorated

    smdomain = smproperty = smproxy = Undecorated()

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from skeleton_files import skeletonize_file  # noqa: E402


SEAM = 1e-6  # relative to the diagonal: points nearer than this are the same, as along the seams of sources of VTK


def to_triangles(data):
    """The triangles of `data`, or its points if it has no faces, without data arrays."""
    shape = vtkPolyData()
    shape.CopyStructure(data)
    if shape.GetNumberOfPolys() + shape.GetNumberOfStrips() == 0:
        return shape
    triangles, clean = vtkTriangleFilter(), vtkCleanPolyData()
    triangles.SetInputData(shape)
    triangles.PassLinesOff()
    triangles.PassVertsOff()
    clean.SetInputConnection(triangles.GetOutputPort())
    clean.SetTolerance(SEAM)
    clean.Update()
    return clean.GetOutput()


def number_nodes(skeleton):
    """Adds to the points their numbers and their branches; of a junction, that of its first branch."""
    node, branch = vtkIntArray(), vtkIntArray()
    for array, name in ((node, "node"), (branch, "branch")):
        array.SetName(name)
        array.SetNumberOfValues(skeleton.GetNumberOfPoints())
    for point in range(skeleton.GetNumberOfPoints()):
        node.SetValue(point, point)
        branch.SetValue(point, -1)
    points = vtkIdList()
    branches = skeleton.GetCellData().GetArray("BranchId")
    for cell in range(skeleton.GetNumberOfCells()):
        skeleton.GetCellPoints(cell, points)
        for i in range(points.GetNumberOfIds()):
            if branch.GetValue(points.GetId(i)) == -1:
                branch.SetValue(points.GetId(i), int(branches.GetTuple1(cell)))
    skeleton.GetPointData().AddArray(node)
    skeleton.GetPointData().AddArray(branch)


@smproxy.filter(label="CSCD Skeleton")
@smproperty.input(name="Input")
@smdomain.datatype(dataTypes=["vtkPolyData"], composite_data_supported=False)
class CscdSkeleton(VTKPythonAlgorithmBase):
    """Lines are branches. Point data: radius, branch, node; cell data: as in files of the ending .vtp."""

    def __init__(self):
        super().__init__(nInputPorts=1, nOutputPorts=1, inputType="vtkPolyData", outputType="vtkPolyData")
        self._detail, self._seed = 0.5, 0

    @smproperty.doublevector(name="Detail", default_values=0.5)
    @smdomain.doublerange(min=0, max=1)
    def SetDetail(self, detail):
        """How small a limb may be to get a branch: 0 none, 1 every bump."""
        self._detail = detail
        self.Modified()

    @smproperty.intvector(name="Seed", default_values=0)
    @smdomain.intrange(min=0, max=1000)
    def SetSeed(self, seed):
        """Of the random choice of sources."""
        self._seed = seed
        self.Modified()

    def RequestData(self, _request, inputs, outputs):
        with tempfile.TemporaryDirectory() as folder:
            surface, result = str(pathlib.Path(folder) / "surface.vtp"), str(pathlib.Path(folder) / "skeleton.vtp")
            writer = vtkXMLPolyDataWriter()
            writer.SetFileName(surface)
            writer.SetInputData(to_triangles(vtkPolyData.GetData(inputs[0])))
            writer.SetCompressorTypeToNone()
            writer.Write()
            skeletonize_file(surface, [result], detail=self._detail, seed=self._seed)
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(result)
            reader.Update()
        skeleton = reader.GetOutput()
        skeleton.GetPointData().GetArray("Radius").SetName("radius")
        skeleton.GetPointData().RemoveArray("MaximumInscribedSphereRadius")
        number_nodes(skeleton)
        vtkPolyData.GetData(outputs).ShallowCopy(skeleton)
        return 1
