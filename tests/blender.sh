#!/usr/bin/env bash
# Blender exports a scene as .glb, .obj, .ply and .stl; what Glint reads from them must match what Blender knows about the scene:
# tests/blender.sh GLINT
set -eu
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if ! blender --background --factory-startup --python-exit-code 1 --python "$here/blender/scene.py" -- "$folder" >"$folder/log" 2>&1; then
    cat "$folder/log"
    exit 1
fi
python3 "$here/blender/check.py" "$1" "$folder"
echo "passed: files exported by $(blender --version | head -1)"
