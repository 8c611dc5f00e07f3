# How daphnis is started, for ./daphnis of a checkout and bin/daphnis of a distribution: POSIX sh, read with `.`.
# Sets java, release and major (find_java), then becomes the JVM (launch).
# shellcheck shell=sh

# The file that $1 stands for after symbolic links, which may be relative and chained; readlink -f is not everywhere.
real() {
    file=$1
    while [ -L "$file" ]; do
        target=$(readlink "$file")
        case $target in
        /*) file=$target ;;
        *) file=$(dirname -- "$file")/$target ;;
        esac
    done
    printf '%s\n' "$file"
}

fail() {
    echo "daphnis: $*" >&2
    exit 1
}

# Finds Java: $1, the one of an image, if it is there; else that of JAVA_HOME; else the one on the PATH.
find_java() {
    if [ -x "${1:-}" ]; then
        java=$1
    elif [ -n "${JAVA_HOME:-}" ]; then
        java=$JAVA_HOME/bin/java
        [ -f "$java" ] && [ -x "$java" ] || fail "JAVA_HOME is $JAVA_HOME, where no bin/java is; mend it, or unset it"
    else
        java=$(command -v java) || fail "no java found; install Java 17 or newer, or set JAVA_HOME"
    fi
    # The file `release` of a JDK says its version without the start of a JVM.
    release=$(dirname -- "$(real "$java")")/../release
    major=$(sed -n 's/^JAVA_VERSION="\(1\.\)\{0,1\}\([0-9]*\).*/\2/p' "$release" 2>/dev/null | head -n 1)
    [ -n "$major" ] || major=$("$java" -version 2>&1 | sed -n 's/.*version "\(1\.\)\{0,1\}\([0-9]*\).*/\2/p' | head -n 1)
    [ "${major:-0}" -ge 17 ] || fail "$java is version ${major:-unknown}; 17 or newer is needed"
}

# The command among the words of a command line: options of the program itself may stand before it.
command_of() {
    for word; do
        case $word in
        -*) ;;
        *)
            printf '%s\n' "$word"
            return
            ;;
        esac
    done
}

# What an archive belongs to: its own length, since a JVM dies of one cut short, and the jars of daphnis. The JVM compares
# only times and lengths of jars, and those of two builds of one version may be the same.
content() {
    wc -c <"$archive"
    cat "$jar" "$(dirname -- "$jar")"/lib/daphnis*.jar 2>/dev/null | cksum
}

# When the jar was written, and where it lies: no JVM takes an archive after a copy that sets new times, and that of JDK
# 17 none that was moved.
place() {
    stat -c %Y -- "$jar" 2>/dev/null || stat -f %m -- "$jar" 2>/dev/null || echo
    printf '%s\n' "$jar"
}

# Whether the archive is of these jars. An empty one says that this Java makes none.
archived() {
    [ -f "$archive" ] && [ "$(head -n 2 "$archive.stamp" 2>/dev/null)" = "$(content)" ]
}

# Whether one more try would make no better one.
settled() {
    archived && [ "$(tail -n +3 "$archive.stamp")" = "$(place)" ]
}

# Makes the archive in a run of a few steps, out of sight. $1 is the flag of the vector unit, which runs have, or empty.
train() (
    work=$(mktemp -d "${TMPDIR:-/tmp}/daphnis-train.XXXXXX") || exit
    trap 'rm -rf "$work" "$archive.$$"' EXIT
    trap 'exit 130' INT TERM
    "$java" "-XX:ArchiveClassesAtExit=$archive.$$" ${1:+"$1"} -jar "$jar" run cooling-gas --steps 2 --out "$work/run"
    "$java" -jar "$jar" --version >"$work/plain"
    "$java" -XX:+VerifySharedSpaces "-XX:SharedArchiveFile=$archive.$$" '-Xlog:cds*=off' '-Xlog:class+path=off' \
        -jar "$jar" --version >"$work/shared"
    cmp -s "$work/plain" "$work/shared" && [ -s "$work/plain" ] || : >"$archive.$$"
    mv -f "$archive.$$" "$archive" && { content && place; } >"$archive.stamp"
) >/dev/null 2>&1 </dev/null

# Fewer open files are not enough for the libraries and a report.
fewest_files=128

# Whether the options of the JVM give the heap a size of the form $1, an extended regular expression.
names_heap() {
    printf '%s\n' "$options" | grep -Eq -- "-Xmx($1)( |\$)"
}

