#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds Odograph, makes the demo lesson (once) and opens it. Without a display it tracks the
# first trial instead and paints the window into a picture.
#   packaging/demo.sh [FOLDER]      default: ~/odograph-demo
set -euo pipefail
root="$(dirname "$(dirname "$(readlink -f "$0")")")"
folder=$(realpath -m "${1:-$HOME/odograph-demo}")
project="$folder/demo.odo"
odograph="$root/build/release/app/odograph"

"$root/packaging/build.sh" odograph

if [ -e "$project" ]; then
    echo "The demo lesson is in $project already."
else
    "$odograph" demo "$folder"
fi

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    exec "$odograph" "$project"
fi

echo "There is no display: tracking the first trial and painting the window into a picture."
export QT_QPA_PLATFORM=offscreen
trial=$("$odograph" list "$project" --json | tr -d '\n' |
    sed -n 's/.*"trials":[^{]*{[^{}]*"name": *"\([^"]*\)".*/\1/p')
"$odograph" track "$project" "$trial"
"$odograph" snapshot "$project" "$trial" -o "$folder/review.png"
echo "The window is painted in $folder/review.png"
