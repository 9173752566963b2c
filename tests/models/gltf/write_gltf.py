"""Writes glTF files from the specification, with numpy and json and without any of Glint's code: a box of 12 triangles
with normals, below two nested nodes; a camera with a lamp on it; a sun and a spot. Arguments: the folder, then variants."""
import base64
import json
import struct
import sys

import numpy as np

folder, how = sys.argv[1], set(sys.argv[2:])

corners, normals, triangles = [], [], []
for axis in range(3):
    for side in (-1, 1):
        first = len(corners)
        for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            p = np.zeros(3)
            p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = side, a, b
            corners.append(p)
            normals.append(side * np.eye(3)[axis])
        quad = (0, 1, 2, 0, 2, 3) if side > 0 else (0, 2, 1, 0, 3, 2)
        triangles += [first + i for i in quad]
corners, normals = np.array(corners, "<f4"), np.array(normals, "<f4")
index_types = {"bytes": ("u1", 5121), "shorts": ("<u2", 5123), "ints": ("<u4", 5125)}
kind, number = index_types[next((k for k in index_types if k in how), "shorts")]
indices = np.array(triangles, kind)

views, accessors, data = [], [], b""


def view(raw, stride=None):
    global data
    data += b"\0" * (-len(data) % 4)
    views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(raw)})
    if stride:
        views[-1]["byteStride"] = stride
    data += raw
    return len(views) - 1


def accessor(at, count, component, shape, **more):
    accessors.append({"bufferView": at, "componentType": component, "count": count, "type": shape, **more})
    return len(accessors) - 1


if "interleaved" in how:
    both = view(np.hstack([corners, normals]).astype("<f4").tobytes(), 24)
    place = accessor(both, 24, 5126, "VEC3")
    normal = accessor(both, 24, 5126, "VEC3", byteOffset=12)
else:
    place = accessor(view(corners.tobytes()), 24, 5126, "VEC3")
    if "small" in how:  # KHR_mesh_quantization: normals as normalized bytes, four bytes apart
        small = np.hstack([127 * normals, np.zeros((24, 1))]).astype("i1")
        normal = accessor(view(small.tobytes(), 4), 24, 5120, "VEC3", normalized=True)
    else:
        normal = accessor(view(normals.tobytes()), 24, 5126, "VEC3")
index = accessor(view(indices.tobytes()), len(indices), number, "SCALAR")
primitive = {"attributes": {"POSITION": place, "NORMAL": normal}, "indices": index, "material": 0}
if "strip" in how:  # a strip and a fan of the same square: two primitives
    square = accessor(view(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], "<f4").tobytes()), 4, 5126, "VEC3")
    around = accessor(view(np.array([0, 1, 3, 2], "u1").tobytes()), 4, 5121, "SCALAR")
    primitives = [{"attributes": {"POSITION": square}, "mode": 5},
                  {"attributes": {"POSITION": square}, "indices": around, "mode": 6},
                  {"attributes": {"POSITION": square}, "mode": 0}]
else:
    primitives = [primitive]

half = np.sqrt(0.5)
model = {
    "asset": {"version": "2.0", "generator": "numpy"},
    "extensionsUsed": ["KHR_lights_punctual"],
    "scene": 0,
    "scenes": [{"nodes": [0, 2, 4, 5]}],
    "nodes": [
        # A node that rotates by 90 degrees about y and moves by 2 in x; its child is scaled by 2 and
        # moved by 1 along the rotated x axis.
        {"name": "turned", "translation": [2, 0, 0], "rotation": [0, half, 0, half], "children": [1]},
        {"name": "box", "mesh": 0, "matrix": [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 1, 0, 0, 1]},
        {"name": "eye", "camera": 0, "translation": [0, 1, 10], "children": [3]},
        {"name": "headlamp", "extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [0, 0.5, 0]},
        {"name": "sun", "extensions": {"KHR_lights_punctual": {"light": 1}}},
        # Looks down: -z becomes -y.
        {"name": "spot", "extensions": {"KHR_lights_punctual": {"light": 2}}, "translation": [0, 5, 0],
         "rotation": [-half, 0, 0, half]},
    ],
    "cameras": [{"type": "perspective", "perspective": {"yfov": np.pi / 3, "znear": 0.5, "zfar": 50}}],
    "meshes": [{"name": "a box", "primitives": primitives}],
    "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 1], "metallicFactor": 0.25,
                                            "roughnessFactor": 0.375}, "emissiveFactor": [0, 0.125, 0]}],
    "extensions": {"KHR_lights_punctual": {"lights": [
        {"type": "point", "color": [1, 0.5, 0], "intensity": np.pi * 40},
        {"type": "directional", "intensity": np.pi},
        {"type": "spot", "intensity": np.pi * 8,
         "spot": {"innerConeAngle": np.pi / 6, "outerConeAngle": np.pi / 6 + 1e-5}}]}},
    "accessors": accessors,
    "bufferViews": views,
    "buffers": [{"byteLength": len(data)}],
}
if "small" in how:
    model["extensionsUsed"].append("KHR_mesh_quantization")
if "left" in how:
    model["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    model["materials"][0]["alphaMode"] = "BLEND"
    model["textures"], model["images"] = [{"source": 0}], [{"uri": "nowhere.png"}]
    model["animations"] = [{"channels": [], "samplers": []}] * 2
    model["cameras"] *= 2
    model["nodes"].append({"camera": 1})
    model["scenes"][0]["nodes"].append(6)

if "glb" in how:
    text = json.dumps(model).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    whole = struct.pack("<I4sI", len(text), b"JSON", 0)[:8] + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    open(folder + "/box.glb", "wb").write(struct.pack("<4sII", b"glTF", 2, 12 + len(whole)) + whole)
else:
    if "external" in how:
        open(folder + "/box data.bin", "wb").write(data)
        model["buffers"][0]["uri"] = "box%20data.bin"
    else:
        model["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    open(folder + "/box.gltf", "w").write(json.dumps(model))