# Becomes the JVM that runs the jar $1, which knows its libraries, with the command line that follows. JAVA_OPTS reaches
# the JVM.
launch() {
    jar=$1
    shift
    command=$(command_of "$@")
    options="${JAVA_OPTS:-} ${JAVA_TOOL_OPTIONS:-} ${JDK_JAVA_OPTIONS:-}"

    # Java opens all libraries at once and dies of a limit below their number; it raises a soft limit itself.
    files=$(ulimit -H -n 2>/dev/null || echo unlimited)
    [ "$files" = unlimited ] || [ "$files" -ge $fewest_files ] ||
        fail "the limit of open files is $files, and $fewest_files are needed at least; set it with ulimit -n"

    # A run keeps a few large arrays and makes little garbage: for that the serial collector takes the least memory and
    # time. The heap grows from little, and all but 64 MB of it may be arrays. Who names a collector gets that one.
    collector=
    growing='-XX:MaxNewSize=64m'
    least=-Xms8m
    # A heap no larger than that would make the JVM warn, or end in words of its own.
    if names_heap '[0-9]{1,2}[mM]|[0-9]{1,5}[kK]|[0-9]{1,8}'; then
        growing=
        least=
        ! names_heap '[0-7][mM]|[0-9]{1,4}[kK]|[0-9]{1,7}' ||
            fail "not enough memory (JAVA_OPTS has less than 8 MB for the JVM); raise it with JAVA_OPTS=-Xmx…"
    fi
    case $command in
    # An analysis is much code that runs for a moment: the second compiler, which begins a hundred times later than usual
    # here, is for loops over many particles only. A collector with threads of its own would cost more than it gives.
    analyze)
        collector='-XX:Tier4InvocationThreshold=500000 -XX:Tier4MinInvocationThreshold=60000'
        collector="$collector -XX:Tier4CompileThreshold=1500000 -XX:Tier4BackEdgeThreshold=4000000"
        case $options in
        *-XX:+Use*GC*) ;;
        *) collector="$collector -XX:+UseSerialGC" ;;
        esac
        ;;
    export | compare | movie) ;;
    *)
        case $options in
        *-XX:+Use*GC*) ;;
        *) collector="-XX:+UseSerialGC $growing" ;;
        esac
        ;;
    esac

    # What takes steps uses the vector unit where this Java is good at it and has the module for it. The JVM then writes
    # a line of its own to the error stream, which nobody can turn off. DAPHNIS_VECTOR=no goes without.
    unit=
    if [ "$major" -ge 25 ] && grep -q '^MODULES=.*jdk\.incubator\.vector' "$release" 2>/dev/null; then
        unit=--add-modules=jdk.incubator.vector
    fi
    vector=
    case $command in
    run | resume | bench | sweep) [ "${DAPHNIS_VECTOR:-}" = no ] || vector=$unit ;;
    esac

    # Class-data sharing: the classes of all libraries as they were laid out once, for this Java and this jar, which
    # saves half of a start. The JVM goes without when the archive does not fit or is damaged. Whatever fails here stops
    # no run.
    archive=$(dirname -- "$jar")/daphnis-$major-$(cat "$release" 2>/dev/null | cksum | tr -cd '0-9').jsa
    if [ -w "$(dirname -- "$jar")" ] && ! settled; then train "$unit" || true; fi
    shared=
    if archived && [ -s "$archive" ]; then shared=yes; fi

    # By which name it was called, for what it says to be typed next: alone where the shell finds that.
    called=$0
    [ "$(command -v -- "${0##*/}" 2>/dev/null)" != "$0" ] || called=${0##*/}

    # Ingredients of other libraries, see docs/internals/adding.md.
    if [ -n "${DAPHNIS_CLASSPATH:-}" ]; then
        set -- "-Ddaphnis.called=$called" -cp "$jar:$DAPHNIS_CLASSPATH" daphnis.app.MainKt "$@"
    else
        set -- "-Ddaphnis.called=$called" -jar "$jar" "$@"
    fi
    # Words of options, but no names of files: nothing that looks for files may follow.
    set -f
    # shellcheck disable=SC2086
    set -- $least $collector $vector ${JAVA_OPTS:-} "$@"
    if [ "$shared" ]; then
        set -- -XX:+VerifySharedSpaces "-XX:SharedArchiveFile=$archive" '-Xlog:cds*=off' '-Xlog:class+path=off' "$@"
    fi
    # Pekko uses sun.misc.Unsafe, of which JDK 24 and newer would warn in four lines; older ones do not know the
    # property.
    exec "$java" -Dsun.misc.unsafe.memory.access=allow "$@"
}
