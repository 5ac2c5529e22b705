#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds all of it with the address and undefined-behaviour sanitizers and runs every test that is not marked long under
# them. What is judged is what the sanitizers report: a test that only fails because everything is some times slower is
# named, and is judged by check.sh. Arguments go to ctest.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
packaging/install_packages.sh
[ -f build/asan/build.ninja ] || cmake --preset asan
cmake --build --preset asan --parallel "$(nproc)"

reports="$PWD/build/asan/reports"
rm -rf "$reports"
mkdir -p "$reports"
source packaging/headless.sh
export ASAN_OPTIONS="detect_stack_use_after_return=1:log_path=$reports/report"
export UBSAN_OPTIONS="halt_on_error=1:print_stacktrace=1:log_path=$reports/report"
export LSAN_OPTIONS="suppressions=$PWD/tests/sanitizers/lsan.supp:print_suppressions=0"
ctest --test-dir build/asan --label-exclude long --parallel "$(nproc)" "$@" ||
    echo "check_sanitized.sh: the tests named above failed, most likely for want of speed; check.sh judges them"

found=$(find "$reports" -type f | wc -l)
if [ "$found" -gt 0 ]; then
    find "$reports" -type f -exec head -n 40 {} +
    echo "check_sanitized.sh: $found reports of the sanitizers; they lie in $reports" >&2
    exit 1
fi
echo "check_sanitized.sh: no report of the sanitizers"
