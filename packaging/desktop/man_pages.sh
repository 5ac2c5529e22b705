#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the manual pages out of what the program itself says of its commands: odograph.1, and odograph-COMMAND.1 of
# each.
#   packaging/desktop/man_pages.sh PROGRAM DATE FOLDER
set -euo pipefail
program=$1 date=$2 folder=$3
version=$("$program" --version | cut -d ' ' -f 2)
mkdir -p "$folder"

# Words as roff takes them: no line that begins with a dot or a quote, no hyphen where a minus is meant.
literal() { sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^\([.']\)/\\\\\&\1/"; }

# "  -o, --output <FILE>  The file to write.": from the third blank on, or the next lines, what it means.
options()
{
    tail -n +2 | awk '
        /^  -/ {
            line = substr($0, 3)
            at = match(line, /   *[^ <-]/)
            print "OPTION " (at ? substr(line, 1, at - 1) : line)
            if (at) { line = substr(line, at); sub(/^ */, "", line); print line }
            next
        }
        /^   / { sub(/^ */, ""); print }' | literal | sed -e 's/^OPTION \(.*\)/.TP\n.B \1/'
}

# The page of one command: its name and what it does.
command_page()
{
    local name=$1 summary=$2 help usage
    help=$("$program" "$name" --help)
    usage=$(head -n 1 <<<"$help")
    cat <<END
.TH ODOGRAPH\-${name^^} 1 "$date" "odograph $version" "User Commands"
.SH NAME
odograph\-$name \- $(literal <<<"$summary")
.SH SYNOPSIS
.B odograph $name
$(literal <<<"${usage#odograph "$name"}" | sed 's/^ *//')
.SH DESCRIPTION
$(literal <<<"${summary^}").
.PP
.BR odograph (1)
describes what all commands have in common.
.SH OPTIONS
$(options <<<"$help")
.SH EXIT STATUS
0 it is done, 1 it could not be done, 2 the call was wrong; more in
.BR odograph (1).
.SH SEE ALSO
.BR odograph (1)
END
}

main_page()
{
    local name summary
    cat <<END
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
END
    while read -r name summary; do
        printf '.TP\n.BR odograph\\-%s (1)\n' "$name"
        printf '%s.\n' "${summary^}" | literal
    done <<<"$commands"
    cat <<'END'
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
.BR ffmpeg (1);
for each command
.BR odograph\-COMMAND (1)
END
}

commands=$("$program" help | sed -n 's/^  \([a-z][a-z-]*\)  *\(.*\)/\1 \2/p')
main_page >"$folder/odograph.1"
while read -r name summary; do
    command_page "$name" "$summary" >"$folder/odograph-$name.1"
done <<<"$commands"
