# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender add-on: the curve skeleton of a mesh as a curve object, or as an armature with weights."""

import array
import json
import pathlib
import tempfile

import bpy
import mathutils

from .skeleton_files import SkeletonError, skeletonize_file

bl_info = {
    "name": "CSCD curve skeletons",
    "author": "The CSCD developers",
    "version": (0, 3, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > CSCD",
    "description": "Turns a mesh into its curve skeleton: a curve with radii, or an armature with weights",
    "category": "Rigging",
}


def write_off(mesh, filename):
    """Writes vertices and polygons, in the space of the object."""
    lines = [f"OFF\n{len(mesh.vertices)} {len(mesh.polygons)} 0"]
    lines += [" ".join(map(repr, vertex.co)) for vertex in mesh.vertices]
    lines += [" ".join(map(str, (len(face.vertices), *face.vertices))) for face in mesh.polygons]
    filename.write_text("\n".join(lines) + "\n", encoding="ascii")


def skeletonize_object(source, ending, options):
    """The content of the skeleton file with this ending."""
    with tempfile.TemporaryDirectory() as folder:
        mesh, skeleton = pathlib.Path(folder) / "mesh.off", pathlib.Path(folder) / ("skeleton" + ending)
        write_off(source.data, mesh)
        addon = bpy.context.preferences.addons.get(__package__)
        program = bpy.path.abspath(addon.preferences.program) if addon else ""
        skeletonize_file(mesh, [skeleton], program, **options)
        return skeleton.read_bytes()


def place(new, source, context):
    """Puts the object `new` where `source` is, and makes it active."""
    (source.users_collection or [context.scene.collection])[0].objects.link(new)
    new.matrix_world = source.matrix_world
    for other in context.selected_objects:
        other.select_set(False)
    new.select_set(True)
    context.view_layer.objects.active = new


def make_curve(source, context, options):
    """A curve object with a spline for each branch; the bevel has the radii of the body."""
    document = json.loads(skeletonize_object(source, ".json", options))
    curve = bpy.data.curves.new(source.name + " skeleton", "CURVE")
    curve.dimensions = "3D"
    curve.bevel_depth = 1  # times the radius of each point
    curve.use_fill_caps = True
    for branch in document["branches"]:
        nodes = branch["nodes"]
        spline = curve.splines.new("POLY")
        spline.use_cyclic_u = branch["ends"][0] == "closed"
        if spline.use_cyclic_u and nodes[0] == nodes[-1]:
            nodes = nodes[:-1]
        spline.points.add(len(nodes) - 1)
        for point, node in zip(spline.points, nodes):
            point.co = (*document["nodes"][node]["point"], 1)
            point.radius = document["nodes"][node]["radius"]
    result = bpy.data.objects.new(curve.name, curve)
    place(result, source, context)
    return result


class Rig:
    """A rig in binary glTF: names, heads, parents of joints; positions, joints and weights of vertices."""

    def __init__(self, content):
        size = int.from_bytes(content[12:16], "little")
        self._document = json.loads(content[20 : 20 + size])
        self._binary = content[28 + size :]
        nodes = self._document["nodes"]
        joints = self._document["skins"][0]["joints"]
        number_of = {node: number for number, node in enumerate(joints)}
        self.names = [nodes[node]["name"] for node in joints]
        self.children = [[number_of[child] for child in nodes[node].get("children", [])] for node in joints]
        self.parents = [None] * len(joints)
        self.heads = [mathutils.Vector(nodes[node].get("translation", (0, 0, 0))) for node in joints]
        for joint, children in enumerate(self.children):  # parents come first
            for child in children:
                self.parents[child] = joint
                self.heads[child] += self.heads[joint]
        attributes = self._document["meshes"][0]["primitives"][0]["attributes"]
        self.positions = self._rows(attributes["POSITION"])
        self.size = max(map(max, self.positions)) - min(map(min, self.positions))
        self.influences = [
            [(joint, weight) for joint, weight in zip(*row) if weight > 0]
            for row in zip(self._rows(attributes["JOINTS_0"]), self._rows(attributes["WEIGHTS_0"]))
        ]

    def _rows(self, number):
        accessor = self._document["accessors"][number]
        values = array.array({5121: "B", 5123: "H", 5126: "f"}[accessor["componentType"]])
        width = {"VEC3": 3, "VEC4": 4}[accessor["type"]]
        begin = self._document["bufferViews"][accessor["bufferView"]]["byteOffset"]
        values.frombytes(self._binary[begin : begin + accessor["count"] * width * values.itemsize])
        return list(zip(*[iter(values)] * width))

    def tail(self, joint):
        """The end of the bone of a joint: its farthest child; without children, any place near its head."""
        head = self.heads[joint]
        places = [self.heads[child] for child in self.children[joint] if self.heads[child] != head]
        beside = head + mathutils.Vector((0, 0, self.size / 20))
        return max(places, key=lambda place: (place - head).length, default=beside)


def make_bones(armature, rig):
    """Adds a bone for each joint that moves vertices, or that others depend on. The armature is in edit mode."""
    moving = {joint for row in rig.influences for joint, _ in row}
    bones = {}
    for joint, name in enumerate(rig.names):
        if joint not in moving and not rig.children[joint]:
            continue  # the end of a limb: the tail of the bone before
        bone = bones[joint] = armature.edit_bones.new(name)
        bone.head, bone.tail = rig.heads[joint], rig.tail(joint)
        bone.parent = bones.get(rig.parents[joint])
        bone.use_connect = bone.parent is not None and bone.parent.tail == bone.head


def assign_weights(source, rig):
    """Adds a vertex group for each joint. Repairs merge vertices, but never move one: places identify them."""
    tree = mathutils.kdtree.KDTree(len(rig.positions))
    for number, position in enumerate(rig.positions):
        tree.insert(position, number)
    tree.balance()
    groups = {}
    for vertex in source.data.vertices:
        for joint, weight in rig.influences[tree.find(vertex.co)[1]]:
            if joint not in groups:
                groups[joint] = source.vertex_groups.new(name=rig.names[joint])
            groups[joint].add([vertex.index], weight, "REPLACE")


def make_armature(source, context, options):
    """An armature that moves `source`, with the weights of CSCD."""
    rig = Rig(skeletonize_object(source, ".glb", options))
    result = bpy.data.objects.new(source.name + " armature", bpy.data.armatures.new(source.name + " armature"))
    place(result, source, context)
    context.view_layer.update()
    bpy.ops.object.mode_set(mode="EDIT")
    make_bones(result.data, rig)
    bpy.ops.object.mode_set(mode="OBJECT")
    assign_weights(source, rig)
    source.modifiers.new("Armature", "ARMATURE").object = result
    source.parent = result
    source.matrix_parent_inverse = source.matrix_basis.inverted()
    return result


class SkeletonOperator:
    """The common part of both operators."""

    bl_options = {"REGISTER", "UNDO"}
    detail: bpy.props.FloatProperty(
        name="Detail", description="How small a limb may be to get a branch", default=0.5, min=0, max=1
    )
    seed: bpy.props.IntProperty(name="Seed", description="Of the random choice of sources", default=0, min=0)

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT" and context.object is not None and context.object.type == "MESH"

    def execute(self, context):
        try:
            self.make(context.object, context, {"detail": self.detail, "seed": self.seed})
        except SkeletonError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class OBJECT_OT_cscd_curve(SkeletonOperator, bpy.types.Operator):
    """Make a curve with radii from the skeleton of the active mesh"""

    bl_idname = "object.cscd_curve"
    bl_label = "Skeleton as Curve"
    make = staticmethod(make_curve)


class OBJECT_OT_cscd_armature(SkeletonOperator, bpy.types.Operator):
    """Make an armature with weights from the skeleton of the active mesh"""

    bl_idname = "object.cscd_armature"
    bl_label = "Skeleton as Armature"
    make = staticmethod(make_armature)


class VIEW3D_PT_cscd(bpy.types.Panel):
    bl_label = "Curve Skeleton"
    bl_category = "CSCD"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"

    def draw(self, _context):
        self.layout.operator(OBJECT_OT_cscd_curve.bl_idname, icon="CURVE_DATA")
        self.layout.operator(OBJECT_OT_cscd_armature.bl_idname, icon="ARMATURE_DATA")


class CscdPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__
    program: bpy.props.StringProperty(
        name="Program cscd", description="Empty: the Python module, or the program on the path", subtype="FILE_PATH"
    )

    def draw(self, _context):
        self.layout.prop(self, "program")


register, unregister = bpy.utils.register_classes_factory(
    (OBJECT_OT_cscd_curve, OBJECT_OT_cscd_armature, VIEW3D_PT_cscd, CscdPreferences)
)
