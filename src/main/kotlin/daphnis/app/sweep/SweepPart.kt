package daphnis.app.sweep

import daphnis.core.input.InputException

/**
 * Part [number] of [parts] of a sweep, each of which a process of its own carries out: the runs with the numbers
 * [number], [number] + [parts], … of the plan, counted from 1. A part may have none.
 */
internal class SweepPart(val number: Int, val parts: Int) {
    fun of(runs: List<PlannedRun>): List<PlannedRun> = runs.filterIndexed { k, _ -> k % parts == number - 1 }

    override fun toString(): String = "part $number of $parts"

    companion object {
        private const val OPTION = "--part"
        private const val AUTO = "auto"
        private const val SLURM = "SLURM_ARRAY_TASK_"
        private const val INDEX = "JOB_COMPLETION_INDEX"
        private const val COMPLETIONS = "JOB_COMPLETIONS"
        private const val MOST = 1_000_000

        /**
         * @param text `K/N`, or `auto` for what a batch system says in the [environment]
         * @throws InputException when it says neither
         */
        fun parse(text: String, environment: Map<String, String>): SweepPart {
            if (text.trim() == AUTO) return ofJob(environment)
            val numbers = text.split('/').map { it.trim().toIntOrNull() }
            val number = numbers[0]
            val parts = numbers.getOrNull(1)
            if (numbers.size != 2 || number == null || parts == null) {
                throw wrong("is '$text'; it must be a number and how many there are, such as 2/8, or $AUTO")
            }
            if (parts !in 1..MOST) throw wrong("is '$text'; there must be 1 to $MOST parts")
            if (number !in 1..parts) throw wrong("is '$text'; parts are numbered from 1 to $parts")
            return SweepPart(number, parts)
        }

        private fun ofJob(environment: Map<String, String>): SweepPart {
            val isArray = environment.keys.any { it == "${SLURM}ID" || it == "${SLURM}COUNT" }
            val isIndexed = INDEX in environment
            if (isArray && isIndexed) throw wrong("is $AUTO, and both ${SLURM}ID and $INDEX are set; give K/N")
            if (isIndexed) return ofIndexedJob(environment)
            if (isArray) return ofArray(environment)
            throw wrong("is $AUTO, and neither ${SLURM}ID nor $INDEX is set: this is no job of an array; give K/N")
        }

        /** The tasks of an array need not be numbered from 1, or one by one. */
        private fun ofArray(environment: Map<String, String>): SweepPart {
            val id = environment.number("${SLURM}ID")
            val count = environment.number("${SLURM}COUNT")
            val step = if ("${SLURM}STEP" in environment) environment.number("${SLURM}STEP") else 1
            val first = if ("${SLURM}MIN" in environment) environment.number("${SLURM}MIN") else 1
            val place = (id - first) / maxOf(step, 1)
            val isWhole = count in 1..MOST && step >= 1 && place in 0 until count && first + place * step == id
            val last = environment["${SLURM}MAX"]?.toLongOrNull()
            // Tasks picked out of a larger array do not know how many that had.
            if (!isWhole || last != null && last != first + (count - 1) * step) {
                throw wrong(
                    "is $AUTO, and the array has task $id of $count from $first to ${last ?: "?"}, which is no whole " +
                        "division; give K/N, such as \"\$${SLURM}ID/24\"",
                )
            }
            return SweepPart(place.toInt() + 1, count.toInt())
        }

        private fun ofIndexedJob(environment: Map<String, String>): SweepPart {
            val index = environment.number(INDEX)
            val count = environment.number(COMPLETIONS)
            if (count !in 1..MOST || index !in 0 until count) {
                throw wrong("is $AUTO, and $INDEX is $index with $COMPLETIONS $count")
            }
            return SweepPart(index.toInt() + 1, count.toInt())
        }

        private fun Map<String, String>.number(name: String): Long {
            val text = this[name] ?: throw wrong("is $AUTO, and $name is not set; give K/N")
            return text.trim().toLongOrNull() ?: throw wrong("is $AUTO, and $name is '$text', which is no number")
        }

        private fun wrong(why: String) = InputException(OPTION, null, why)
    }
}
