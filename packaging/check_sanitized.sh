#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the tests under the sanitizers: all that are not marked long and run on this machine itself under those of addresses and
# undefined behaviour; with --threads those of the parts with many threads under that of threads. What is judged is what the
# sanitizers report: a test that only fails because everything is some times slower is named, and is judged by check.sh.
#   packaging/check_sanitized.sh [--threads] [--minutes N] [ARGUMENTS OF CTEST...]
# --minutes N: what is not built or not begun by then is left, and that is said.
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
minutes=1000
[ "${1:-}" != --minutes ] || { minutes=${2:?} && shift 2; }
until=$(($(date +%s) + 60 * minutes))
packaging/install_packages.sh
[ -f "build/$preset/build.ninja" ] || cmake --preset "$preset"
status=0
timeout $((60 * minutes)) cmake --build --preset "$preset" --parallel "$(nproc)" "${targets[@]}" || status=$?
if [ "$status" -eq 124 ]; then
    echo "check_sanitized.sh: it is not built after $minutes minutes; nothing was tried"
    exit 0
fi
[ "$status" -eq 0 ] || exit "$status"

reports="$PWD/build/$preset/reports"
rm -rf "$reports"
mkdir -p "$reports"
source packaging/headless.sh
export ASAN_OPTIONS="detect_stack_use_after_return=1:handle_sigill=2:log_path=$reports/report"
export LSAN_OPTIONS="suppressions=$PWD/tests/sanitizers/lsan.supp:print_suppressions=0"
export TSAN_OPTIONS="suppressions=$PWD/tests/sanitizers/tsan.supp:print_suppressions=0:die_after_fork=0:log_path=$reports/report"
# A test that was begun in time may take a few minutes more.
timeout $((until - $(date +%s) + 300)) \
    ctest --test-dir "build/$preset" --label-exclude 'long|vm' --parallel "$test_slots" --stop-time "$(date --date="@$until" +%T)" \
    "${parts[@]}" "$@" ||
    echo "check_sanitized.sh: the tests named above failed or did not run, most likely for want of time; check.sh judges them"

found=$(find "$reports" -type f | wc -l)
if [ "$found" -gt 0 ]; then
    find "$reports" -type f -exec head -n 40 {} +
    echo "check_sanitized.sh: $found reports of the sanitizers; they lie in $reports" >&2
    exit 1
fi
echo "check_sanitized.sh: no report of the sanitizers"
