package daphnis.drills

import java.io.IOException
import java.util.concurrent.TimeUnit

/**
 * Networks of this machine alone, made of Linux network namespaces: [size] hosts behind two bridges with a link between
 * them, hosts `0..<half` behind the first. Host k has the address 10.77.0.(k + 1). Needs root. [close] takes all away,
 * and so does the end of this process, whatever ends it but SIGKILL; what that has left, the next one takes away.
 */
internal class Namespaces(private val size: Int, half: Int) : AutoCloseable {
    private val own = "$PREFIX${ProcessHandle.current().pid()}-"
    private val net = "${own}net"
    private val hook = Thread(::remove)

    init {
        removeLeftOvers()
        Runtime.getRuntime().addShutdownHook(hook)
        try {
            ip("netns add $net")
            for (bridge in 0..1) {
                ip("-n $net link add b$bridge type bridge")
                ip("-n $net link set b$bridge up")
            }
            ip("-n $net link add $TRUNK type veth peer name trunk1")
            for (bridge in 0..1) ip("-n $net link set trunk$bridge master b$bridge up")
            for (k in 0..<size) makeHost(k, if (k < half) 0 else 1)
        } catch (e: Throwable) {
            use { throw e }
        }
    }

    /** The words before a command that start it on host [k]. */
    fun on(k: Int): List<String> = listOf("ip", "netns", "exec", host(k))

    /** Takes the cable of host [k] out, or puts it in. */
    fun link(k: Int, isUp: Boolean) = ip("-n $net link set h$k ${if (isUp) "up" else "down"}")

    /** The same of the cable between the two bridges. */
    fun trunk(isUp: Boolean) = ip("-n $net link set $TRUNK ${if (isUp) "up" else "down"}")

    /** Shapes what host [k] sends and receives: [words] of `tc qdisc add`. @return whether this machine can do that */
    fun shape(k: Int, words: String): Boolean =
        listOf("-n $net qdisc add dev h$k root $words", "-n ${host(k)} qdisc add dev eth root $words")
            .all { run(listOf("tc") + it.split(' ')).isEmpty() }

    override fun close() {
        remove()
        try {
            Runtime.getRuntime().removeShutdownHook(hook)
        } catch (_: IllegalStateException) {
            // It is running.
        }
    }

    private fun makeHost(k: Int, bridge: Int) {
        ip("netns add ${host(k)}")
        ip("-n $net link add h$k type veth peer name eth netns ${host(k)}")
        ip("-n $net link set h$k master b$bridge up")
        ip("-n ${host(k)} addr add ${addressOf(k)}/24 dev eth")
        for (device in listOf("lo", "eth")) ip("-n ${host(k)} link set $device up")
    }

    private fun host(k: Int) = "$own$k"

    private fun remove() {
        for (name in namespaces()) if (name.startsWith(own)) remove(name)
    }

    private fun removeLeftOvers() {
        for (name in namespaces()) {
            val pid = name.removePrefix(PREFIX).substringBefore('-').toLongOrNull()
            if (name.startsWith(PREFIX) && pid != null && ProcessHandle.of(pid).isEmpty) remove(name)
        }
    }

    private fun remove(name: String) {
        run(listOf("ip", "netns", "del", name))
    }

    companion object {
        private const val PREFIX = "daphnis-drill-"
        private const val TRUNK = "trunk0"

        fun addressOf(k: Int): String = "10.77.0.${k + 1}"

        /** Why there can be none here, in a line; null when there can. */
        fun refusal(): String? {
            val name = "${PREFIX}${ProcessHandle.current().pid()}-try"
            val why = run(listOf("ip", "netns", "add", name))
            if (why.isEmpty()) run(listOf("ip", "netns", "del", name))
            return why.ifEmpty { null }
        }

        private fun namespaces(): List<String> {
            val process = ProcessBuilder("ip", "netns", "list").start()
            return process.inputStream.bufferedReader().readLines().map { it.substringBefore(' ') }
        }

        private fun ip(words: String) {
            val why = run(listOf("ip") + words.split(' '))
            check(why.isEmpty()) { "ip $words: $why" }
        }

        /** @return what went wrong, empty when nothing did */
        private fun run(command: List<String>): String = try {
            val process = ProcessBuilder(command).redirectErrorStream(true).start()
            val said = process.inputStream.bufferedReader().readText().trim()
            val isOver = process.waitFor(SECONDS, TimeUnit.SECONDS)
            if (isOver && process.exitValue() == 0) "" else said.ifEmpty { "${command[0]} has failed" }
        } catch (e: IOException) {
            "${e.message}"
        }

        private const val SECONDS = 20L
    }
}
