# Completion of cover's commands, options and words for bash. Options are asked of the program itself.
_cover() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} words=
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    words=$("${COMP_WORDS[0]}" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
    COMPREPLY=($(compgen -W "$words --help --version" -- "$word"))
    return
  fi
  case $before in
    --method) words="quality almond nonobtuse" ;;
    --fill) words="refine disks" ;;
    --overlap) words="last first error" ;;
    --weld) words="auto off" ;;
    --require) words="bound max-angle delaunay non-obtuse" ;;
    --unit) words="nm um mm cm m" ;;
    --stats) words="text json" ;;
    --progress) words="auto on off" ;;
    --color) words="max_angle min_angle material RegionId" ;;
    *) if [[ $word == -* ]]; then
         words=$("${COMP_WORDS[0]}" "$command" --help | grep -oE -- '^ +(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+')
       fi ;;
  esac
  # Without words of ours, bash completes file names.
  [ -z "$words" ] || COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o default -F _cover cover
