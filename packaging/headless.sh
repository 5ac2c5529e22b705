# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the scripts that run tests: without a display, and with configuration, data, cache and runtime folders that
# are empty and go when the script ends, so that the user's own settings are left alone.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -m 700 "$scratch/runtime"
unset DISPLAY WAYLAND_DISPLAY
export QT_QPA_PLATFORM=offscreen LC_ALL=C.UTF-8
export XDG_CONFIG_HOME="$scratch/config" XDG_DATA_HOME="$scratch/data" XDG_CACHE_HOME="$scratch/cache" \
    XDG_STATE_HOME="$scratch/state" XDG_RUNTIME_DIR="$scratch/runtime"
# What ctest runs at a time: a test that computes takes two of them, one that waits takes one.
test_slots=$((2 * $(nproc)))
