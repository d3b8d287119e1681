# Completion of cover's commands, options and words for bash. Options are asked of the program itself.
_cover() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} words=
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    words=$("${COMP_WORDS[0]}" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
    COMPREPLY=($(compgen -W "$words --help --version" -- "$word"))
    return
  fi
  if [ "$before" = = ]; then before=${COMP_WORDS[COMP_CWORD-2]}; fi      # --method=quality is three words
  if [ "$word" = = ]; then before=${COMP_WORDS[COMP_CWORD-1]} word=; fi
  case $before in
    --method) words="quality almond nonobtuse" ;;
    --fill) words="refine disks" ;;
    --prefer) words="balanced largest" ;;
    --effort) words="fast normal thorough" ;;
    --couplings) words="auto first last" ;;
    --overlap) words="last first error" ;;
    --weld) words="auto off" ;;
    --require) words="bound max-angle delaunay non-obtuse box-method" ;;
    --unit) words="nm um mm cm m" ;;
    --order) words="1 2" ;;
    --msh) words="2.2 4.1" ;;
    --xdmf) words="text hdf5" ;;
    --ids) words="region material name" ;;
    --inp-element) words="S CPS CPE CAX" ;;
    --format) if [ "$command" = render ]; then words="svg png"; else
         words="vtu vtkhdf vtk msh xdmf mesh inp obj off ply json poly svg png"; fi ;;
    --stats) words="text json" ;;
    --progress|--stream) words="auto on off" ;;
    --color) words="max_angle min_angle material MaterialID mat_id RegionId" ;;
    *) if [[ $word == -* ]]; then
         words=$("${COMP_WORDS[0]}" "$command" --help | grep -oE -- '^  (-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+')
       fi ;;
  esac
  # Without words of ours, bash completes file names.
  [ -z "$words" ] || COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o default -F _cover cover
