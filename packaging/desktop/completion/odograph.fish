# fish completion for odograph
# The program itself says what a word may become: odograph complete (docs/cli.md).

function __odograph_complete
    set -l before (commandline -opc)
    set -l program $before[1]
    set -e before[1]
    # the word at the cursor, without its quotes
    set -l word (commandline -ct | string unescape 2>/dev/null; or commandline -ct)
    set -l answer (eval (string escape -- $program) complete words (string escape -- $before "$word") 2>/dev/null)
    set -l files $answer[1]
    set -e answer[1]
    for line in $answer
        echo -- $line
    end
    switch "$files"
        case files
            # behind CAMERA= the name of a file begins
            set -l start (string match -r '^[^/=]*=' -- "$word")
            set -l name (string replace -r '^[^/=]*=' '' -- "$word")
            for path in (__fish_complete_path "$name")
                echo -- "$start$path"
            end
        case folders
            __fish_complete_directories "$word" ''
        case projects
            __fish_complete_suffix "$word" .odo
    end
end

complete -c odograph -f -a '(__odograph_complete)'
