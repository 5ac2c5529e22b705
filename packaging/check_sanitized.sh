#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds all of it with the address and undefined-behaviour sanitizers and runs every test under them that is not marked
# long and runs on this machine itself. What is judged is what the sanitizers report: a test that only fails because
# everything is some times slower is named, and is judged by check.sh.
#   packaging/check_sanitized.sh [--minutes N] [ARGUMENTS OF CTEST...]
# --minutes N: what is not built or not begun by then is left, and that is said.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
minutes=1000
[ "${1:-}" != --minutes ] || { minutes=${2:?} && shift 2; }
until=$(($(date +%s) + 60 * minutes))
packaging/install_packages.sh
[ -f build/asan/build.ninja ] || cmake --preset asan
status=0
timeout $((60 * minutes)) cmake --build --preset asan --parallel "$(nproc)" || status=$?
if [ "$status" -eq 124 ]; then
    echo "check_sanitized.sh: it is not built after $minutes minutes; nothing was tried"
    exit 0
fi
[ "$status" -eq 0 ] || exit "$status"

reports="$PWD/build/asan/reports"
rm -rf "$reports"
mkdir -p "$reports"
source packaging/headless.sh
export ASAN_OPTIONS="detect_stack_use_after_return=1:handle_sigill=2:log_path=$reports/report"
export LSAN_OPTIONS="suppressions=$PWD/tests/sanitizers/lsan.supp:print_suppressions=0"
# A test that was begun in time may take a few minutes more.
timeout $((until - $(date +%s) + 300)) \
    ctest --test-dir build/asan --label-exclude 'long|vm' --parallel "$(nproc)" --stop-time "$(date --date="@$until" +%T)" "$@" ||
    echo "check_sanitized.sh: the tests named above failed or did not run, most likely for want of time; check.sh judges them"

found=$(find "$reports" -type f | wc -l)
if [ "$found" -gt 0 ]; then
    find "$reports" -type f -exec head -n 40 {} +
    echo "check_sanitized.sh: $found reports of the sanitizers; they lie in $reports" >&2
    exit 1
fi
echo "check_sanitized.sh: no report of the sanitizers"
