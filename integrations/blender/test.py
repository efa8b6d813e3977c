# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""blender --background --factory-startup --python test.py -- ZIP ELEPHANT: installs the add-on, and tests it."""

import sys

import bpy

ZIP, ELEPHANT = sys.argv[sys.argv.index("--") + 1 :]


def activate(mesh):
    bpy.context.view_layer.objects.active = mesh
    return mesh


def elephant():
    with open(ELEPHANT, encoding="ascii") as file:
        numbers = file.read().split()[1:]
    n, m = map(int, numbers[:2])
    vertices = [tuple(map(float, numbers[3 + 3 * i : 6 + 3 * i])) for i in range(n)]
    faces = [tuple(map(int, numbers[4 + 3 * n + 4 * i : 7 + 3 * n + 4 * i])) for i in range(m)]
    mesh = bpy.data.meshes.new("elephant")
    mesh.from_pydata(vertices, [], faces)
    result = bpy.data.objects.new("elephant", mesh)
    bpy.context.scene.collection.objects.link(result)
    return activate(result)


def test_curve():
    bpy.ops.mesh.primitive_torus_add(major_radius=3, minor_radius=1, location=(5, 0, 0))
    assert bpy.ops.object.cscd_curve() == {"FINISHED"}, "curve of a torus"
    curve = bpy.context.object
    (spline,) = curve.data.splines
    assert spline.use_cyclic_u and curve.data.bevel_depth == 1, "one closed spline"
    assert all(abs(point.radius - 1) < 0.1 for point in spline.points), "radii of the bevel are those of the tube"
    width, depth, height = curve.dimensions
    assert abs(width - 8) < 0.4 and abs(height - 2) < 0.2 and curve.location.x == 5, "it is where the torus is"
    elephant()
    bpy.ops.object.cscd_curve()
    detailed = len(bpy.context.object.data.splines)
    activate(bpy.data.objects["elephant"])
    bpy.ops.object.cscd_curve(detail=0)
    plain = len(bpy.context.object.data.splines)
    assert detailed > plain > 0, f"branches of an elephant: {detailed}, {plain} at detail 0"


def test_armature():
    mesh = activate(bpy.data.objects["elephant"])
    mesh.location = (0, 0, 7)
    bpy.context.view_layer.update()
    before = [mesh.matrix_world @ vertex.co for vertex in mesh.data.vertices]
    assert bpy.ops.object.cscd_armature() == {"FINISHED"}, "armature of an elephant"
    armature = bpy.context.object
    bones = armature.data.bones
    sums = [sum(group.weight for group in vertex.groups) for vertex in mesh.data.vertices]
    assert len(bones) >= 10 and all(bone.length > 0 for bone in bones), f"{len(bones)} bones"
    assert max(abs(total - 1) for total in sums) < 1e-5, "weights of each vertex sum to 1"
    assert {group.name for group in mesh.vertex_groups} <= set(bones.keys()), "groups have the names of bones"

    def moved():
        bpy.context.view_layer.update()
        shape = mesh.evaluated_get(bpy.context.evaluated_depsgraph_get())
        return [(shape.matrix_world @ vertex.co - old).length for vertex, old in zip(shape.data.vertices, before)]

    assert max(moved()) < 1e-5, "the mesh stays where it was"
    last = next(bone for bone in armature.pose.bones if not bone.children)
    last.rotation_mode = "XYZ"
    last.rotation_euler.x = 1
    distances = moved()
    assert max(distances) > 0.01 and sorted(distances)[len(distances) // 2] < 1e-5, "a bone moves its limb alone"


def test_faults():
    bpy.ops.mesh.primitive_plane_add()
    bpy.context.object.data.clear_geometry()
    for operator in (bpy.ops.object.cscd_curve, bpy.ops.object.cscd_armature):
        try:
            operator()
            assert False, "an empty mesh is refused"
        except RuntimeError as error:
            assert str(error).startswith("Error: "), f"refused: {error}".strip()


bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
bpy.ops.preferences.addon_install(filepath=ZIP)
bpy.ops.preferences.addon_enable(module="cscd_blender")
test_curve()
test_armature()
test_faults()
