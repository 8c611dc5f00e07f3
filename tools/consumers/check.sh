#!/bin/sh
# daphnis as programs of others get it: published to a folder, and used from there by the small projects beside this
# file.
#   --gradle   Gradle's build too; it needs Gradle 8.7 or newer
#   --javadoc  the jars of Dokka too, as a release has them, which takes some minutes
set -eu
here=$(CDPATH= cd -- "$(dirname -- "$0")/../.." && pwd)
work=$(mktemp -d "${TMPDIR:-/tmp}/daphnis-consumers.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 130' HUP INT TERM
die() {
    echo "consumers: $*" >&2
    exit 1
}

version=$(cat "$here/core/src/main/resources/daphnis/version.txt")
group=io/github/daphnis-sim
pin=$(sed -n 's/^ring-patch,6,//p' "$here/src/test/resources/golden/digests.csv")
[ -n "$pin" ] || die "no pinned digest of ring-patch after 6 steps"

gradle=
javadoc=
for arg; do
    case $arg in
    --gradle) gradle=yes ;;
    --javadoc) javadoc=yes ;;
    *) die "unknown option $arg; known: --gradle, --javadoc" ;;
    esac
done

# What Maven has stored, without daphnis: the programs below get what is published here and nothing of another build.
# A user's settings.xml may name another place for it, so Maven is asked.
(cd "$here" && mvn -B -ntp -q -N exec:exec -Dexec.executable=echo '-Dexec.args=${session.localRepository.basedir}' \
    "-Dexec.outputFile=$work/kept")
kept=$(cat "$work/kept")
[ -d "$kept" ] || die "Maven names no local repository: $kept"
store=$work/store
mkdir -p "$store/io/github"
for place in "$kept"/* "$kept"/io/* "$kept"/io/github/*; do
    name=${place#"$kept"/}
    case $name in io | io/github | "$group") continue ;; esac
    [ ! -e "$place" ] || ln -s "$place" "$store/$name"
done
maven() { mvn -B -ntp -q "-Dmaven.repo.local=$store" "$@"; }

# That the jar $1 of Dokka has pages, and says what the code does where $2 is core.
has_pages() {
    [ -s "$1" ] || die "no $1"
    jar tf "$1" | grep -q '^daphnis/.*package-summary.html' || die "$1 has no page of a package"
    [ "$2" = core ] || return 0
    (cd "$work" && jar xf "$1" daphnis/core/Simulation.html)
    grep -q 'advanced one step at a time' "$work/daphnis/core/Simulation.html" || die "$1 says nothing of Simulation"
}

# That the folder $1 holds what a release does; its libraries are modules, and the command line has the name of one.
holds_a_release() {
    for pair in core:core actors:actors analysis:analysis plots:plots cli:app; do
        name=daphnis-${pair%:*}
        start=$1/$group/$name/$version/$name-$version
        for file in "$start.jar" "$start-sources.jar" "$start.pom"; do [ -s "$file" ] || die "no $file"; done
        for part in name description url license developer scm; do
            grep -q "<$part[ >]" "$start.pom" || die "$start.pom has no <$part>"
        done
        ! grep -q '<parent>' "$start.pom" || die "$start.pom does not stand alone"
        kind=jar:
        [ "${pair#*:}" != app ] || kind=automatic
        jar --describe-module --file "$start.jar" | grep -q "^daphnis\.${pair#*:}@$version $kind" ||
            die "$start.jar is no module daphnis.${pair#*:}"
        [ ! "$javadoc" ] || has_pages "$start-javadoc.jar" "${pair#*:}"
    done
    sources=$1/$group/daphnis-core/$version/daphnis-core-$version-sources.jar
    for source in HorizonEngine.kt VectorFilter.java; do
        jar tf "$sources" | grep -q "$source" || die "$sources has no $source"
    done
    grep -q '<dependencyManagement>' "$1/$group/daphnis-bom/$version/daphnis-bom-$version.pom" || die "no BOM in $1"
    [ "$(ls "$1/$group" | wc -l)" -eq 6 ] || die "more than a release in $1: $(ls "$1/$group")"
}

# That a program, whose libraries lie in $1, printed $2 as it should and needs nothing for plots and actors.
is_right() {
    [ "$(printf '%s\n' "$2" | tail -n 1)" = "$pin" ] || die "another digest: $2"
    ! ls "$1" | grep -iE 'batik|lets-plot|jcodec|pekko|coroutines|daphnis-plots' || die "superfluous libraries in $1"
}

cd "$here"
# With the repository in use, so that what is compiled already is not compiled again.
mvn -B -ntp -q -Prelease "-DskipDokka=$([ $javadoc ] || echo true)" -Dmaven.test.skip=true -Dmaven.install.skip=true \
    -Dkotlin.compiler.incremental=true -pl '!bench' deploy "-DaltDeploymentRepository=folder::file:$work/maven"
holds_a_release "$work/maven"

cp -R "$here/tools/consumers/kotlin" "$here/tools/consumers/java" "$work"
for consumer in kotlin java; do
    cd "$work/$consumer"
    maven package "-Dpublished=file:$work/maven" "-Ddaphnis=$version"
done
is_right "$work/kotlin/target/lib" "$(java -cp "$work/kotlin/target/consumer.jar:$work/kotlin/target/lib/*" RingKt)"
path=$work/java/target/consumer.jar:$work/java/target/lib
is_right "$work/java/target/lib" "$(java -p "$path" -m consumer/consumer.Ring)"

if [ "$gradle" ]; then
    cd "$here"
    gradle --console=plain -q --warning-mode=fail publish ${javadoc:+-Prelease} "-PpublishTo=$work/gradle"
    holds_a_release "$work/gradle"
    cd "$work/kotlin"
    gradle --console=plain -q lib "-Ppublished=file:$work/gradle" "-Pdaphnis=$version"
    is_right "$work/kotlin/build/lib" "$(java -cp "$work/kotlin/build/lib/*" RingKt)"
fi
echo "consumers: ok"
