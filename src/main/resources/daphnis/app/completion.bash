# In place of the one above: readline quotes names itself.
__complete_files() {
    local line
    COMPREPLY=()
    while IFS= read -r line; do COMPREPLY+=("$line"); done < <(compgen -f -- "$1")
}

# COMP_WORDS is parted at equals signs and colons too, and has the quotation marks: words as the shell takes them.
_daphnis_bash() {
    local line="${COMP_LINE:0:COMP_POINT}" quote='' word='' given='' cut='' option='' c='' k
    local -a parted
    parted=()
    for (( k = 0; k <= ${#line}; k++ )); do
        c="${line:k:1}"
        if [[ $k -lt ${#line} && "$c" == "\\" && "$quote" != "'" ]]; then
            (( k = k + 1 ))
            word+="${line:k:1}"
            given=yes
        elif [[ -n "$quote" && $k -lt ${#line} ]]; then
            if [[ "$c" == "$quote" ]]; then quote=''; else word+="$c"; fi
        elif [[ "$c" == [\"\'] ]]; then
            quote="$c"
            given=yes
            cut="$word"
        elif [[ $k -eq ${#line} || "$c" == [[:blank:]] ]]; then
            option=''
            if [[ -n "$word$given" || $k -eq ${#line} ]]; then
                case "$word" in
                    --*=*)
                        option="${word%%=*}="
                        parted+=("${word%%=*}" "=" "${word#*=}")
                        ;;
                    *) parted+=("$word") ;;
                esac
            fi
            if [[ $k -lt ${#line} ]]; then
                word=''
                given=''
                cut=''
            fi
        else
            word+="$c"
            # readline replaces what is behind it only.
            if [[ "$COMP_WORDBREAKS" == *"$c"* ]]; then cut="$word"; fi
        fi
    done
    COMP_WORDS=("${parted[@]}")
    COMP_CWORD=$(( ${#parted[@]} - 1 ))
    COMPREPLY=()
    _daphnis
    cut="${cut#"$option"}"
    COMPREPLY=("${COMPREPLY[@]#"$cut"}")
}

# A directory is completed with a slash, and blanks in names are quoted.
complete -o filenames -F _daphnis_bash daphnis
