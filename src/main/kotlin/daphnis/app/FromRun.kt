package daphnis.app

import daphnis.core.format.Snapshot
import daphnis.core.input.InputException
import daphnis.core.run.RecordedRun
import daphnis.core.run.Run
import daphnis.core.run.RunOrigin
import daphnis.core.scenario.FrameSetup
import java.nio.file.Files

/**
 * The state that a word of the command line means: `RUN`, the last state of a run directory, or `RUN@STEP`,
 * `RUN@time=T`, `RUN@orbits=T`.
 */
internal fun originNamed(word: String): RunOrigin {
    val whole = pathOf(word, FROM)
    if ('@' !in word || Files.exists(whole)) return open(word).let { RunOrigin(it, it.last()) }
    val run = open(word.substringBeforeLast('@'))
    return RunOrigin(run, stateOf(run, word.substringAfterLast('@')))
}

private fun open(word: String): RecordedRun {
    val path = pathOf(word, FROM)
    if (Files.isRegularFile(path)) {
        throw InputException(FROM, null, "$word is a file; a run directory is needed, or placement.path in a scenario")
    }
    return Run.open(path)
}

private fun stateOf(run: RecordedRun, place: String): Snapshot {
    val key = place.substringBefore('=')
    val value = place.substringAfter('=', "")
    return when (key) {
        "time" -> run.at(number(value, place))
        "orbits" -> run.at(number(value, place) * orbit(run))
        else -> run.atStep(place.toLongOrNull()?.takeIf { it >= 0 } ?: unknown(place))
    }
}

private fun number(text: String, place: String): Double =
    text.toDoubleOrNull()?.takeIf { it.isFinite() } ?: unknown(place)

private fun orbit(run: RecordedRun): Double {
    val source = run.directory.scenario.toString()
    val omega = run.scenario()?.let { FrameSetup.angularSpeed(it, source) }
        ?: throw InputException(FROM, null, "@orbits= needs a run in a frame of type hill; give @time= or a step")
    return 2 * Math.PI / omega
}

private fun unknown(place: String): Nothing =
    throw InputException(FROM, null, "'@$place' must be a step, such as @20, or a time, @time=2.5 or @orbits=2.5")

internal const val FROM = "--from"
