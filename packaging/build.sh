#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing and builds the release. With everything up to date it does next to nothing.
#   packaging/build.sh [TARGET...]
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
packaging/install_packages.sh

# One compiler for each processor, but never more than one for 2 GB of memory.
processors=$(nproc)
by_memory=$(awk '/^MemTotal:/ { print int($2 / (2 * 1024 * 1024)) }' /proc/meminfo 2>/dev/null || echo 1)
jobs=$((processors < by_memory ? processors : by_memory))
jobs=$((jobs > 1 ? jobs : 1))

[ -f build/release/build.ninja ] || cmake --preset release
cmake --build --preset release --parallel "$jobs" ${1:+--target "$@"}
