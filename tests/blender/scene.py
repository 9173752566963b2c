"""Run by Blender: builds a scene with lights, a camera, materials and vertex colours, and exports it as scene.glb, mesh.obj,
mesh.ply and mesh.stl. Writes the objects' names, triangle counts and world bounds (y up), and the eye, to known.json."""
import json
import math
import sys

import bpy

folder = sys.argv[sys.argv.index("--") + 1]
bpy.ops.wm.read_factory_settings(use_empty=True)


def y_up(v):
    return [v[0], v[2], -v[1]]


def material(name, color, metal, rough):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*color, 1)
    shader.inputs["Metallic"].default_value = metal
    shader.inputs["Roughness"].default_value = rough
    return made


def placed(name, color, metal, rough, smooth):
    o = bpy.context.active_object
    o.name = name
    o.data.materials.append(material(name + " surface", color, metal, rough))
    for polygon in o.data.polygons:
        polygon.use_smooth = smooth
    return o


bpy.ops.mesh.primitive_monkey_add(size=2, location=(0, 0, 1.2))
monkey = placed("Monkey", (0.8, 0.3, 0.2), 0, 0.4, True)
monkey.rotation_euler = (0, 0, math.radians(30))
colors = monkey.data.vertex_colors.new(name="Col")
for i, at in enumerate(colors.data):
    at.color = (i % 2, 0.5, 1, 1)
bpy.ops.mesh.primitive_cube_add(size=1, location=(2, 1, 0.5))
placed("Box", (0.9, 0.7, 0.3), 1, 0.3, False).scale = (1, 2, 1)
bpy.ops.mesh.primitive_uv_sphere_add(radius=0.6, location=(-2, 0, 0.6))
placed("Ball", (0.2, 0.4, 0.9), 0, 0.5, True)
bpy.ops.mesh.primitive_plane_add(size=10)
placed("Ground", (0.5, 0.5, 0.5), 0, 1, False)

for name, kind, place, energy in (("Sun", "SUN", (0, 0, 5), 2), ("Bulb", "POINT", (3, -3, 4), 400), ("Spot", "SPOT", (-3, -3, 5), 600)):
    data = bpy.data.lights.new(name, kind)
    data.energy = energy
    if kind == "SPOT":
        data.spot_size, data.spot_blend = math.radians(50), 0.2
    light = bpy.data.objects.new(name, data)
    light.location = place
    if kind == "SPOT":
        light.rotation_euler = (math.radians(40), 0, math.radians(-40))
    bpy.context.collection.objects.link(light)
camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
camera.location, camera.rotation_euler = (0, -9, 4), (math.radians(70), 0, 0)
bpy.context.collection.objects.link(camera)
bpy.context.scene.camera = camera
bpy.context.view_layer.update()

known = {"objects": {}, "eye": y_up(camera.location)}
for o in bpy.data.objects:
    if o.type != "MESH":
        continue
    o.data.calc_loop_triangles()
    corners = [y_up(o.matrix_world @ v.co) for v in o.data.vertices]
    known["objects"][o.name] = {"triangles": len(o.data.loop_triangles), "low": [min(c[k] for c in corners) for k in range(3)],
                                "high": [max(c[k] for c in corners) for k in range(3)]}
with open(folder + "/known.json", "w") as file:
    json.dump(known, file)
bpy.ops.export_scene.gltf(filepath=folder + "/scene.glb", export_lights=True, export_cameras=True, export_colors=True)
bpy.ops.wm.obj_export(filepath=folder + "/mesh.obj")
bpy.ops.export_mesh.ply(filepath=folder + "/mesh.ply", axis_forward="-Z", axis_up="Y")
bpy.ops.export_mesh.stl(filepath=folder + "/mesh.stl", axis_forward="-Z", axis_up="Y")
