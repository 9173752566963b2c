#!/usr/bin/env bash
# Builds Glint if necessary and starts it: ./run.sh [ARGS] is `glint ARGS`. Installs missing packages first.
set -eu
. "$(dirname "${BASH_SOURCE[0]}")/cmake/prepare.sh"

install_packages "$glint_root/cmake/packages.txt"
build release OFF glint
exec "$glint_root/build/release/app/glint" "$@"
