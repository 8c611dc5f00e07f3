package daphnis.app.printing

import daphnis.core.cluster.FleetException
import daphnis.core.format.FormatException
import daphnis.core.format.reasonOf
import daphnis.core.input.InputException
import daphnis.core.input.WayOut
import daphnis.core.run.RunException
import java.io.IOException
import java.nio.file.InvalidPathException

/** What went wrong, as a user of the command line is told. */
internal fun reasonInWords(e: Throwable): String = when (e) {
    is InputException -> inFlags(e)
    is FormatException, is FleetException, is RunException -> e.message.orEmpty()
    is InvalidPathException -> {
        "${e.input}: cannot be a path here: ${e.reason}; names beyond ASCII need a locale with UTF-8"
    }
    is IOException -> reasonOf(e)
    is OutOfMemoryError -> {
        val heap = Runtime.getRuntime().maxMemory() shr 20
        "not enough memory (the JVM has $heap MiB); raise it with JAVA_OPTS=-Xmx…"
    }
    is StackOverflowError -> "not enough stack; raise it with JAVA_OPTS=-Xss…, or the input is nested too deeply"
    is LinkageError -> if (isOfPekko(e)) {
        "this installation has no Pekko, which nodes and the engine pekko need; any other engine gives the same bits"
    } else {
        "a part of daphnis or of Java is missing: ${words(e.cause ?: e)}; build it again, or use a whole JDK"
    }
    else -> "unexpected ${words(e)}; this is a fault of daphnis, $DEBUG shows where"
}

/** Whether what is missing are the libraries that the package for Python leaves out. */
private fun isOfPekko(e: LinkageError): Boolean = listOf("org.apache.pekko.", "com.typesafe.", "scala.").any {
    (e.cause?.message ?: e.message).orEmpty().replace('/', '.').startsWith(it)
}

/** The message of [e] in the words of the command line: arguments and ways out are flags. */
private fun inFlags(e: InputException): String {
    val source = if (e.isArgument) FLAGS[e.source] ?: "--${e.source}" else e.source
    return e.message(source, e.wayOut?.let(::inFlags))
}

private fun inFlags(wayOut: WayOut): String = when (wayOut) {
    WayOut.ANOTHER_DIRECTORY -> "give another directory with --out"
    WayOut.REPLACE_RUN -> "give another directory with --out, or --force to replace the run in it"
    WayOut.ONLY_RUNS_ARE_REPLACED -> "--force replaces runs only"
    WayOut.RESUME_WITH_LOSS, WayOut.BEGIN_ANEW -> "${wayOut.words}: resume --accept-loss"
    WayOut.ANALYSE_WITH_LOSS -> "${wayOut.words}: analyze --accept-loss"
    WayOut.TLS_OR_INSECURE -> {
        "set daphnis.cluster.tls in a settings file (--config), or add --insecure where the network is trusted"
    }
    WayOut.AWAIT_OTHER -> wayOut.words
    WayOut.WRITE_SNAPSHOTS -> "run with --set output.snapshotEvery=10, for example"
    WayOut.GIVE_TIME_STEP -> "give --time-step DT"
    WayOut.GIVE_SCENARIO -> "give --scenario"
}

/** A [notice] on what is analysed, which ends with the way out if there is one, in the words of the command line. */
internal fun noticeInFlags(notice: String): String {
    val wayOut = listOf(WayOut.GIVE_TIME_STEP, WayOut.GIVE_SCENARIO).find { notice.endsWith(it.words) } ?: return notice
    return notice.removeSuffix(wayOut.words) + inFlags(wayOut)
}

/** Arguments whose flag has another name. */
private val FLAGS = mapOf(
    "settings" to "--set",
    "timeStep" to "--time-step",
    "scanPath" to "--scan-path",
    "clusterRatio" to "--cluster-ratio",
    "lightElevation" to "--light-elevation",
    "phaseAngle" to "--phase-angle",
    "phaseAngles" to "--phase-angles",
    "phaseFunction" to "--phase-function",
    "observedBrightness" to "--observed-brightness",
)

private fun words(e: Throwable) = e.javaClass.simpleName + e.message?.let { ": $it" }.orEmpty()

/** Anywhere among the words: what went wrong is shown with its stack trace. */
internal const val DEBUG = "--debug"
