#!/usr/bin/env python3
"""Writes the catalogue in docs/diagnose.md and its pictures: every mistake next to the correct picture.

usage: docs/make_museum.py [GLINT]      GLINT: the program; default build/release/app/glint

The texts come from `glint mistakes`, and the experiments come from `glint diagnose`. This script only chooses a scene in which
each mistake is visible.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

docs = Path(__file__).resolve().parent
glint = sys.argv[1] if len(sys.argv) > 1 else str(docs.parent / "build/release/app/glint")
room = "docs/museum.json"
size = "288x216"

# Changes to the room that make a mistake visible. Mistakes that are visible without a change are not listed.
sun_alone = {"/lights/1/enabled": False, "/lights/2/enabled": False}
ball = "/objects/1"
rough = {"/shading/reflection": "cook-torrance"}
averaged = {ball + "/normals/source": "vertex", "/objects/3/normals/source": "vertex"}
chevron = {ball + "/mesh": {"file": "museum-chevron.obj"}}
changes = {
    "light_direction_reversed": sun_alone,
    "direction_is_position": sun_alone,
    "falloff_of_directional": {"/lights/0/falloff": {"constant": 1, "linear": 0.3, "quadratic": 0.1}},
    "perspective_view_in_ortho": {"/camera/projection": {"type": "orthographic", "height": 4, "near": 0.1, "far": 50}},
    "power_zero_is_nan": {ball + "/material/shininess": 0},
    "bytes_wrap": {"/display/exposure": 2},
    "clamp_each_light": {"/lights/0/intensity": 2, "/display/exposure": 0.5},
    "cross_reversed": averaged,
    "cross_component_wrong": averaged,
    "last_facet_wins": averaged,
    "specular_without_cosine": rough,
    "fresnel_of_view_angle": rough,
    "alpha_not_squared": rough,
    "facet_normals_of_screen_points": {"/shading/mode": "facet"},
    "facet_normal_of_first_corners": {**chevron, "/shading/mode": "facet"},
    "normals_by_position_index": {ball + "/mesh": {"primitive": "cylinder"}},
    "interpolated_lengths": {"/objects/2/mesh/detail": 6},
    "zero_normal_is_nan": {**chevron, ball + "/normals/source": "file"},
    "specular_behind_surface": {"/lights/0/position": [-1, 0.3, -3, 0], "/lights/0/specular": [1, 1, 1],
                                ball + "/material/shininess": 3, "/objects/2/material/shininess": 3},
    "unnormalized_half": {"/shading/reflection": "blinn-phong", ball + "/material/shininess": 12},
    "half_angle_with_phong_shininess": {ball + "/material/shininess": 12, "/objects/2/material/shininess": 20},
    "ambient_per_light_added_twice": {"/lights/0/ambient": [0.12, 0.12, 0.12]},
    "flipped_by_view": {"/shading/two_sided": False},
    "interpolated_normals_not_normalized": {ball + "/mesh/detail": 8, "/objects/2/mesh/detail": 8},
    "reflect_sign": {ball + "/material/shininess": 8, "/objects/3/material/shininess": 8},
    "reflect_of_difference": {ball + "/material/shininess": 8, "/objects/3/material/shininess": 8},
    "view_reversed": {ball + "/material/shininess": 8, "/objects/3/material/shininess": 8},
}


def run(*arguments):
    return subprocess.run([glint, *arguments], check=True, capture_output=True, text=True, cwd=docs.parent).stdout


def options(settings):
    return [word for pointer, value in settings.items() for word in ("--set", f"{pointer}={json.dumps(value, separators=(',', ':'))}")]


def picture(name, settings):
    path = f"docs/pictures/museum/{name}.png"
    run("render", room, "-o", path, "--size", size, "--no-scene", *options(settings))
    return path


def mistaken(name):
    return {**changes.get(name, {}), f"/shading/mistakes/{name}": True}


def pictures(mistake):
    """Draws the picture with a mistake and the correct one, which is shared by all mistakes that do not change the room."""
    wrong = picture(mistake["name"], mistaken(mistake["name"]))
    changed = changes.get(mistake["name"], {})
    right = picture(mistake["name"] + "-right", changed) if changed else "docs/pictures/museum/right.png"
    return Path(right).relative_to("docs"), Path(wrong).relative_to("docs")


def apart(settings, names):
    """Describes the change to the room that distinguishes the first mistake from as many of the others as possible."""
    if len(names) < 2:
        return None
    answer = run("diagnose", room, *options(settings), "--apart", ",".join(names), "--format", "json")
    found = json.loads(answer)
    if found is None or found["shows"][0]["color"] in [s["color"] for s in found["shows"][1:]]:
        return apart(settings, names[:-1])
    shows = ", ".join(f"{tuple(s['color'])} with `{s['name']}`" for s in found["shows"])
    return f", add `--set {found['set'][0]}`: at 640x480, pixel {found['pixel'][0]},{found['pixel'][1]} is then {shows}."


def experiment(mistake):
    names = [mistake["name"], *mistake["look_alikes"][:3]]
    settings = changes.get(mistake["name"], {})
    found = apart(settings, names)
    if found:
        return "To distinguish them" + found
    other = {"/shading/reflection": "blinn-phong"}
    found = apart({**settings, **other}, names)
    return "Under `phong` they look the same. To distinguish them under `blinn-phong`" + found


def link(name):
    return f"[`{name}`](#{name})"


def entry(mistake):
    right, wrong = pictures(mistake)
    name = mistake["name"]
    settings = " ".join(f"--set '{word}'" for word in options(mistaken(name))[1::2])
    similar = ", ".join(map(link, mistake["look_alikes"]))
    lines = [f"### {name}", "",
             f"{mistake['does']} **{mistake['looks']}**", "",
             "| correct | with the mistake |", "|---|---|", f"| ![The room]({right}) | ![The room with {name}]({wrong}) |", "",
             f"`glint docs/museum.json {settings}`", ""]
    if similar:
        lines += [f"Looks like {similar}. {experiment(mistake)}", ""]
    return lines + [f"Reported in {'; '.join(mistake['sources'])}.", ""] if mistake["sources"] else lines


def museum():
    run("render", room, "-o", "docs/pictures/museum/right.png", "--size", size, "--no-scene")
    catalogue = json.loads(run("mistakes", "--format", "json"))["mistakes"]
    groups = dict.fromkeys(m["seen_as"] for m in catalogue)
    lines = []
    for group in groups:
        names = [m["name"] for m in catalogue if m["seen_as"] == group]
        lines.append(f"- **{group}**: " + ", ".join(f"[{name}](#{name})" for name in names))
    lines.append("")
    for group in groups:
        lines += [f"## {group}", ""]
        for mistake in catalogue:
            if mistake["seen_as"] == group:
                lines += entry(mistake)
    return "\n".join(lines)


if __name__ == "__main__":
    (docs / "pictures/museum").mkdir(exist_ok=True)
    page = docs / "diagnose.md"
    marker = "<!-- make_museum.py writes everything below -->\n"
    page.write_text(page.read_text().split(marker)[0] + marker + "\n" + museum())
