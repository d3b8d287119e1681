# debian.sh CPACK BUILD: the Debian package can be made, and holds what it should.
set -e
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" -G DEB -B "$folder" --config "$2/CPackConfig.cmake"
dpkg-deb --info "$folder"/*.deb
dpkg-deb --contents "$folder"/*.deb > "$folder/contents"
for file in bin/cover include/cover/cover_mesh.hpp libcover.a coverConfig.cmake cover.pc man1/cover.1 completions/cover; do
  grep -q "$file" "$folder/contents" || { echo "missing: $file"; exit 1; }
done
