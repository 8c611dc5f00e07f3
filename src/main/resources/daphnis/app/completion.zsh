# The script is for words as bash parts them, at equals signs too; zsh has `--engine=h` as one.
_daphnis_zsh() {
    local -a parted
    local k=0 word='' option=''
    parted=()
    while [[ ${k} -le $COMP_CWORD ]]; do
        word="${COMP_WORDS[$k]}"
        option=''
        case "$word" in
            --*=*)
                option="${word%%=*}="
                parted+=("${word%%=*}" "=" "${word#*=}")
                ;;
            *) parted+=("$word") ;;
        esac
        (( k = k + 1 ))
    done
    COMP_WORDS=("${parted[@]}")
    COMP_CWORD=$(( ${#parted[@]} - 1 ))
    _daphnis
    if [[ -n "$option" ]]; then COMPREPLY=("${COMPREPLY[@]/#/$option}"); fi
}
complete -o filenames -F _daphnis_zsh daphnis
