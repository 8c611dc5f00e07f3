#!/bin/sh
# Recipes of package managers with the version and the checksum of a release's zip, into a folder: what is sent to them.
# Here they have the version and noughts, since a release can't hold its own checksum.
#   tools/packaging/fill.sh ZIP FOLDER
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
[ $# = 2 ] && [ -s "$1" ] || {
    echo "usage: tools/packaging/fill.sh ZIP FOLDER" >&2
    exit 2
}
version=$(tr -d '\r\n' <"$here/../../core/src/main/resources/daphnis/version.txt")
case $(basename -- "$1") in
"daphnis-$version.zip") ;;
*) echo "recipes: $1 is not daphnis-$version.zip" >&2 && exit 1 ;;
esac
if command -v sha256sum >/dev/null 2>&1; then sum=$(sha256sum <"$1"); else sum=$(shasum -a 256 <"$1"); fi
noughts=$(printf '%064d' 0)
for recipe in spack/package.py conda-forge/recipe.yaml apptainer.def; do
    grep -qF "$version" "$here/$recipe" || { echo "recipes: $recipe is not of $version" >&2 && exit 1; }
    grep -q "$noughts" "$here/$recipe" || { echo "recipes: no place for a checksum in $recipe" >&2 && exit 1; }
    mkdir -p "$(dirname -- "$2/$recipe")"
    sed "s/$noughts/${sum%% *}/" "$here/$recipe" >"$2/$recipe"
    echo "$2/$recipe"
done
