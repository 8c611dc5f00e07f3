#!/bin/sh
# The command line as a user types it: run, kill -9, resume, compare, Ctrl-C, a full disk's cousin (an unwritable place), exports.
#   tools/smoke-test.sh quick   without what builds, what damages the archive of classes, and the distribution
set -eu
quick=${1:-}
here=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd)
work=$(mktemp -d "${TMPDIR:-/tmp}/daphnis-smoke.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"
# In the background the script itself is called, so that $! is the process that becomes the JVM.
daphnis() { "$here/daphnis" "$@"; }
die() {
    echo "smoke test: $*" >&2
    exit 1
}

daphnis scenarios >list
grep -q '^paper-figure-1 ' list || die "scenarios does not list paper-figure-1"

# Through a chain of links, one of them relative, in a directory with a space, from elsewhere.
says=$("$here/daphnis" --version)
mkdir -p "links of a user/bin"
ln -s "$here/daphnis" "links of a user/first"
ln -s ../first "links of a user/bin/daphnis"
[ "$(cd / && PATH="$work/links of a user/bin:$PATH" sh -c 'daphnis --version' 2>&1)" = "$says" ] || die "not found through links on the PATH"

if [ "$quick" != quick ]; then
    # Two that find an old build make one, one after the other; a build that was killed is in nobody's way.
    ln -s "$(uname -n)$(readlink /proc/self/ns/pid 2>/dev/null || :) 999999999" "$here/target/.building" || die "a build is under way"
    touch "$here/pom.xml"
    "$here/daphnis" --version >one 2>one.err &
    first=$!
    "$here/daphnis" --version >two 2>two.err || die "two at once: $(cat one.err two.err)"
    wait $first || die "two at once: $(cat one.err two.err)"
    [ "$(cat one)" = "$says" ] && [ "$(cat two)" = "$says" ] || die "two at once: $(cat one one.err two two.err)"
    [ "$(cat one.err two.err | grep -c 'building with')" = 1 ] || die "two builds at once: $(cat one.err two.err)"
    [ ! -L "$here/target/.building" ] || die "the mark of a build is left"

    # What the shared classes look like must not matter: cut short, other bytes, empty, not there.
    for damage in 'head -c 1000000' "tr '[:lower:]' x" 'head -c 0' false; do
        archive=$(find "$here/target" "$here/build/install" -name 'daphnis-*.jsa' 2>/dev/null | head -n 1)
        [ -n "$archive" ] || break
        eval "$damage" <"$archive" >damaged || rm -f damaged "$archive.stamp"
        rm -f "$archive"
        if [ -f damaged ]; then mv damaged "$archive"; fi
        [ "$("$here/daphnis" --version 2>&1)" = "$says" ] || die "a damaged archive of classes is noticed by its user ($damage)"
    done
fi

# The distribution that mvn -Pdist leaves: unpacked in a directory with a space, through a link, with any Java.
zip=$here/target/daphnis-$(cat "$here/core/src/main/resources/daphnis/version.txt").zip
if [ "$quick" != quick ] && [ -f "$zip" ]; then
    unzip -q "$zip" -d "un packed"
    home=$(echo "$work/un packed"/daphnis-*)
    ln -s "$home/bin/daphnis" "links of a user/bin/unpacked"
    unpacked() { "$work/links of a user/bin/unpacked" "$@"; }
    unpacked describe cooling-gas | grep -q '^particles' || die "the distribution does not describe"
    unpacked --debug run cooling-gas --steps 2 --quiet --out "of zip" >/dev/null || die "the distribution does not run"
    daphnis run cooling-gas --steps 2 --quiet --out "of checkout" >/dev/null
    daphnis compare "of zip" "of checkout" >/dev/null || die "the distribution computes something else"
    # The first start laid classes out, and later ones use that.
    JAVA_OPTS=-Xlog:class+load:file=loaded unpacked --version >/dev/null
    grep -q 'shared objects file (top)' loaded || die "the distribution does not use its layout of classes"
    # So it is in a copy, whose files have other times and lie elsewhere.
    cp -r "$home" copied
    copied/bin/daphnis --version >/dev/null
    JAVA_OPTS=-Xlog:class+load:file=loaded copied/bin/daphnis --version >/dev/null
    grep -q 'shared objects file (top)' loaded || die "a copy of the distribution does not use a layout of classes"
    for shell in bash zsh fish; do
        unpacked completion $shell | cmp -s - "$home/completions/daphnis.$shell" || die "completion for $shell"
    done
    bash -n "$home/completions/daphnis.bash" || die "completion for bash"
    code=0
    JAVA_HOME=/nowhere unpacked --version 2>err || code=$?
    [ $code -eq 1 ] && [ "$(wc -l <err)" -eq 1 ] && grep -q 'JAVA_HOME is /nowhere' err || die "a wrong JAVA_HOME"
else
    echo "smoke test: no $zip (mvn -Pdist -DskipTests -pl src -am package): it is left out"
fi

gas="run elastic-gas --until 60 --set output.checkpointEvery=20 --quiet"
daphnis $gas --out whole >/dev/null

# kill -9 in the middle, several times, until it has ended
"$here/daphnis" $gas --out killed >/dev/null 2>&1 &
pid=$!
until [ -f killed/checkpoint ]; do sleep 0.1; done
kill -9 $pid 2>/dev/null || true
wait $pid 2>/dev/null || true
tries=0
until [ -f killed/summary.json ]; do
    tries=$((tries + 1))
    [ $tries -lt 20 ] || die "never ends when killed"
    "$here/daphnis" resume killed --quiet >/dev/null 2>&1 &
    pid=$!
    if [ $tries -lt 3 ]; then
        sleep 1
        kill -9 $pid 2>/dev/null || true
    fi
    wait $pid 2>/dev/null || true
done
daphnis compare whole killed | grep -q '^identical' || die "a killed and resumed run differs"
cmp whole/series.csv killed/series.csv || die "the series of a killed and resumed run differs"

# Ctrl-C: a checkpoint and exit code 130 (INT is ignored in background jobs of sh, TERM is not)
"$here/daphnis" run elastic-gas --until 1000 --quiet --out stopped >out 2>&1 &
pid=$!
until [ -f stopped/checkpoint ]; do sleep 0.2; done
sleep 1
kill -TERM $pid
code=0
wait $pid || code=$?
[ $code -eq 130 ] || die "interrupted: exit code $code instead of 130"
grep -q 'continue with: .*daphnis.* resume' out || die "interrupted: does not say how to go on"

# The same for timings
"$here/daphnis" bench cooling-gas --steps 3 --engines serial --warm-up 0 --rounds 100000 --quiet --out timings >out 2>&1 &
pid=$!
until [ -s timings/bench.csv ] || ! kill -0 $pid 2>/dev/null; do sleep 0.2; done
sleep 1
kill -TERM $pid
wait $pid || true
grep -q '^daphnis: interrupted: the rounds that are done are in timings$' out || die "bench, interrupted: says $(cat out)"

code=0
daphnis run elastic-gas --set until=-1 --out bad 2>err || code=$?
[ $code -eq 2 ] || die "wrong input: exit code $code instead of 2"
[ "$(wc -l <err)" -eq 1 ] || die "wrong input: not one line"
[ ! -e bad ] || die "wrong input: left a directory"

for format in xyz vtp h5md cartandrad; do daphnis export whole --format $format >/dev/null; done
daphnis run ring-patch --set untilOrbits=1 --set 'box.lengths=[60,60,20]' --quiet --out ring >/dev/null
daphnis analyze ring --quiet | grep -q 'ring/report.html' || die "analyze does not say where the report is"
[ -s ring/report.html ] && [ -s ring/tables/streamlines-x.csv ] && [ -s ring/plots/patch-above.png ] || die "analyze left something out"
daphnis export ring --format xyz >/dev/null
daphnis analyze ring/export/trajectory.xyz --scenario ring/scenario.json --quiet >/dev/null || die "analyze does not read an exported file"
code=0
daphnis analyze nowhere 2>err || code=$?
[ $code -eq 2 ] && [ "$(wc -l <err)" -eq 1 ] || die "analyze of nothing: exit code $code, or not one line"

[ -s whole/plots/run.png ] && [ -s whole/plots/run.svg ] || die "no plot"
echo "smoke test: ok"
