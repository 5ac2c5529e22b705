#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the manual pages and the changelog of a package, compressed as Debian wants them.
#   packaging/desktop/documents.sh PROGRAM DATE MAINTAINER FOLDER        DATE: 2026-11-22
set -euo pipefail
program=$1 date=$2 maintainer=$3 folder=$4
here=$(dirname "$(readlink -f "$0")")
version=$("$program" --version | cut -d ' ' -f 2)
mkdir -p "$folder"
rm -rf "$folder/man1" # of commands that are no more
"$here/man_pages.sh" "$program" "$date" "$folder/man1"
gzip -9n "$folder/man1/"*.1
gzip -9n >"$folder/changelog.gz" <<EOF
odograph ($version) unstable; urgency=medium

  * What users can notice is told in CHANGELOG.md of the sources.

 -- $maintainer  $(LC_ALL=C date --utc --date="$date 12:00" '+%a, %d %b %Y %H:%M:%S +0000')
EOF
