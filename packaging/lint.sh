#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Has clang-tidy (.clang-tidy) and clazy look through the sources and prints what they find; docs/testing.md says what for.
# The status is 0 if nothing was found, 1 otherwise. Nothing is compiled but precompiled headers.
#   packaging/lint.sh                     all of core, ui, app and tests: an hour of one processor
#   packaging/lint.sh FILE|FOLDER...      these, with what is compiled in one go with them
#   packaging/lint.sh --changed COMMIT    what differs from COMMIT; of a changed header, the source of its name
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

paths=("$@")
if [ "${1:-}" = --changed ]; then
    [ $# -eq 2 ] || { echo "lint.sh: --changed: it takes one commit; give one, e.g. --changed HEAD~1" >&2; exit 2; }
    changed=$(git diff --name-only --diff-filter=d "$2" -- '*.cpp' '*.h')
    mapfile -t paths < <(sed 's/\.h$/.cpp/' <<<"$changed" | grep -E '^(core|ui|app|tests)/' | sort -u)
    [ ${#paths[@]} -gt 0 ] || { echo "Nothing differs from $2 that can be looked through."; exit 0; }
fi

packaging/install_packages.sh packages.txt packages_tests.txt packages_quality.txt
cmake --preset lint >/dev/null # anew, for files that have come since

# A unit is what clang compiles in one go: a test, or a file of CMake's that includes up to sixteen sources, by which what all of them
# include is looked through once. Lists the sources of ours in one.
sources_of() {
    if [[ $1 = */Unity/* ]]; then sed -n 's/^#include "\(.*\)"/\1/p' "$1"; else echo "$1"; fi | grep -E "^$PWD/(core|ui|app|tests)/" || true
}

# Those that hold something of what is asked for.
mapfile -t paths < <(realpath -m "${paths[@]:-.}")
units=()
sources=()
while read -r unit; do
    mapfile -t within < <(sources_of "$unit")
    for path in "${paths[@]}"; do
        if printf '%s\n' "${within[@]}" | grep -qE "^$path(/|\$)"; then
            units+=("$unit")
            sources+=("${within[@]}")
            break
        fi
    done
done < <(sed -n 's/^ *"file": "\(.*\)".*/\1/p' build/lint/compile_commands.json | sort -u)
[ ${#units[@]} -gt 0 ] || { echo "lint.sh: ${paths[*]}: no source that is built; name files or folders of the tree" >&2; exit 2; }

# What they include beside themselves and headers: the precompiled headers, and what moc makes of a test.
mapfile -t mocs < <(ninja -C build/lint -t targets all | sed -n 's/^\(tests\/.*\.moc\): .*/\1/p')
for moc in "${mocs[@]}"; do # its command alone: asked for the file, ninja would build what the test is linked with
    [[ " ${sources[*]} " != *" $PWD/${moc%.moc}.cpp "* ]] || bash -c "$(ninja -C build/lint -t commands -s "$moc")"
done
cmake --build --preset lint --target odograph_precompiled_headers >/dev/null

# clazy's level 1 finds what surprises in Qt: containers that detach, temporaries that are gone, slots and lambdas that outlive their
# objects, static objects. Added to it:
#   container-inside-loop, unneeded-cast, isempty-vs-count        work for nothing
#   heap-allocated-small-trivial-type                             the same
#   thread-with-slots, signal-with-return-value                   what runs in another thread than it seems, or whose answer is lost
#   tr-non-literal                                                words that no translator gets to see
#   missing-qobject-macro, base-class-event, old-style-connect    signals without a class, events that end where they should go on
#   assert-with-side-effects                                      what differs between debug and release
# Left out: qstring-ref, which advises what Qt 6 has no more; connect-non-signal, which stops with an internal error at some of Qt 6's
# own signals; non-pod-global-static, for the words of a file are QStringLiterals that allocate nothing and that no other file sees.
export CLAZY_LIST=level1,no-qstring-ref,no-connect-non-signal,no-non-pod-global-static,container-inside-loop,unneeded-cast,isempty-vs-count,\
heap-allocated-small-trivial-type,thread-with-slots,signal-with-return-value,tr-non-literal,missing-qobject-macro,\
base-class-event,old-style-connect,assert-with-side-effects
# Not asked of tests, in which a copy more costs nobody anything.
export CLAZY_LIST_OF_TESTS=$CLAZY_LIST,no-range-loop-detach,no-detaching-temporary,no-container-inside-loop,no-use-static-qregularexpression

# Prints what both find in one unit of ours, in one go. clazy brings the warnings of the compiler with it.
look() {
    local found checks=$CLAZY_LIST config=.clang-tidy
    [[ $1 != "$PWD"/tests/* && $1 != "$PWD"/build/lint/tests/* ]] || { checks=$CLAZY_LIST_OF_TESTS && config=tests/.clang-tidy; }
    found=$({
        clang-tidy-14 -p build/lint --config-file="$config" --quiet "$1" 2>/dev/null || echo "$1:1:1: error: clang-tidy failed on it"
        clazy-standalone -p build/lint --checks="$checks" "$1" || echo "$1:1:1: error: clazy failed on it"
    } 2>&1 | awk -v ours="$PWD/" '/^[^ ].*:[0-9]+:[0-9]+: (warning|error): / { shown = index($0, ours) == 1 } shown' |
        grep -vE '^[0-9]+ warnings? generated\.$' || true)
    [ -z "$found" ] || printf '%s\n' "$found"
}
export -f look

findings=$(mktemp)
trap 'rm -f "$findings"' EXIT
printf '%s\0' "${units[@]}" | xargs -0 -P "$(nproc)" -n 1 bash -c 'look "$1"' look | tee "$findings"
count=$({ grep -E ':[0-9]+:[0-9]+: (warning|error): ' "$findings" || true; } | sort -u | wc -l)
echo "${#sources[@]} sources, $count findings."
[ "$count" -eq 0 ]
