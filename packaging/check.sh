#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds the release and runs every test that is not marked long, without a display and
# without touching the user's own settings. Its last lines are ctest's summary; its status is ctest's.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
packaging/install_packages.sh packages.txt packages_tests.txt
packaging/build.sh
# Where the machine's kernel cannot be had, its tests say so and are skipped.
export ODOGRAPH_VM_CACHE="${ODOGRAPH_VM_CACHE:-${XDG_CACHE_HOME:-${HOME:-/nonexistent}/.cache}/odograph/vm}"
tests/vm/vm_prepare || true

source packaging/headless.sh
ctest --preset release --parallel "$test_slots" "$@"
