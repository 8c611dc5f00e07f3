package daphnis.analysis.sweep

import daphnis.analysis.report.ReportNumber
import daphnis.analysis.statistics.SampleMean

/**
 * Runs that differ in the values of some keys of their scenario, and in their seed. Runs of the same values make a
 * [Point]; numbers are averaged over its seeds.
 *
 * @property keys that were swept, as paths of the scenario; none when only seeds differ
 * @property runs in the order in which tables have them
 * @property labels what axes call the [keys], with their units
 * @throws IllegalArgumentException when a run has another number of values than there are keys
 */
public class Sweep @JvmOverloads constructor(
    public val keys: List<String>,
    public val runs: List<SweepRun>,
    public val labels: List<String> = keys,
) {
    init {
        require(labels.size == keys.size) { "${labels.size} labels of ${keys.size} keys" }
        for (run in runs) {
            require(run.values.size == keys.size) { "${run.name} has ${run.values.size} values of ${keys.size} keys" }
        }
    }

    /** In the order in which their values come first. */
    public val points: List<Point> = runs.groupBy { it.values }.map { (values, own) -> Point(values, own) }

    /**
     * A number for each key for which some run has a finite one, in the order in which they come first; the values mean
     * nothing.
     */
    public val quantities: List<ReportNumber> =
        runs.flatMap { it.numbers }.groupBy { it.key }.values
            .filter { same -> same.any { it.value.isFinite() } }.map { it.first() }

    /** Runs that failed. */
    public val failed: List<SweepRun> get() = runs.filter { it.failure != null }

    /** The runs of one combination of [values]. */
    public class Point internal constructor(public val values: List<String>, public val runs: List<SweepRun>) {
        /** The number of [key] over those of the runs that have it. */
        public fun mean(key: String): SampleMean = SampleMean.of(
            DoubleArray(runs.size) { k -> runs[k].numbers.find { it.key == key }?.value ?: Double.NaN },
        )

        /** What is to be said of runs behind the number of [key], each thing once with the seeds it is of. */
        internal fun remarks(key: String?): List<String> {
            val said = runs.mapNotNull { run ->
                run.said(key)?.let { it to run.seed }
            }.groupBy({ it.first }, { it.second })
            return said.map { (what, seeds) ->
                "${if (seeds.size == 1) "seed" else "seeds"} ${seeds.joinToString()} $what"
            }
        }

        /** How many runs have a number of [key] that is an average over a time in which they drift. */
        internal fun unsteady(key: String): Int = runs.count { run -> run.isUnsteady(key) }

        /** How many runs have a number of [key] of which it cannot be told whether they drift. */
        internal fun unjudged(key: String): Int = runs.count { run -> run.isUnjudged(key) }

        private fun SweepRun.isUnsteady(key: String) = numbers.any { it.key == key && !it.isSteady }

        private fun SweepRun.isUnjudged(key: String) = numbers.any { it.key == key && !it.isJudged }

        private fun SweepRun.said(key: String?) = failure?.let { "failed: $it" } ?: remark ?: when {
            key == null -> null
            isUnsteady(key) -> SweepRun.UNSTEADY
            isUnjudged(key) -> SweepRun.UNJUDGED
            else -> null
        }
    }
}
