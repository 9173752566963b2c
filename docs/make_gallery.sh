#!/usr/bin/env bash
# Renders every picture in docs/gallery.md and README.md: docs/make_gallery.sh [GLINT]
# GLINT is the program, by default build/release/app/glint. Look at each picture before you commit it.
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")/.."
glint=${1:-build/release/app/glint}
[ -x "$glint" ] || { echo "make_gallery.sh: $glint: no such program; build it first" >&2; exit 1; }
mkdir -p docs/pictures

picture() { # NAME SCENE [OPTIONS]: renders a picture in docs/pictures
    local name=$1 scene=$2
    shift 2
    "$glint" render "assets/scenes/$scene.json" -o "docs/pictures/$name.png" --size "${size:-480x270}" --samples 8 "$@"
}
sheet() { # NAME SCENE OPTIONS: renders a labelled grid of pictures
    local name=$1 scene=$2
    shift 2
    "$glint" sheet "assets/scenes/$scene.json" -o "docs/pictures/$name.png" "$@"
}

for scene in still-life sun bulb spot-cone area-light sun-and-headlight ambient-alone no-shadows inverse-square \
    cosine-law mirror-vector shininess-grid every-term classic-materials rough-to-smooth cube-normals mach-bands \
    coarse-silhouette skew-quad t-junction cool-to-warm silhouettes-and-creases light-behind-ball \
    chalk-and-glaze shadow-hard shadow-soft corner-bleeding two-plates; do
    picture "$scene" "$scene"
done
size=640x360 picture default default
picture projected wide-angle-balls --set /shading/mistakes/lit_after_projection=true
picture flipped still-life --set /shading/mistakes/normals_flipped=true
picture disc coarse-ball --set /shading/mistakes/no_normals_given=true

sheet transport default --rows /transport/paths=256 --cols /transport/model=local,shadows,bounces --cell 320x180

modes=/shading/mode=flat,gouraud,phong
sheet shadings coarse-ball --rows $modes --cols /objects/0/mesh/detail=1,2,3 --cell 128x128
sheet three-shadings still-life --rows /objects/0/mesh/detail=3 --cols $modes --cell 240x180
sheet reflections glossy-ball --set /lights/0/position=[0.08,0.1,1] --cell 120x120 \
    --cols /shading/reflection=lambert,phong,blinn-phong,retro,oren-nayar,cook-torrance \
    --rows '/objects/0/material/specular=[0,0,0],[0.7,0.66,0.62]'
sheet lost-highlight lost-highlight --rows /shading/mode=gouraud,phong --cols /objects/0/mesh/detail=1,4,16 \
    --cell 240x135
sheet swimming receding-floor --rows /shading/interpolation=screen,perspective \
    --cols '/camera/eye=[-1,1.1,3.6],[0,1.1,3.6],[1,1.1,3.6]' --cell 240x135
