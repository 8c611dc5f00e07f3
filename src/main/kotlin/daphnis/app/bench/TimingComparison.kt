package daphnis.app.bench

import java.util.Locale

/**
 * Two files of timings side by side. What became slower is told apart from noise: its fastest round is slower than the
 * median of the other file's rounds, and by more than [NOISE] than its fastest. Faster is the mirror image. What only
 * one file has is left out, and named.
 */
internal class TimingComparison(old: List<Timing>, new: List<Timing>) {
    /** One engine on one scenario in both files. */
    class Pair(val old: Timing, val new: Timing) {
        /** How many times as long the new one takes, by the fastest rounds. */
        val ratio: Double get() = new.fastest / old.fastest
        val isSlower: Boolean get() = new.fastest > old.median && ratio > 1 + NOISE
        val isFaster: Boolean get() = old.fastest > new.median && ratio < 1 / (1 + NOISE)
    }

    private val newByKey = new.associateBy(::key)
    private val oldByKey = old.associateBy(::key)

    /** In the order of the new file. */
    val pairs: List<Pair> = new.mapNotNull { t -> oldByKey[key(t)]?.let { Pair(it, t) } }

    /** What only one of the files has, in words. */
    val unmatched: List<String> =
        new.filter { key(it) !in oldByKey }.map { "only the second has ${words(it)}" } +
            old.filter { key(it) !in newByKey }.map { "only the first has ${words(it)}" }

    /** As a table in Markdown. */
    fun table(): String {
        val lines =
            arrayListOf(
                "| scenario | engine | threads | before, s | after, s | ratio | |",
                "|---|---|--:|--:|--:|--:|---|",
            )
        for (pair in pairs) {
            val verdict = if (pair.isSlower) {
                "slower"
            } else if (pair.isFaster) {
                "faster"
            } else {
                ""
            }
            val ratio = "%.2f".format(Locale.ROOT, pair.ratio)
            val t = pair.new
            val seconds = "${significant(pair.old.fastest)} | ${significant(t.fastest)}"
            lines += "| ${t.scenario} | ${t.engine} | ${t.threads} | $seconds | $ratio | $verdict |"
        }
        return lines.joinToString("\n")
    }

    /** The same steps of the same spheres; other numbers of collisions are another computation. */
    private fun key(t: Timing) = listOf(t.scenario, t.engine, t.threads, t.spheres, t.steps, t.collisions)

    private fun words(t: Timing) =
        "${t.engine} on ${t.threads} of ${t.scenario}, ${t.steps} steps, ${t.collisions} collisions"

    private companion object {
        const val NOISE = 0.03
    }
}
