package daphnis.cluster.desk

/**
 * What a process says of those it refuses: each in a line, once an hour, as one that tries again and again fills no
 * screen; and of many, those of the first [MOST_NAMED] in a minute, and how many more there were. Who has only called
 * may be anybody, under any name, so those that have answered a challenge at the address they gave are counted apart.
 *
 * One thread at a time.
 */
internal class Refusals(private val say: (String) -> Unit) {
    private class Kind(val who: String) {
        /** Lines that were said, and when. */
        val said = HashMap<String, Long>()
        var named = 0
        var others = 0L
    }

    private val callers = Kind("callers whose address nobody has checked")
    private val answerers = Kind("processes")
    private var minute = 0L
    private var isBegun = false

    /** Of the process with [address], which [hasAnswered] at it, for [reason]. */
    fun refused(address: Any, reason: String, hasAnswered: Boolean, now: Long) {
        tick(now)
        val kind = if (hasAnswered) answerers else callers
        val line = "refused $address: $reason"
        val last = kind.said[line]
        if (last != null && now - last < HOUR) return
        if (kind.named == MOST_NAMED) {
            kind.others++
            return
        }
        kind.named++
        kind.said[line] = now
        say(line)
    }

    /** To be called now and then, with nanoseconds of any origin. */
    fun tick(now: Long) {
        if (isBegun && now - minute < MINUTE) return
        for (kind in listOf(answerers, callers)) {
            if (kind.others > 0) say("refused ${kind.others} more ${kind.who} within a minute")
            kind.named = 0
            kind.others = 0
            kind.said.values.removeIf { now - it >= HOUR }
        }
        minute = now
        isBegun = true
    }

    private companion object {
        const val MINUTE = 60_000_000_000L
        const val HOUR = 60 * MINUTE
        const val MOST_NAMED = 20
    }
}
