#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the tests on a build whose core counts the lines that run, and tells how many of them did: a table of the files,
# those with the most lines left last, in build/coverage/coverage.txt, and the whole at the end. Fails below nine lines in ten.
# Arguments go to ctest; a test that fails is told, and what the others reached is counted all the same.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
packaging/install_packages.sh packages.txt packages_tests.txt packages_quality.txt
cmake --preset coverage >/dev/null
cmake --build --preset coverage
find build/coverage -name '*.gcda' -delete
source packaging/headless.sh
ctest --preset coverage --parallel "$test_slots" "$@" || echo "coverage.sh: some tests failed" >&2
gcovr --root . --filter core/ --object-directory build/coverage build/coverage/core --exclude-throw-branches \
    --sort-uncovered --txt build/coverage/coverage.txt --print-summary --fail-under-line 90
