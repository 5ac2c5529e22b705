# bash completion for odograph                                -*- shell-script -*-
# The program itself says what a word may become: odograph complete (docs/cli.md).

_odograph()
{
    local answer files rest
    COMPREPLY=()
    mapfile -t answer < <("${1/#\~\//$HOME/}" complete bash "${COMP_LINE:0:COMP_POINT}" "$COMP_WORDBREAKS" 2>/dev/null)
    files=${answer[0]-} rest=${answer[1]-}
    COMPREPLY=("${answer[@]:2}")
    case $files in
        files) ((${#COMPREPLY[@]})) || compopt -o default 2>/dev/null ;;
        folders) ((${#COMPREPLY[@]})) || compopt -o dirnames 2>/dev/null ;;
        projects)
            compopt -o filenames 2>/dev/null
            mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(
                compgen -f -X '!*.odo' -- "$rest"
                compgen -d -- "$rest"
            )
            ;;
    esac
    [[ ${#COMPREPLY[@]} == 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace 2>/dev/null
    return 0
}

complete -F _odograph odograph
