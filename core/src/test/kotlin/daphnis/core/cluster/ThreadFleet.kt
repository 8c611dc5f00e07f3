package daphnis.core.cluster

import java.nio.ByteBuffer
import java.util.concurrent.CountDownLatch

/** Nodes that are threads of this process. A node can be killed, and others can come, at any time. */
internal class ThreadFleet(count: Int, threads: (Int) -> Int = { 1 }) : Fleet {
    private val present = ArrayList<FleetNode>()
    private var incarnations = 0L
    private var crew: ThreadCrew? = null
    var crews = 0
        private set

    /** Called with each message before it is sent; may kill. */
    var onSend: (from: Int, to: Int, message: ByteBuffer) -> Unit = { _, _, _ -> }

    init {
        repeat(count) { add(threads(it)) }
    }

    @Synchronized
    fun add(threads: Int = 1): FleetNode =
        FleetNode("node ${incarnations + 1}", threads, ++incarnations).also { present += it }

    /** The nodes of [ranks] in the present crew die, all at once. */
    @Synchronized
    fun kill(vararg ranks: Int) {
        val crew = crew ?: return
        val lost = ranks.toList().mapNotNull { crew.nodes.getOrNull(it) }
        if (lost.isEmpty()) return
        present -= lost.toSet()
        crew.end("${lost[0].name} is lost")
    }

    @Synchronized
    override fun nodes(): List<FleetNode> = present.toList()

    override fun form(nodes: List<FleetNode>): Mail {
        synchronized(this) { crew }?.end("the crew is renewed")
        synchronized(this) { crew }?.awaitEnd()
        val made = ThreadCrew(nodes) { from, to, message -> onSend(from, to, message) }
        synchronized(this) {
            crew = made
            crews++
        }
        made.start()
        return made.mail(Mail.LEADER)
    }

    override fun close() {
        val last = synchronized(this) { crew }
        last?.end("the run has ended")
        last?.awaitEnd()
        last?.failure?.let { throw it }
    }
}

/** One crew of threads. */
private class ThreadCrew(val nodes: List<FleetNode>, onSend: (Int, Int, ByteBuffer) -> Unit) {
    private val ended = CountDownLatch(nodes.size)
    private val room = MailRoom(nodes.size, onSend)

    @Volatile
    var failure: Throwable? = null

    fun start() {
        for ((rank, node) in nodes.withIndex()) {
            Thread {
                try {
                    nodeWork().work(mail(rank), node.threads)
                } catch (e: MailClosedException) {
                    // The usual end.
                } catch (e: Throwable) {
                    failure = e
                    end("${node.name}: $e")
                } finally {
                    ended.countDown()
                }
            }.also { it.isDaemon = true }.start()
        }
    }

    fun end(why: String) = room.end(why)

    fun awaitEnd() = ended.await()

    fun mail(mine: Int): Mail = room.mail(mine)
}
