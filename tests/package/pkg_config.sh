# pkg_config.sh 'COMPILER FLAGS' FOLDER SOURCE PACKAGE: what pkg-config says is enough to build and run a program.
set -e
export PKG_CONFIG_PATH=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
$1 "$3" -o "$folder/program" $(pkg-config --cflags --libs "$4")
cd "$folder" && ./program
