package daphnis.drills

import java.nio.file.Files
import java.nio.file.Path
import java.util.Random
import kotlin.io.path.deleteRecursively
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/**
 * `kill -9` at moments drawn from the seed, by the clock or as soon as a file is half written, of runs and of their
 * resumes; then file by file against the unbroken run.
 */
internal object KillDrill : Drill {
    override val name = "kill"
    override val what = "kill -9 of runs and resumes of every engine, then the files against those of the unbroken run"
    override val cases = 60

    private const val ALWAYS = "output.checkpointEvery=7 output.snapshotEvery=9 output.transportEvery=2"
    private val SCENARIOS = listOf(
        "cooling-gas --until 12 $ALWAYS output.collisionLog=true particles.count=2000 box.lengths=[21.9,21.9,21.9]",
        "shear-cell --until 3 $ALWAYS",
        "ring-patch --until 20000 $ALWAYS box.lengths=[40,40,20]",
        "cooling-gas --until 12 $ALWAYS particles.count=2000 boundary={\"type\":\"walls\"} box.lengths=[24,24,24]",
    )
    private val ENGINES = listOf("horizon", "thread-pool", "actors", "pekko")

    /** [cases] counts kills. */
    @OptIn(kotlin.io.path.ExperimentalPathApi::class)
    override fun run(cases: Int, seed: Long, say: (String) -> Unit): Tally {
        val random = Random(seed)
        val home = Files.createTempDirectory("daphnis-kill")
        val lost = ArrayList<String>()
        var kills = 0
        var chains = 0
        try {
            while (kills < cases) {
                val which = chains % SCENARIOS.size
                val engine = ENGINES[(chains / SCENARIOS.size + chains) % ENGINES.size]
                val whole = home.resolve("whole-$which")
                if (!whole.exists()) Program.succeed(home, *command(which, "serial", whole.name))
                val chain = Chain(home, "killed-${chains++}", command(which, engine, "killed-${chains - 1}"), random)
                kills += chain.carryOn(minOf(MOST_IN_CHAIN, cases - kills))
                val bad =
                    chain.complaints +
                        if (chain.directory.exists()) {
                            RunFiles.differences(
                                whole,
                                chain.directory,
                            )
                        } else {
                            listOf("no run directory")
                        }
                val verdict = if (bad.isEmpty()) "same" else "LOST"
                say("$verdict: ${SCENARIOS[which].substringBefore(' ')} on $engine, ${chain.history}")
                lost += bad.map { "$which on $engine, ${chain.history}: $it" }
                chain.directory.deleteRecursively()
            }
        } finally {
            home.deleteRecursively()
        }
        return Tally(kills, lost, listOf("$kills kills in $chains runs"))
    }

    private fun command(which: Int, engine: String, out: String): Array<String> {
        val words = SCENARIOS[which].split(' ')
        val settings = words.drop(3).flatMap { listOf("--set", it) }
        return arrayOf(
            "run", *words.take(3).toTypedArray(), *settings.toTypedArray(),
            "--engine", engine, "--threads", threadsOf(engine), "--quiet", "--out", out,
        )
    }

    private const val MOST_IN_CHAIN = 5

    /** One run that is killed, resumed, killed again, and then let go to its end. */
    private class Chain(
        private val home: Path,
        name: String,
        private val start: Array<String>,
        private val random: Random,
    ) {
        val directory: Path = home.resolve(name)
        val complaints = ArrayList<String>()
        private val moments = ArrayList<String>()
        val history: String get() = moments.joinToString(", ")

        /** @return number of kills */
        fun carryOn(most: Int): Int {
            var kills = 0
            repeat(most) {
                if (!go(kill = true)) return kills
                kills++
            }
            repeat(MOST_TRIES) { if (!go(kill = false)) return kills }
            complaints += "does not come to an end"
            return kills
        }

        /** @return whether it was killed before its end, or has to begin anew */
        @OptIn(kotlin.io.path.ExperimentalPathApi::class)
        private fun go(kill: Boolean): Boolean {
            val isRun = directory.resolve("scenario.json").exists()
            // Killed before there was a run: whatever lies there is no run, and a user would take it away.
            if (!isRun && directory.exists()) directory.deleteRecursively()
            val arguments = if (isRun) listOf("resume", directory.name, "--quiet") else start.toList()
            val program = Program(home, "512m", arguments)
            if (kill) {
                val byFile = random.nextInt(2) == 0
                val after = 0.4 + 2.4 * random.nextDouble()
                while (program.isAlive &&
                    !(program.seconds > after && (!byFile || isHalfWritten() || program.seconds > after + PATIENCE))
                ) {
                    Thread.sleep(1)
                }
                if (program.isAlive) {
                    program.kill()
                    moments +=
                        "%s %.1f s%s".format(
                            java.util.Locale.ROOT,
                            arguments[0],
                            program.seconds,
                            if (byFile) " (half a file)" else "",
                        )
                    program.await()
                    return true
                }
            }
            val ended = program.await()
            if (ended.code != 0) {
                complaints += "${arguments[0]} ended with ${ended.code}: ${ended.text.trim().take(MOST_SAID)}"
            }
            if (ended.hasTrace) complaints += "a trace: ${ended.text.take(MOST_SAID)}"
            return false
        }

        private fun isHalfWritten(): Boolean = listOf(directory, directory.resolve("snapshots")).any { place ->
            try {
                place.listDirectoryEntries().any { it.name.endsWith(".tmp") || it.name.endsWith(".new") } ||
                    (place.resolve("checkpoint.previous").exists() && !place.resolve("checkpoint").exists())
            } catch (e: java.io.IOException) {
                false
            }
        }

        private companion object {
            const val MOST_TRIES = 3
            const val MOST_SAID = 300
            const val PATIENCE = 1.5
        }
    }
}
