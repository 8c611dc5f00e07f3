package daphnis.drills

import java.nio.file.Files
import java.nio.file.Path
import java.util.Random
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.deleteRecursively
import kotlin.io.path.exists

/** A run over three nodes, each process on a host of its own, and what happens to the network between them. */
internal class NetworkCase(
    private val home: Path,
    private val network: Namespaces,
    private val fault: NetworkFault,
    private val random: Random,
) {
    private val directory = home.resolve("run")
    private val secret = Files.writeString(home.resolve("secret"), "a secret of the drills")
    private val config = Files.writeString(home.resolve("network.conf"), SETTINGS)
    private val complaints = ArrayList<String>()
    private val programs = ArrayList<Program>()
    private lateinit var whole: Path

    /** Null when the case cannot be had on this machine. */
    @OptIn(ExperimentalPathApi::class)
    fun play(): List<String>? {
        val isNarrow = fault == NetworkFault.NARROW || fault == NetworkFault.RUN_NARROW
        val steps = if (isNarrow) "0.2" else "3"
        val scenario = listOf("run", "shear-cell", "--until", steps) + SETS.flatMap { listOf("--set", it) }
        whole = home.resolve("whole-$steps")
        if (!whole.exists()) {
            Program.succeed(
                home,
                *(scenario + listOf("--engine", "serial", "--out", "${whole.fileName}")).toTypedArray(),
            )
        }
        val shape = when (fault) {
            NetworkFault.NARROW -> network.shape(3, RATE)
            NetworkFault.RUN_NARROW -> network.shape(0, RATE)
            NetworkFault.LOSSY -> network.shape(2, LOSS)
            else -> true
        }
        if (!shape) return null
        try {
            val nodes = (1..3).map(::node)
            val cluster = listOf("--cluster", (1..3).joinToString(",") { at(it) }, "--nodes", "3")
            val run = daphnis(0, scenario + listOf("--out", directory.fileName.toString(), "--quiet") + cluster)
            if (awaitRows()) disturb(run, nodes)
            judge(run)
        } finally {
            for (program in programs) program.terminate()
            for (program in programs) {
                program.await(LONGEST_END).let {
                    if (it.hasTrace) {
                        complaints +=
                            "trace: ${it.text}"
                    }
                }
            }
        }
        if (directory.exists()) complaints += RunFiles.differences(whole, directory)
        directory.deleteRecursively()
        return complaints
    }

    private fun disturb(run: Program, nodes: List<Program>) {
        Thread.sleep(random.nextInt(MOMENTS).toLong())
        when (fault) {
            NetworkFault.LINK_SHORT -> cut(SHORT) { network.link(1 + random.nextInt(3), it) }
            NetworkFault.RUN_SHORT -> cut(SHORT) { network.link(0, it) }
            NetworkFault.LINK_LONG -> {
                val lost = 1 + random.nextInt(3)
                network.link(lost, false)
                awaitThat("the loss is told") { "was lost" in run.said && "2 nodes continue" in run.said }
                awaitThat("the node that was cut off ends") { !nodes[lost - 1].isAlive }
                expect(nodes[lost - 1], "this process was cut off from the others")
                network.link(lost, true)
                node(lost)
                awaitThat("the node has come") { "1 node has come" in run.said || !run.isAlive }
            }
            NetworkFault.HALVES -> {
                network.trunk(false)
                awaitThat("the loss is told") { "1 node continues" in run.said }
                awaitThat("the others wait") { nodes.drop(1).all { "waiting for a run" in it.said.afterWork() } }
                network.trunk(true)
                if (!nodes.all { it.isAlive }) complaints += "the greater part of the nodes has not stayed"
            }
            NetworkFault.RUN_LONG -> {
                network.link(0, false)
                awaitThat("the run has no node") { "no node is there" in run.said }
                awaitThat("the nodes wait") { nodes.all { "waiting for a run" in it.said.afterWork() } }
                network.link(0, true)
                awaitThat("the run comes back") {
                    "looking for nodes anew" in run.said && CONTINUES in run.said
                }
            }
            NetworkFault.NARROW, NetworkFault.RUN_NARROW, NetworkFault.LOSSY -> Unit
        }
    }

    /** What a node has said since it has computed. */
    private fun String.afterWork() = substringAfterLast("computes ", "")

    private fun cut(seconds: Double, link: (Boolean) -> Unit) {
        link(false)
        Thread.sleep((seconds * 1000).toLong())
        link(true)
    }

    private fun judge(run: Program) {
        val ended = run.await(LONGEST)
        val said = ended.text.takeLast(MOST_SAID)
        if (ended.code != 0) complaints += "the run ended with ${ended.code}: $said"
        if (ended.hasTrace) complaints += "a trace: $said"
        val isQuiet = fault == NetworkFault.LINK_SHORT || fault == NetworkFault.RUN_SHORT
        if (isQuiet && CONTINUES in ended.text) complaints += "a loss without need: $said"
    }

    private fun expect(program: Program, line: String) {
        if (line !in program.said) complaints += "'$line' is not said in ${program.said.takeLast(MOST_SAID)}"
    }

    private fun awaitRows(): Boolean {
        val series = directory.resolve("series.csv")
        // Header and state at the start are there before the nodes are.
        awaitThat("the first step") { series.exists() && Files.readAllLines(series).size > 3 }
        return complaints.isEmpty()
    }

    private fun awaitThat(what: String, condition: () -> Boolean) {
        val end = System.nanoTime() + (LONGEST * 1e9).toLong()
        while (System.nanoTime() < end) {
            if (condition()) return
            Thread.sleep(POLL_MILLIS)
        }
        val all = programs.joinToString("\n") { it.said.takeLast(MOST_SAID) }
        if (!condition()) complaints += "not so: $what. All that was said: $all"
    }

    private fun at(k: Int) = "${Namespaces.addressOf(k)}:$PORT"

    private fun node(k: Int): Program {
        val list = (1..3).joinToString(",") { at(it) }
        return daphnis(k, listOf("node", "--port", "$PORT", "--join", list, "--threads", "1"))
    }

    private fun daphnis(k: Int, words: List<String>): Program {
        val safety = listOf("--host", Namespaces.addressOf(k), "--insecure", "--secret-file", "$secret")
        return Program(home, HEAP, words + safety + listOf("--config", "$config"), network.on(k)).also {
            programs += it
        }
    }

    private companion object {
        val CONTINUES = Regex("continues? from step")
        const val PORT = 25520
        const val HEAP = "96m"
        const val RATE = "tbf rate 1mbit burst 16kb latency 400ms"
        const val LOSS = "netem delay 5ms loss 1%"
        const val SETTINGS = "daphnis.cluster { heartbeat = 500 ms, acceptable-pause = 5 s, stable-after = 2 s }\n"
        const val SHORT = 1.5
        const val MOMENTS = 2000
        const val LONGEST = 300.0
        const val LONGEST_END = 90.0
        const val POLL_MILLIS = 20L
        const val MOST_SAID = 900
        val SETS = listOf(
            "output.seriesEvery=1",
            "output.snapshotEvery=30",
            "output.checkpointEvery=30",
            "output.collisionLog=true",
        )
    }
}
