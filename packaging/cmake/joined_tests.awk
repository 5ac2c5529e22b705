# SPDX-License-Identifier: GPL-3.0-or-later
# Joins the sources of tests into one, so that what all of them include is read once: first every include, then each source in a
# namespace of its own, where its names meet no other's. The compiler goes on to name the source and its line.
FNR == 1 {
    if (NR > 1)
        body = body "}\n"
    unit = FILENAME
    gsub(/.*\/|\.cpp$/, "", unit)
    body = body "namespace " unit " {\n#line 1 \"" FILENAME "\"\n"
}
/^extern "C" {$/ { # around the headers of a library in C
    inC = 1
    $0 = ""
}
inC && /^}$/ {
    inC = 0
    $0 = ""
}
/^#include/ && !/\.moc"$/ {
    includes = includes (inC ? "extern \"C\" {\n" $0 "\n}\n" : $0 "\n")
    $0 = ""
}
{ body = body $0 "\n" }
END { printf "%s%s}\n", includes, body }
