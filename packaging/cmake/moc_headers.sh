#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What Qt's meta-object compiler makes of headers, in one source; nothing of those without Qt's macros.
#   moc_headers.sh MOC SOURCE_FOLDER OUTPUT HEADER...
set -e
moc=$1 folder=$2 output=$3
shift 3
: > "$output.new"
for header in "$@"; do
    "$moc" --no-notes -f"${header#"$folder"/}" "$header" >> "$output.new"
done
mv "$output.new" "$output"
