"""Compares what Glint reads from Blender's files with what Blender knows about its scene: check.py GLINT FOLDER."""
import json
import subprocess
import sys

glint, folder = sys.argv[1:]
failed = False


def expect(what, found, wanted, tolerance=1e-4):
    global failed
    near = found == wanted if tolerance is None else all(abs(a - b) <= tolerance for a, b in zip(found, wanted, strict=True))
    if not near:
        print(f"failed: {what}: {found}; expected {wanted}")
        failed = True


def info(name):
    return json.loads(subprocess.run([glint, "info", f"{folder}/{name}"], capture_output=True, text=True, check=True).stdout)


with open(folder + "/known.json") as file:
    known = json.load(file)
objects = known["objects"]
scene = info("scene.glb")
expect("objects in the .glb", {o["name"]: o["mesh"]["triangles"] for o in scene["objects"]},
       {name: o["triangles"] for name, o in objects.items()}, None)
expect("lights in the .glb", scene["lights"], 3, None)
expect("eye in the .glb", [row[3] for row in scene["matrices"]["world_from_view"][:3]], known["eye"])
low = [min(o["low"][k] for o in objects.values()) for k in range(3)]
high = [max(o["high"][k] for o in objects.values()) for k in range(3)]
for name in ("mesh.obj", "mesh.ply", "mesh.stl"):
    mesh = info(name)
    expect("triangles in " + name, mesh["triangles"] + 2 * mesh["quads"], sum(o["triangles"] for o in objects.values()), None)
    expect("low corner of " + name, mesh["bounds"]["min"], low)
    expect("high corner of " + name, mesh["bounds"]["max"], high)
# The ball is lit by the sun from above: in the picture its top is brighter than its bottom, and more blue than red.
subprocess.run([glint, "render", folder + "/scene.glb", "-o", folder + "/picture.png", "--size", "480x300"], check=True, stderr=subprocess.DEVNULL)
top, bottom = (json.loads(subprocess.run([glint, "explain", folder + "/scene.glb", "--size", "480x300", "--pixel", pixel, "--format", "json"],
                                         capture_output=True, text=True, check=True).stdout) for pixel in ("85,125", "85,195"))
expect("object at the ball", [top["object"], bottom["object"]], ["Ball", "Ball"], None)
if not (top["sum"][2] > bottom["sum"][2] and top["sum"][2] > top["sum"][0]):
    print(f"failed: the ball: {top['sum']} at its top, {bottom['sum']} at its bottom")
    failed = True
sys.exit(failed)
