#!/usr/bin/env bash
# webgl.sh GLINT: checks that `glint diagnose` finds no mistake in the pages that `glint code --language webgl` writes,
# as drawn by Chromium.
set -u
glint=$1
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
for scene in still-life spot-cone area-light cool-to-warm bulb-over-facets mach-bands rough-to-smooth chalk-and-glaze; do
    file=assets/scenes/$scene.json
    "$glint" code "$file" --language webgl --size 320x240 -o "$folder/$scene" || exit 1
    # An additional script adds the picture's bytes to the page, which Chromium prints.
    echo '<script type="module">document.body.append("PNG:" + picture.toDataURL() + ":");</script>' >>"$folder/$scene/index.html"
    chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --user-data-dir="$folder/user" \
        --dump-dom "file://$folder/$scene/index.html" 2>/dev/null >"$folder/page.html"
    sed -n 's/.*PNG:data:image\/png;base64,\([^:]*\):.*/\1/p' "$folder/page.html" | base64 -d >"$folder/$scene.png"
    verdict=$("$glint" diagnose "$file" "$folder/$scene.png")
    case $verdict in
    "No mistake"*) ;;
    *) echo "$scene: ${verdict:-no picture}" && failed=1 ;;
    esac
done
exit $failed
