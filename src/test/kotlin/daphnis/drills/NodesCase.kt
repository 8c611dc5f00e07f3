package daphnis.drills

import java.nio.file.Files
import java.nio.file.Path
import java.util.Locale
import java.util.Random
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.deleteRecursively
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/** One run over nodes and what is done to it, drawn from [random]; its files are compared with those of [whole]. */
internal class NodesCase(
    private val home: Path,
    private val scenario: NodesScenario,
    private val whole: Path,
    private val random: Random,
) {
    private val directory = home.resolve("run")
    private val count = 2 + random.nextInt(3)
    private val nodes = NodeProcesses(home, count)
    private val complaints = ArrayList<String>()
    private val moments = ArrayList<String>()
    private val expectedRows = Files.size(whole.resolve(ROWS))
    private lateinit var run: Program

    /** For how many nodes the run waits before it begins. */
    private var wanted = 0

    /** Whether the run was told to end, killed, or stopped for so long that others may have given it up. */
    private var isExcused = false

    /** How many strikes have hit a run under way. */
    var strikes = 0
        private set

    /** What was done, in words. */
    val history: String get() = "$scenario on $count nodes: ${moments.joinToString(", ").ifEmpty { "nothing done" }}"

    /** @return what was wrong */
    @OptIn(ExperimentalPathApi::class)
    fun play(most: Int): List<String> {
        begin(count)
        try {
            for (k in 0..<most) {
                if (!awaitMoment()) break
                strike(NodesStrike.entries[random.nextInt(NodesStrike.entries.size)])
                strikes++
                continueRun()
            }
            carryOnToTheEnd()
        } finally {
            complaints += nodes.end()
            run.kill()
        }
        if (complaints.isEmpty()) complaints += RunFiles.differences(whole, directory)
        directory.deleteRecursively()
        return complaints
    }

    /** Starts the run, or continues it on [on] nodes; 0 is one engine. */
    @OptIn(ExperimentalPathApi::class)
    private fun begin(on: Int) {
        isExcused = false
        wanted = on
        val isRun = directory.resolve("scenario.json").exists()
        // Ended before there was a run: a user would take away what lies there.
        if (!isRun && directory.exists()) directory.deleteRecursively()
        val cluster = listOf("--cluster", nodes.addresses, "--config", "${nodes.config}", "--nodes", "$on")
        val options = if (on == 0) emptyList() else cluster
        val words = if (isRun) {
            listOf("resume", directory.name) + options
        } else {
            scenario.command("--out", directory.name) + if (on == 0) listOf("--engine", "serial") else options
        }
        if (isRun) moments += "resume on $on"
        run = Program(home, HEAP, words + "--quiet")
    }

    /** @return false when the run has ended before */
    private fun awaitMoment(): Boolean {
        val moment = NodesMoment.entries[random.nextInt(NodesMoment.entries.size)]
        val part = random.nextDouble()
        val end = run.seconds + LONGEST
        while (run.isAlive && run.seconds < end && !isNow(moment, part)) {
            startMissing()
            Thread.sleep(2)
        }
        if (!run.isAlive) return false
        if (run.seconds >= end) complaints += "no moment '${moment.words}' within $LONGEST s"
        moments += "%s after %.1f s".format(Locale.ROOT, moment.words, run.seconds)
        return true
    }

    private fun isNow(moment: NodesMoment, part: Double): Boolean = when (moment) {
        NodesMoment.EARLY -> run.seconds > EARLY * part
        NodesMoment.AT_A_ROW -> rows() > part
        NodesMoment.HALF_A_FILE -> (rows() > part && isHalfWritten()) || rows() > LATE
        NodesMoment.LATE -> rows() > LATE && random.nextInt(LATE_SLEEPS) == 0
    }

    /** The part of the rows that is there. */
    private fun rows(): Double {
        val file = directory.resolve(ROWS)
        return if (file.exists()) Files.size(file) / expectedRows.toDouble() else 0.0
    }

    private fun isHalfWritten(): Boolean = listOf(directory, directory.resolve("snapshots")).any { place ->
        try {
            place.listDirectoryEntries().any { it.name.endsWith(".tmp") || it.name.endsWith(".new") }
        } catch (_: java.io.IOException) {
            false
        }
    }

    private fun strike(strike: NodesStrike) {
        moments += strike.words
        when (strike) {
            NodesStrike.KILL_ONE -> some(1).forEach { it.program.kill() }
            NodesStrike.KILL_TWO -> some(2).forEach {
                it.program.kill()
                pause(0.0, 1.5)
            }
            NodesStrike.KILL_ALL_BUT_ONE -> some(nodes.living.size - 1).forEach { it.program.kill() }
            NodesStrike.KILL_ALL -> nodes.living.forEach { it.program.kill() }
            NodesStrike.STOP_SHORT -> some(1).forEach { stop(it.program, NodeProcesses.PAUSE) }
            NodesStrike.STOP_LONG -> some(1).forEach { node ->
                node.isGivenUp = true
                stop(node.program, NodeProcesses.LOST)
            }
            NodesStrike.STOP_RUN_SHORT -> stop(run, NodeProcesses.PAUSE)
            NodesStrike.STOP_RUN_LONG -> stop(run, NodeProcesses.LOST)
            NodesStrike.COME -> nodes.come(anew = random.nextBoolean())
            NodesStrike.TERMINATE_ONE -> some(1).forEach { it.program.terminate() }
            NodesStrike.TERMINATE_ALL_BUT_ONE -> some(nodes.living.size - 1).forEach { it.program.terminate() }
            NodesStrike.KILL_RUN -> {
                isExcused = true
                run.kill()
            }
            NodesStrike.TERMINATE_RUN -> {
                isExcused = true
                run.terminate()
            }
        }
    }

    private fun some(number: Int) = nodes.living.shuffled(random).take(maxOf(0, number))

    private fun stop(program: Program, seconds: Double) {
        program.signal("STOP")
        if (seconds > NodeProcesses.PAUSE) pause(seconds, seconds + 2) else pause(0.0, seconds)
        program.signal("CONT")
    }

    private fun pause(from: Double, to: Double) =
        Thread.sleep(((from + (to - from) * random.nextDouble()) * 1e3).toLong())

    /** A user continues a run that was ended. */
    private fun continueRun() {
        if (isExcused) {
            judgeEnd(run.await(LONGEST))
            if (isExcused) begin(random.nextInt(count + 1))
        }
    }

    /** A user starts a node where none is left, and as many as the run waits for before it begins. */
    private fun startMissing() {
        val few = nodes.living.size < wanted && !hasBegun
        if (!run.isAlive || wanted == 0 || !(few || nodes.living.isEmpty())) return
        moments += "start one"
        nodes.come(anew = false)
    }

    private val hasBegun: Boolean get() = "the loss of nodes costs" in run.said

    private fun carryOnToTheEnd() {
        repeat(MOST_TRIES) {
            // A node that was told to end may do so only now.
            while (run.isAlive && run.seconds < LONGEST) {
                startMissing()
                Thread.sleep(50)
            }
            val ended = run.await(1.0)
            judgeEnd(ended)
            if (!isExcused || ended.code == 0) return
            begin(minOf(1, nodes.living.size))
        }
    }

    /** Afterwards the run is excused only if it must be continued. */
    private fun judgeEnd(ended: Ended) {
        val said = ended.text.trim().takeLast(MOST_SAID)
        when {
            ended.code == null -> complaints += "the run hangs: $said"
            ended.hasTrace -> complaints += "a trace: $said"
            ended.code == 0 -> isExcused = false
            !isExcused -> complaints += "the run ended with ${ended.code}: $said"
            ended.code !in EXCUSED -> complaints += "the run that was told to end ended with ${ended.code}: $said"
        }
    }

    private companion object {
        const val ROWS = "series.csv"
        const val HEAP = "128m"
        const val LONGEST = 300.0
        const val EARLY = 6.0
        const val LATE = 0.95
        const val LATE_SLEEPS = 300
        const val MOST_TRIES = 3
        const val MOST_SAID = 900

        /** By SIGKILL, by SIGTERM before there was a run, and after a checkpoint. */
        val EXCUSED = setOf(137, 143, 130)
    }
}
