package daphnis.drills

import java.nio.file.Files
import java.nio.file.Path
import java.util.Random
import kotlin.io.path.deleteRecursively
import kotlin.io.path.exists
import kotlin.io.path.name

/**
 * Every engine and every command with too little memory: each either does its work right or ends by itself with one
 * line; asked politely to end, it does; and what it leaves is a run that goes on with more memory to the same bits.
 */
internal object SmallHeapDrill : Drill {
    override val name = "heap"
    override val what = "heaps of 6 to 40 MB for every engine and command, with a polite kill now and then"
    override val cases = 60

    private val ENGINES = listOf("serial", "thread-pool", "horizon", "actors", "pekko")
    private val SETTINGS = listOf(
        "particles.count=8000",
        "box.lengths=[60,60,60]",
        "timeStep={\"type\":\"fixed\",\"dt\":0.6}",
        "output.checkpointEvery=1",
        "output.snapshotEvery=1",
    ).flatMap { listOf("--set", it) }

    @OptIn(kotlin.io.path.ExperimentalPathApi::class)
    override fun run(cases: Int, seed: Long, say: (String) -> Unit): Tally {
        val random = Random(seed)
        val home = Files.createTempDirectory("daphnis-heap")
        val lost = ArrayList<String>()
        var done = 0
        try {
            val whole = home.resolve("whole")
            Program.succeed(home, *command("serial", whole.name))
            for (case in 0 until cases) {
                val heap = "${6 + random.nextInt(35)}m"
                val bad = when (case % 4) {
                    3 -> listOfNotNull(read(home, heap, random))
                    else -> broken(home, whole, heap, ENGINES[random.nextInt(ENGINES.size)], random.nextInt(4) == 0) {
                        done++
                    }
                }
                lost += bad.map { "case $case, heap $heap: $it" }
                say("case $case, heap $heap: ${bad.ifEmpty { "well" }}")
            }
        } finally {
            home.deleteRecursively()
        }
        return Tally(cases, lost, listOf("$done of the runs had memory enough"))
    }

    private fun command(engine: String, out: String): Array<String> = arrayOf(
        "run", "elastic-gas", "--steps", "12", *SETTINGS.toTypedArray(),
        "--engine", engine, "--threads", threadsOf(engine), "--quiet", "--out", out,
    )

    /** A run with little memory, then a resume with enough. */
    @OptIn(kotlin.io.path.ExperimentalPathApi::class)
    private fun broken(
        home: Path,
        whole: Path,
        heap: String,
        engine: String,
        politely: Boolean,
        done: () -> Unit,
    ): List<String> {
        val small = home.resolve("small")
        val program = Program(home, heap, command(engine, small.name).toList())
        if (politely) {
            while (program.isAlive && program.seconds < POLITE_AFTER) Thread.sleep(10)
            program.terminate()
        }
        val ended = program.await(if (politely) LONGEST_POLITE else Program.LONG)
        val bad = listOfNotNull(
            judge("$engine${if (politely) ", terminated" else ""}", ended, politely),
        ).toMutableList()
        if (ended.code == 0) done()
        if (small.resolve("scenario.json").exists()) {
            val resumed = Program.run(home, "resume", small.name, "--quiet")
            if (resumed.code != 0) {
                bad += "$engine: resume ended with ${resumed.code}: ${resumed.text}"
            } else {
                bad +=
                    RunFiles.differences(whole, small)
            }
        }
        small.deleteRecursively()
        return bad
    }

    /** Commands that read the whole run. */
    @OptIn(kotlin.io.path.ExperimentalPathApi::class)
    private fun read(home: Path, heap: String, random: Random): String? {
        val words =
            listOf(
                "analyze whole --quiet --out seen",
                "export whole --format xyz --out exported",
                "export whole --format h5md --out exported",
                "compare whole whole",
                "describe ring-patch",
            )
        val command = words[random.nextInt(words.size)]
        val ended = Program.run(home, *command.split(' ').toTypedArray(), heap = heap)
        for (left in listOf("seen", "exported")) home.resolve(left).takeIf { it.exists() }?.deleteRecursively()
        return judge(command, ended, false)
    }

    private fun judge(what: String, ended: Ended, politely: Boolean): String? = when {
        ended.code == null -> "$what hangs"
        ended.hasTrace -> "$what: a trace: ${ended.text.take(MOST_SAID)}"
        ended.code == 0 || (politely && ended.code in POLITE) -> null
        ended.code != 1 -> "$what: exit code ${ended.code}: ${ended.text.take(MOST_SAID)}"
        ended.text.trim().lines().count {
            it.isNotEmpty()
        } > MOST_LINES -> "$what: more than a line: ${ended.text.take(MOST_SAID)}"
        else -> null
    }

    /** Interrupted after a checkpoint, or before there was anything to keep. */
    private val POLITE = setOf(1, 130, 143)
    private const val POLITE_AFTER = 2.0
    private const val LONGEST_POLITE = 200.0
    private const val MOST_SAID = 400

    /** The line, and one of the JVM's own. */
    private const val MOST_LINES = 2
}
