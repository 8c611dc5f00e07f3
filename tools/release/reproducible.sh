#!/bin/sh
# Builds all that is released twice, from copies of this checkout in folders of other names and with another umask, time
# zone, language and time of files, and compares the SHA-256 of each: jars with sources and of Dokka, POMs, zip, list of
# parts, wheel and sources of the package for Python.
#   tools/release/reproducible.sh    on Linux
#   --no-dokka   without Dokka's pages, which take some minutes
# What differs is said, and both copies stay in target/reproducible.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd -P)
dokka=
case ${1:-} in
'') ;;
--no-dokka) dokka=--no-dokka ;;
*) echo "usage: tools/release/reproducible.sh [--no-dokka]" >&2 && exit 2 ;;
esac
work=$here/target/reproducible
rm -rf "$work"
mkdir -p "$work"
group=io/github/daphnis-sim

# build FOLDER DATE VARIABLE=VALUE…: a copy of what git has, and of what it does not know yet, built there.
build() {
    folder=$1
    mkdir -p "$folder"
    (cd "$here" && git ls-files -z --cached --others --exclude-standard | xargs -0 tar cf - --ignore-failed-read) |
        (cd "$folder" && tar xf - --no-same-permissions)
    cd "$folder"
    find . -exec touch -d "$2" {} +
    shift 2
    env "$@" tools/release/archives ${dokka:+"$dokka"} >/dev/null
    # As the script of the package does, whose tools are here already.
    env "$@" "$python" -m build --no-isolation --outdir target/release/python python >/dev/null
}

sums() {
    cd "$1"
    {
        find "target/release/repository/$group" -type f \( -name '*.jar' -o -name '*.pom' \)
        find target/daphnis-*.zip target/*.cdx.json target/release/python -type f
    } | sort | xargs sha256sum
}

"$here/tools/release/python-package" --tools
python=$here/target/release-python/bin/python
(umask 022 && build "$work/one" 2020-01-01 TZ=UTC LC_ALL=C)
(umask 077 && build "$work/of/another/name" 2024-07-07 TZ=Asia/Kolkata LC_ALL=C.UTF-8 \
    "JAVA_TOOL_OPTIONS=-Duser.language=de -Duser.country=DE")
(sums "$work/one") >"$work/first"
(sums "$work/of/another/name") >"$work/second"
count=$(wc -l <"$work/first")
[ "$count" -ge 15 ] || { echo "reproducible: only $count files" >&2 && exit 1; }
diff "$work/first" "$work/second" || { echo "reproducible: these differ" >&2 && exit 1; }
echo "reproducible: $count files are the same in both builds"
rm -rf "$work/one" "$work/of"
