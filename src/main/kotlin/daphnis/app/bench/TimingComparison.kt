package daphnis.app.bench

import daphnis.app.describe.counted
import java.util.Locale

/** What became of a time. */
internal enum class Verdict(val words: String) {
    SLOWER("slower"),
    FASTER("faster"),
    SAME("same"),
    UNKNOWN("cannot tell"),
}

/**
 * Two files of timings side by side. The rounds of both say how far times spread by themselves ([RankInterval]), so
 * that one round, or rounds that overlap, cannot tell. What only one file has is left out, and named.
 */
internal class TimingComparison(private val old: List<Timing>, private val new: List<Timing>) {
    /** One engine on one scenario in both files. */
    class Pair(val old: Timing, val new: Timing) {
        /** How many times as long the new one takes: the median over all pairs of rounds. */
        val ratio: Double
            get() = RankInterval.ratios(new.seconds, old.seconds).let { (it[(it.size - 1) / 2] + it[it.size / 2]) / 2 }

        /** Where the ratio lies; null when there are too few rounds to say. */
        val interval: RankInterval? = RankInterval.of(new.seconds, old.seconds)

        val verdict: Verdict
            get() = when {
                interval == null -> Verdict.UNKNOWN
                interval.low > 1 && ratio > 1 + NOISE -> Verdict.SLOWER
                interval.high < 1 && ratio < 1 / (1 + NOISE) -> Verdict.FASTER
                interval.low >= 1 / (1 + NOISE) && interval.high <= 1 + NOISE -> Verdict.SAME
                else -> Verdict.UNKNOWN
            }
    }

    private val newByKey = new.associateBy(::key)
    private val oldByKey = old.associateBy(::key)

    /** In the order of the new file. */
    val pairs: List<Pair> = new.mapNotNull { t -> oldByKey[key(t)]?.let { Pair(it, t) } }

    /** What only one of the files has, in words. */
    val unmatched: List<String> =
        new.filter { key(it) !in oldByKey }.map { "only the second has ${words(it)}" } +
            old.filter { key(it) !in newByKey }.map { "only the first has ${words(it)}" }

    /** How the first timing that both have of an engine on a scenario differs, in words; empty when there is none. */
    fun difference(): String {
        for (t in new) {
            val o = old.firstOrNull { it.scenario == t.scenario && it.engine == t.engine && it.threads == t.threads }
            if (o != null) return ": ${t.engine} on ${t.threads} of ${t.scenario} was ${work(o)} there, ${work(t)} here"
        }
        return ""
    }

    /** That the two were timed with different Java, in a line; null where they were not, or where it is not known. */
    fun otherJava(): String? {
        val (before, after) = listOf(pairs.map { it.old }, pairs.map { it.new }).map { all ->
            all.map { it.java }.filter { it.isNotEmpty() }.distinct().joinToString()
        }
        if (before == after || before.isEmpty() || after.isEmpty()) return null
        return "the first was timed with Java $before, the second with Java $after"
    }

    private fun work(t: Timing) = listOf(
        counted(t.spheres.toLong(), "sphere"),
        counted(t.steps, "step"),
        counted(t.collisions, "collision"),
    ).joinToString()

    /** As a table in Markdown. */
    fun table(): String = HEADER + pairs.joinToString("") { "\n${row(it)}" }

    private fun row(pair: Pair): String {
        val (old, new) = pair.old to pair.new
        val interval = pair.interval?.let { "%.2f to %.2f".format(Locale.ROOT, it.low, it.high) }.orEmpty()
        return row(
            new.scenario, new.engine, "${new.threads}", "${old.seconds.size}, ${new.seconds.size}",
            significant(old.median), significant(new.median), "%.2f".format(Locale.ROOT, pair.ratio), interval,
            pair.verdict.words,
        )
    }

    /** All verdicts in one line. */
    fun closing(): String {
        fun count(verdict: Verdict) = pairs.count { it.verdict == verdict }
        val slower = count(Verdict.SLOWER)
        val unknown = count(Verdict.UNKNOWN)
        val seen = when {
            slower > 0 -> "$slower became slower"
            unknown == pairs.size -> return "nothing can be told; more --rounds may tell"
            unknown > 0 -> "nothing is seen to have become slower"
            else -> "nothing became slower"
        }
        return if (unknown == 0) seen else "$seen; $unknown cannot be told, more --rounds may tell"
    }

    /** The same steps of the same spheres; other numbers of collisions are another computation. */
    private fun key(t: Timing) = listOf(t.scenario, t.engine, t.threads, t.spheres, t.steps, t.collisions)

    private fun words(t: Timing) = "${t.engine} on ${t.threads} of ${t.scenario}, ${counted(t.steps, "step")}, " +
        counted(t.collisions, "collision")

    private companion object {
        const val NOISE = 0.03
        const val HEADER =
            "| scenario | engine | threads | rounds | before, s | after, s | ratio | 90 % interval | |\n" +
                "|---|---|--:|--:|--:|--:|--:|--:|---|"
    }
}
