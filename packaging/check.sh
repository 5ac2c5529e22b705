#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds the release and runs every test that is not marked long, without a display and
# without touching the user's own settings. Its last lines are ctest's summary; its status is ctest's.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
packaging/build.sh
# Where the machine's kernel cannot be had, its tests say so and are skipped.
export ODOGRAPH_VM_CACHE="${ODOGRAPH_VM_CACHE:-${XDG_CACHE_HOME:-${HOME:-/nonexistent}/.cache}/odograph/vm}"
tests/vm/vm_prepare || true

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -m 700 "$scratch/runtime"
unset DISPLAY WAYLAND_DISPLAY
export QT_QPA_PLATFORM=offscreen LC_ALL=C.UTF-8
export XDG_CONFIG_HOME="$scratch/config" XDG_DATA_HOME="$scratch/data" XDG_CACHE_HOME="$scratch/cache" \
    XDG_STATE_HOME="$scratch/state" XDG_RUNTIME_DIR="$scratch/runtime"
ctest --preset release --parallel "$(nproc)" "$@"
