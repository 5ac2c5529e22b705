#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs those packages of lists beside this script that are missing. Asks for nothing and calls nothing when none is.
#   packaging/install_packages.sh [LIST...]      default: packages.txt
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")"
[ $# -gt 0 ] || set -- packages.txt

missing=()
while read -r package; do
    state=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$state" = installed ] || missing+=("$package")
done < <(sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$@")
[ ${#missing[@]} -gt 0 ] || exit 0

echo "Installing ${#missing[@]} packages: ${missing[*]}"
root=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
        echo "install_packages.sh: cannot install packages: sudo is not there; run this script as root" >&2
        exit 1
    }
    root=(sudo)
fi
"${root[@]}" apt-get update -q
"${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
