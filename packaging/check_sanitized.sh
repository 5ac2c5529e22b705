#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the tests under the sanitizers: all that are not marked long and run on this machine itself under those of addresses and
# undefined behaviour; with --threads those of the parts with many threads under that of threads. The status is 1 where a test
# fails or a sanitizer reports anything, in a test or in a program that it starts.
#   packaging/check_sanitized.sh [--threads] [ARGUMENTS OF CTEST...]
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
preset=asan
targets=() # all
parts=()
if [ "${1:-}" = --threads ]; then
    preset=tsan
    targets=(--target capture_tests workflow_tests project_tests)
    parts=(--tests-regex '^(capture|workflow|project)/')
    shift
fi
packaging/install_packages.sh packages.txt packages_tests.txt
[ -f "build/$preset/build.ninja" ] || cmake --preset "$preset"
cmake --build --preset "$preset" --parallel "$(nproc)" "${targets[@]}"

reports="$PWD/build/$preset/reports"
rm -rf "$reports"
mkdir -p "$reports"
source packaging/headless.sh
export ODOGRAPH_SANITIZER_LOG="log_path=$reports/report" # the presets say the rest
status=0
ctest --preset "$preset" --label-exclude 'long|vm' --parallel "$test_slots" "${parts[@]}" "$@" || status=$?

found=$(find "$reports" -type f | wc -l)
if [ "$found" -gt 0 ]; then
    find "$reports" -type f -exec head -n 40 {} +
    echo "check_sanitized.sh: $found reports of the sanitizers; they lie in $reports" >&2
    exit 1
fi
if [ "$status" -ne 0 ]; then
    echo "check_sanitized.sh: no report of the sanitizers, but tests failed: ctest names them above" >&2
    exit 1
fi
echo "check_sanitized.sh: all tests passed, no report of the sanitizers"
