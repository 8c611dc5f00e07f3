package daphnis.cluster.system

import daphnis.cluster.desk.Greeter
import daphnis.cluster.desk.Greeter.Outcome
import daphnis.cluster.hosts.HostPort
import java.time.Duration

/**
 * How a process gets into a cluster: it greets all the [others] it was told of until one of the cluster answers, and
 * joins that. The process that is the first of all begins a cluster when none of the others belongs to one. Only the
 * desk calls.
 *
 * @param mayBegin whether this process is the first
 * @param enter joins the cluster of a process; of none when null
 * @param fail takes the reason why there is nothing to join
 */
internal class Joining(
    private val others: List<HostPort>,
    private val mayBegin: Boolean,
    private val within: Duration,
    private val greeter: Greeter,
    private val enter: (HostPort?) -> Unit,
    private val fail: (String) -> Unit,
    private val say: (String) -> Unit,
) : Entrance {
    private var isOver = false
    private var hasEntered = false
    private var hasComplained = false
    private var isWaiting = false
    private var begun = 0L
    private var greeted = 0L

    override fun start(now: Long) {
        begun = now
        if (others.isEmpty()) begin() else greet(now)
    }

    override fun entered() {
        isOver = true
    }

    override fun tick(now: Long) {
        if (isOver) return
        val waited = now - begun
        if (waited > within.toNanos()) {
            isOver = true
            fail(if (hasEntered) "${names()} let this process in, but the cluster does not" else nobody(waited))
        } else if (!hasEntered && mayBegin && waited > ALONE) {
            begin()
        } else if (!hasEntered && now - greeted > AGAIN) {
            greet(now)
            if (waited > COMPLAIN && !hasComplained) {
                hasComplained = true
                say("${nobody(waited)}; trying for ${within.toSeconds()} s")
            }
        }
    }

    /**
     * It may be a run whose nodes have all died. This process need not be the first then, which alone may begin a
     * cluster.
     */
    override fun called(address: HostPort) {
        if (isOver || hasEntered) return
        hasEntered = true
        enter(address)
    }

    private fun begin() {
        hasEntered = true
        enter(null)
    }

    private fun greet(now: Long) {
        greeted = now
        for (other in others) greeter.greet(other) { answered(it) }
    }

    private fun answered(outcome: Outcome) {
        if (isOver || hasEntered) return
        when (outcome) {
            is Outcome.Friend -> if (outcome.isMember) {
                hasEntered = true
                enter(outcome.peer.address)
            } else {
                isWaiting = true
            }
            is Outcome.Refused -> {
                isOver = true
                fail(outcome.reason)
            }
        }
    }

    private fun nobody(waited: Long): String {
        val seconds = Duration.ofNanos(waited).toSeconds()
        if (isWaiting) return "${names()} waits for a cluster itself since $seconds s; start the first one named"
        return "nobody has answered at ${names()} for $seconds s; a process answers to its host as it names it " +
            "itself, and all need TLS with the same authority, or none"
    }

    private fun names() = others.joinToString()

    private companion object {
        const val SECOND = 1_000_000_000L
        const val AGAIN = SECOND / 2
        const val ALONE = 3 * SECOND
        const val COMPLAIN = 5 * SECOND
    }
}
