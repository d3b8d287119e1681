# debian.sh CPACK BUILD INPUT [PYTHON]: the Debian package can be made, holds what it should, and
# what it holds works.
set -e
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" -G DEB -B "$folder" --config "$2/CPackConfig.cmake"
dpkg-deb --info "$folder"/*.deb
dpkg-deb -x "$folder"/*.deb "$folder/root"
usr=$folder/root/usr
for file in include/cover/cover_mesh.hpp include/cover/version.hpp lib/libcover.a lib/cmake/cover/coverConfig.cmake \
    lib/pkgconfig/cover.pc share/man/man1/cover.1 share/bash-completion/completions/cover share/doc/cover/README.md; do
  # The folder of libraries is that of the configured prefix.
  ls "$usr/$file" "$usr"/lib/*/"${file#lib/}" 2> /dev/null | grep -q . || { echo "missing: $file"; exit 1; }
done
"$usr/bin/cover" mesh "$3" -o "$folder/a.vtu"
"$usr/bin/cover" check "$3" "$folder/a.vtu"
[ -z "$4" ] || PYTHONPATH=$usr/lib/python3/dist-packages "$4" "$(dirname "$0")/installed_module.py" "$usr" "$3"
