# Completion of meet and meetc in bash: commands and options are those that --help lists, and else files.
_meetc_complete() {
  local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} help command="" choices
  COMPREPLY=()
  if [[ $COMP_CWORD -gt 1 && ${COMP_WORDS[1]} != -* ]]; then
    command=${COMP_WORDS[1]}
  fi
  help=$("$program" ${command:+"$command"} --help 2>/dev/null) || return 0
  # An option that takes one of several words says a|b|c behind its name.
  if [[ $before == --* ]]; then
    choices=$(sed -nE "s/^ +(-[a-zA-Z],)?$before ([A-Za-z0-9_.-]+(\|[A-Za-z0-9_.-]+)+)( .*)?$/\2/p" <<<"$help" | head -n 1)
    if [[ -n $choices && $choices != *.* ]]; then
      mapfile -t COMPREPLY < <(compgen -W "${choices//|/ }" -- "$word")
      return 0
    fi
  fi
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(sed -nE 's/^ +((-[a-zA-Z]|--[a-z0-9-]+)(,--[a-z0-9-]+)*)( .*)?$/\1/p' <<<"$help" | tr ',' ' ')" -- "$word")
  elif [[ -z $command ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(sed -n '/^Subcommands:/,$s/^  \([a-z]*\) .*/\1/p' <<<"$help")" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
    compopt -o filenames 2>/dev/null || true
  fi
}
complete -F _meetc_complete meet meetc
