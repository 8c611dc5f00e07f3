package daphnis.drills

import daphnis.core.FreePorts
import java.nio.file.Files
import java.nio.file.Path

/** A node as a process, reached at [address]. */
internal class NodeProcess(val address: String, val program: Program) {
    /** Whether it was stopped for so long that the others may have gone on without it. */
    var isGivenUp = false
}

/**
 * The nodes of one cluster on this machine, with short heartbeats so that losses cost seconds. All are given the same
 * list of processes to join, which is that of the first [count].
 */
internal class NodeProcesses(private val home: Path, private val count: Int) {
    private val all = ArrayList<NodeProcess>()
    private val first: List<String> = List(count) { "127.0.0.1:${FreePorts.one()}" }

    /** What all processes are given. */
    val config: Path = home.resolve("quick.conf").also { Files.writeString(it, QUICK) }

    /** The addresses that are told to everybody, also when nobody is there any more. */
    val addresses: String = first.joinToString(",")

    init {
        for (address in first) start(address, addresses)
    }

    val living: List<NodeProcess> get() = all.filter { it.program.isAlive && !it.isGivenUp }

    /** A node that comes later: at the address of one that is gone, or at a new one. */
    fun come(anew: Boolean, join: String = addresses): NodeProcess {
        val taken = all.filter { it.program.isAlive }.map { it.address }
        val old = first.filter { it !in taken }.takeIf { !anew }?.firstOrNull()
        return start(old ?: "127.0.0.1:${FreePorts.one()}", join)
    }

    /** Tells all to end, and says what was wrong with how they ended, by themselves before or now. */
    fun end(): List<String> {
        for (node in all) node.program.signal("CONT")
        for (node in all) node.program.terminate()
        return all.mapNotNull { complaint(it) }
    }

    private fun start(address: String, join: String): NodeProcess {
        val port = address.substringAfterLast(':')
        val words = listOf("node", "--port", port, "--join", join, "--threads", "1", "--config", "$config")
        return NodeProcess(address, Program(home, HEAP, words)).also { all += it }
    }

    private fun complaint(node: NodeProcess): String? {
        val ended = node.program.await(LONGEST_END)
        val said = "node ${node.address} (${ended.code}): ${ended.text.takeLast(MOST_SAID)}"
        return when {
            ended.code == null -> "does not end: $said"
            ended.hasTrace -> "a trace: $said"
            ended.code in KILLED -> null
            ended.code == 1 && ended.text.lines().count { it.startsWith("daphnis: ") } == 1 -> null
            else -> "ended in another way: $said"
        }
    }

    companion object {
        private const val HEAP = "64m"
        private const val LONGEST_END = 90.0
        private const val MOST_SAID = 600

        /** By SIGKILL and by SIGTERM. */
        private val KILLED = setOf(137, 143)

        /** Lost for certain after [LOST] seconds without a sign of life, for certain not before [PAUSE]. */
        private const val QUICK =
            "daphnis.cluster { heartbeat = 250 ms, acceptable-pause = 1500 ms, stable-after = 1 s }\n"
        const val PAUSE = 1.0
        const val LOST = 7.0
    }
}
