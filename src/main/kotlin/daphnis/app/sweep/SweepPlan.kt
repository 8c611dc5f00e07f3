package daphnis.app.sweep

import daphnis.core.input.InputException

/** A key of the scenario with the [values] that it takes, one or more, as they were given. */
internal class SweptKey(val path: String, val values: List<String>)

/**
 * A run that a sweep consists of.
 *
 * @property name of its directory, readable and different from all others
 * @property values of the keys that vary, in the order of [SweepPlan.varying]
 * @property settings that make its scenario, the seed aside
 * @property seed null for the scenario's
 */
internal class PlannedRun(val name: String, val values: List<String>, val settings: List<String>, val seed: Long?)

/**
 * All combinations of the values of [keys], each with all [seeds]. The last key changes fastest, and the seed before
 * it.
 *
 * @param seeds null for the scenario's alone
 */
internal class SweepPlan(val keys: List<SweptKey>, val seeds: List<Long>?) {
    /** The keys that have more than one value. */
    val varying: List<SweptKey> = keys.filter { it.values.size > 1 }

    val runs: List<PlannedRun> = run {
        requireSize()
        val all = keys.fold(listOf(emptyList<String>())) { points, key ->
            points.flatMap { point -> key.values.map { point + it } }
        }
        val names = RunNames(varying)
        all.flatMap { values ->
            val settings = keys.indices.map { "${keys[it].path}=${values[it]}" }
            val own = values.filterIndexed { k, _ -> keys[k].values.size > 1 }
            (seeds ?: listOf(null)).map { PlannedRun(names.of(own, it), own, settings, it) }
        }
    }

    private fun requireSize() {
        var size = (seeds?.size ?: 1).toLong()
        for (key in keys) {
            size *= key.values.size
            if (size > MOST) throw InputException("--set", null, "makes more than $MOST runs")
        }
    }

    companion object {
        private const val MOST = 10_000
        private const val SEED = "seed"

        /** Keys that say something to readers alone. */
        private val WORDS = setOf("name", "description")

        /** What looks like a range of numbers. */
        private val RANGE = Regex("""[-+.eE\d]+\.\.[-+.eE\d]+""")

        /**
         * @param settings `path=values` as given, see [ValueList]
         * @param seeds as given, see [Seeds]; null when they are not
         * @throws InputException when one is wrong or nothing is swept
         */
        fun of(settings: List<String>, seeds: String?): SweepPlan {
            val keys = settings.map { key(it) }
            for ((path, same) in keys.groupBy { it.path }) {
                if (same.size > 1) throw InputException("--set", path, "is given twice; one list has all its values")
            }
            val plan = SweepPlan(keys, seeds?.let { parsed("--seeds", null) { Seeds.parse(it) } })
            if (plan.runs.size == 1 && seeds == null) {
                val range = keys.find { RANGE.matches(it.values[0]) }
                val hint = range?.let { "; ${it.values[0]} is one value, so name each: ${it.path}=1,2,4" }.orEmpty()
                val why = "has no list of values, and there are no --seeds: nothing to sweep$hint"
                throw InputException("--set", range?.path, why)
            }
            return plan
        }

        private fun key(setting: String): SweptKey {
            val path = setting.substringBefore('=').trim()
            if ('=' !in setting || path.isEmpty()) {
                throw InputException("--set", setting, "must have the form path=value,value, such as timeStep.dt=1,2")
            }
            if (path == SEED) throw InputException("--set", path, "is given by --seeds in a sweep")
            val values = parsed("--set", path) { ValueList.split(setting.substringAfter('=')) }
            if (path in WORDS && values.size > 1) {
                throw InputException(
                    "--set",
                    path,
                    "has ${values.size} values, whose runs would all be the same; give one",
                )
            }
            return SweptKey(path, values)
        }

        private fun <T> parsed(option: String, key: String?, parse: () -> T): T = try {
            parse()
        } catch (e: IllegalArgumentException) {
            throw InputException(option, key, e.message.orEmpty())
        }
    }
}
