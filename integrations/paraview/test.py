# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""test.py FILTER: tests the filter in pvpython or, without the modules of ParaView, with VTK alone."""

import importlib.util
import sys


def check_torus(skeleton):
    count = skeleton.GetNumberOfPoints()
    data = skeleton.GetPointData()
    radius, branch, node = (data.GetArray(name) for name in ("radius", "branch", "node"))
    assert count > 10 and skeleton.GetNumberOfLines() == 1, f"a torus has one closed branch, of {count} nodes"
    ids = skeleton.GetCell(0).GetPointIds()
    assert ids.GetId(0) == ids.GetId(ids.GetNumberOfIds() - 1), "it is closed"
    assert all(abs(radius.GetTuple1(i) - 1) < 0.1 for i in range(count)), "radius"
    assert all(branch.GetTuple1(i) == 0 and node.GetTuple1(i) == i for i in range(count)), "branch and node"


def test_vtk(plugin):
    from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
    from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource
    torus = vtkParametricTorus()
    torus.SetRingRadius(3)
    torus.SetCrossSectionRadius(1)
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(torus)
    spec = importlib.util.spec_from_file_location("cscd_skeleton", plugin)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    skeleton = module.CscdSkeleton()
    skeleton.SetInputConnection(source.GetOutputPort())
    skeleton.SetDetail(0.4)
    skeleton.Update()
    check_torus(skeleton.GetOutputDataObject(0))


def test_paraview(simple, plugin):
    import inspect
    if not hasattr(inspect, "getargspec"):  # ParaView before 5.11.1 loads no plugin in Python 3.11 without it
        inspect.getargspec = inspect.getfullargspec
    simple.LoadPlugin(plugin, remote=False, ns=globals())
    torus = simple.Superquadric(Toroidal=1, ThetaResolution=64, PhiResolution=64, Thickness=1 / 3, Size=4)
    skeleton = CSCDSkeleton(Input=torus, Detail=0.4, Seed=1)  # noqa: F821: of the plugin
    skeleton.UpdatePipeline()
    from paraview import servermanager
    check_torus(servermanager.Fetch(skeleton))


try:
    from paraview import simple
except ImportError:
    print("VTK alone")
    test_vtk(sys.argv[1])
else:
    print("ParaView")
    test_paraview(simple, sys.argv[1])
