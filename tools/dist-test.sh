#!/bin/sh
# The distribution as a stranger gets it, on whatever this is: unpacked in a folder with a space, begun by its launcher.
# On Windows (Git's shell) that is daphnis.bat. It ends in the pinned digest of a built-in scenario.
#   mvn -Pdist -DskipTests -pl src -am package && tools/dist-test.sh
set -eu
here=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd)
zip=$here/target/daphnis-$(cat "$here/core/src/main/resources/daphnis/version.txt").zip
work=$(mktemp -d "${TMPDIR:-/tmp}/daphnis-dist.XXXXXX")
trap 'rm -rf "$work"' EXIT
mkdir "$work/un packed"
cd "$work/un packed"
unzip -q "$zip"
home=$(echo daphnis-*)
case $(uname -s) in
MINGW* | MSYS* | CYGWIN*) launch() { "./$home/bin/daphnis.bat" "$@"; } ;;
*) launch() { "./$home/bin/daphnis" "$@"; } ;;
esac

pinned=$(sed -n 's/^ring-patch,6,//p' "$here/src/test/resources/golden/digests.csv" | tr -d '\r')
launch run ring-patch --steps 6 --quiet --out "my runs/ring" | tee out
grep -q "$pinned" out || { echo "dist test: the digest is not $pinned" >&2 && exit 1; }
launch analyze "my runs/ring" --out "my report" >/dev/null
[ -s "my report/report.html" ] || { echo "dist test: there is no report" >&2 && exit 1; }
code=0
launch run ring-patch --set particles.opticalDepth=-1 --out no 2>err || code=$?
[ $code -eq 2 ] || { echo "dist test: wrong input ends with $code" >&2 && cat err >&2 && exit 1; }
echo "dist test: passed"
