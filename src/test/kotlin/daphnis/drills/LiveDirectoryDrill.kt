package daphnis.drills

import java.nio.file.Files
import java.util.Random
import kotlin.io.path.deleteRecursively
import kotlin.io.path.exists
import kotlin.io.path.name

/**
 * Whatever a user may type at the directory of a run that is under way: the run must not notice, and must come out as
 * if alone.
 */
internal object LiveDirectoryDrill : Drill {
    override val name = "live"
    override val what = "run --force, resume, analyze, export and compare at the directory of a run under way"
    override val cases = 30

    private const val COMMAND =
        "run cooling-gas --until 60 --set output.checkpointEvery=11 --set output.snapshotEvery=9 " +
            "--engine horizon --threads 2 --quiet --out"
    private val RUN = COMMAND.split(' ')

    /** Words after `daphnis`; LIVE stands for the directory, WHOLE for one like it that is done. */
    private val INTRUSIONS = listOf(
        "run cooling-gas --steps 3 --quiet --force --out LIVE",
        "run elastic-gas --steps 3 --quiet --out LIVE",
        "run cooling-gas --set restitution.coefficient=7 --quiet --force --out LIVE",
        "resume LIVE --quiet",
        "resume LIVE --quiet --until 99",
        "analyze LIVE --quiet --out seen",
        "export LIVE --format xyz --out exported",
        "compare LIVE WHOLE",
    )

    @OptIn(kotlin.io.path.ExperimentalPathApi::class)
    override fun run(cases: Int, seed: Long, say: (String) -> Unit): Tally {
        val random = Random(seed)
        val home = Files.createTempDirectory("daphnis-live")
        val lost = ArrayList<String>()
        var tried = 0
        try {
            val whole = home.resolve("whole")
            Program.succeed(home, *RUN.toTypedArray(), whole.name)
            while (tried < cases) {
                val live = home.resolve("live")
                val program = Program(home, "512m", RUN + live.name)
                while (program.isAlive && !live.resolve("checkpoint").exists()) Thread.sleep(1)
                var isOver = false
                while (program.isAlive && tried < cases) {
                    val intrusion = INTRUSIONS[random.nextInt(INTRUSIONS.size)]
                    val words = intrusion.replace("LIVE", "live").replace("WHOLE", "whole")
                    val ended = Program.run(home, *words.split(' ').toTypedArray())
                    // Perhaps the run had ended before the other one began, which then was allowed what it did.
                    isOver = !program.isAlive
                    if (isOver) break
                    tried++
                    judge(words, ended)?.let { lost += it }
                    say("${ended.code}: $words: ${ended.text.lines().firstOrNull().orEmpty()}")
                }
                val ended = program.await()
                if (ended.code != 0) lost += "the live run ended with ${ended.code}: ${ended.text}"
                if (!isOver) lost += RunFiles.differences(whole, live).map { "the live run: $it" }
                live.deleteRecursively()
            }
        } finally {
            home.deleteRecursively()
        }
        return Tally(tried, lost)
    }

    /** @return what is wrong with the answer */
    private fun judge(words: String, ended: Ended): String? {
        val writes = words.startsWith("run") || words.startsWith("resume")
        return when {
            ended.code == null -> "$words hangs"
            ended.hasTrace -> "$words: a trace: ${ended.text}"
            writes && ended.code == 0 -> "$words was let into a live run"
            writes && ended.text.trim().lines().size != 1 -> "$words: more than a line: ${ended.text}"
            else -> null
        }
    }
}
