# bash completion for odograph                                -*- shell-script -*-
# What there is to complete is asked of the program itself, so that it is always true.

_odograph_words()
{
    # The first word of each line that is indented by two blanks.
    sed -n 's/^  \([a-z][a-z]*\) .*/\1/p' <<<"$1"
}

_odograph()
{
    local cur prev
    cur=${COMP_WORDS[COMP_CWORD]}
    prev=${COMP_WORDS[COMP_CWORD - 1]}
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        compopt -o filenames 2>/dev/null
        mapfile -t COMPREPLY < <(
            compgen -W "$(_odograph_words "$("${COMP_WORDS[0]}" help 2>/dev/null)")" -- "$cur"
            compgen -f -X '!*.odo' -- "$cur"
            compgen -d -- "$cur"
        )
        return
    fi
    if [[ $cur == -* ]]; then
        local help
        help=$("${COMP_WORDS[0]}" "${COMP_WORDS[1]}" --help 2>/dev/null)
        mapfile -t COMPREPLY < <(compgen -W "$(grep -o -- '--[a-z][a-z-]*' <<<"$help" | sort -u)" -- "$cur")
        return
    fi
    case $prev in
        --format) mapfile -t COMPREPLY < <(compgen -W 'csv tum json tracker video' -- "$cur") ;;
        --theme) mapfile -t COMPREPLY < <(compgen -W 'light dark' -- "$cur") ;;
        *)
            compopt -o filenames 2>/dev/null
            mapfile -t COMPREPLY < <(compgen -f -- "$cur")
            ;;
    esac
}

complete -F _odograph odograph
