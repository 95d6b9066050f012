# What Blender makes of a model: armature, hierarchy, weights, texture, clip `frames`.
#   blender --background --factory-startup --python-exit-code 1 --python THIS -- MODEL.glb
# The file's own JSON says what should come out. Exit status 1 where something is amiss.
import json
import struct
import sys

import bpy
import numpy
from mathutils import Quaternion

# Blender 3.4's importer names it; numpy 1.24, which Debian 12 puts beside it, has it no more.
if not hasattr(numpy, 'bool'):
    numpy.bool = bool

path = sys.argv[sys.argv.index('--') + 1]
with open(path, 'rb') as file:
    data = file.read()
gltf = json.loads(data[20:20 + struct.unpack('<I', data[12:16])[0]])
nodes, joints = gltf['nodes'], gltf['skins'][0]['joints']
parent = {nodes[c]['name']: n['name'] for n in nodes for c in n.get('children', [])}

bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=path)
armature = next(o for o in bpy.data.objects if o.type == 'ARMATURE')
mesh = next(o for o in bpy.data.objects if o.type == 'MESH' and o.vertex_groups)

bones = armature.data.bones
assert {b.name for b in bones} == {nodes[j]['name'] for j in joints}, 'bones by name'
for bone in bones:
    assert (bone.parent.name if bone.parent else None) == parent.get(bone.name), bone.name
assert any(a.name.startswith('frames') for a in bpy.data.actions), 'the clip frames'
textured = bool(gltf.get('images'))
assert (len(bpy.data.images) > 0) == textured, 'its texture'
if textured:
    image = next(i for i in bpy.data.images if i.size[0] > 0)
    assert len(mesh.data.uv_layers) == 1


def places():
    # The armature's modifier moves the vertices as a viewer would.
    bpy.context.view_layer.update()
    evaluated = mesh.evaluated_get(bpy.context.evaluated_depsgraph_get())
    return [evaluated.matrix_world @ v.co for v in evaluated.data.vertices]


def moved(a, b):
    return [(p - q).length for p, q in zip(a, b)]


scene = bpy.context.scene
armature.animation_data.action = next(
    a for a in bpy.data.actions if a.name.startswith('frames'))
keys = gltf['accessors'][next(a for a in gltf['animations'] if a['name'] == 'frames')
                         ['samplers'][0]['input']]['count']
scene.frame_set(0)
first = places()
if keys > 1:
    scene.frame_set(round(scene.render.fps / scene.render.fps_base))
    assert max(moved(first, places())) > 1e-3, 'the action plays'

# A bone turned alone moves the vertices bound to it and below it, and nothing else.
armature.animation_data.action = None
for bone in armature.pose.bones:
    bone.rotation_quaternion = Quaternion()
    bone.location = (0, 0, 0)
rest = places()
weight = {b.name: [0.0] * len(rest) for b in bones}
for v in mesh.data.vertices:
    for group in v.groups:
        weight[mesh.vertex_groups[group.group].name][v.index] = group.weight
tried = 0
for bone in armature.pose.bones:
    if bone.parent is None or max(weight[bone.name]) < 0.9:
        continue
    tried += 1
    below = [bone.name] + [b.name for b in bone.children_recursive]
    bone.rotation_mode = 'QUATERNION'
    bone.rotation_quaternion = Quaternion((1, 1, 1), 0.5)
    way = moved(rest, places())
    bone.rotation_quaternion = Quaternion()
    bound = [sum(weight[b][v] for b in below) for v in range(len(rest))]
    assert max(way) > 1e-3, bone.name + ' moves something'
    assert max([w for w, s in zip(way, bound) if s == 0], default=0) < 1e-5, bone.name
assert tried > 0 or len(joints) == 1, 'no bone to turn'
print(f'{path}: {len(bones)} bones, {len(rest)} vertices, {tried} bones turned, {keys} keys')
