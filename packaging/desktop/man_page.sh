#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the manual page out of what the program itself says of its commands.
#   packaging/desktop/man_page.sh PROGRAM DATE > odograph.1
set -euo pipefail
program=$1
date=$2
version=$("$program" --version | cut -d ' ' -f 2)

# Words as roff takes them: no line that begins with a dot or a quote, no hyphen where a minus is meant.
literal() { sed -e 's/\\/\\\\/g' -e 's/-/\\-/g' -e "s/^\([.']\)/\\\\\&\1/"; }

cat <<EOF
.TH ODOGRAPH 1 "$date" "odograph $version" "User Commands"
.SH NAME
odograph \- measure how a mobile robot moved, from two ordinary cameras
.SH SYNOPSIS
.B odograph
.RB [ \-\-window ]
.RI [ PROJECT.odo ]
.br
.B odograph
.I COMMAND
.RI [ ARGUMENT ...]
.SH DESCRIPTION
Odograph finds a robot in the videos of two or more cameras, maps the views to the floor, and gives position, velocity and
acceleration in millimetres and seconds, each with its uncertainty.
.PP
With no argument, or with a project, it opens the workbench; with
.B \-\-window
it does so in any case and tells there what is wrong with the project. With a command it runs without a window and without a display.
.PP
With
.B \-\-json
a command prints one JSON object on standard output and nothing else. Lengths take a unit (25mm, 2.5cm, 0.3m); a bare number is
millimetres. Colours are #rrggbb. Every error is one line on standard error: what could not be done, why, and what to do.
.SH COMMANDS
EOF
commands=$("$program" help | sed -n 's/^  \([a-z][a-z]*\)  *\(.*\)/\1 \2/p')
while read -r command summary; do
    help=$("$program" "$command" --help)
    printf '.SS %s\n' "$command"
    printf '%s.\n' "${summary^}" | literal
    printf '.PP\n.B '
    head -n 1 <<<"$help" | literal
    # "  -o, --output <FILE>  The file to write.": from the third blank on, or the next lines, what it means.
    tail -n +2 <<<"$help" | awk '
        /^  -/ {
            line = substr($0, 3)
            at = match(line, /   *[^ <-]/)
            print "OPTION " (at ? substr(line, 1, at - 1) : line)
            if (at) { line = substr(line, at); sub(/^ */, "", line); print line }
            next
        }
        /^   / { sub(/^ */, ""); print }' | literal |
        sed -e 's/^OPTION \(.*\)/.TP\n.B \1/'
done <<<"$commands"
cat <<'EOF'
.SH EXIT STATUS
.TP
.B 0
It is done.
.TP
.B 1
It could not be done; the project is as it was.
.TP
.B 2
The call was wrong.
.TP
.BR 130 ", " 143 ", " 129
Stopped by Ctrl\-C, SIGTERM or SIGHUP. A recording is kept. A second Ctrl\-C ends the program at once.
.SH FILES
.TP
.I PROJECT.odo
A project: one SQLite database. The videos lie beside it in
.IR PROJECT.media/ .
.TP
.I ~/.config/odograph/
Preferences and the layout of the window.
.TP
.I ~/.local/state/odograph/
What was left by a crash.
.SH EXAMPLE
.nf
odograph demo ~/odograph\-demo
odograph ~/odograph\-demo/demo.odo
.fi
.SH SEE ALSO
.BR ffmpeg (1)
EOF
