package daphnis.cluster.hosts

import daphnis.core.input.InputException

/** The list of hosts that Slurm gives a job, such as `n[001-003,07],login2`. */
public object SlurmList {
    /** The variable of the environment that holds it. */
    public const val VARIABLE: String = "SLURM_JOB_NODELIST"

    /** The most hosts that a list may mean. */
    public const val MOST: Int = 100_000

    /**
     * The names of the hosts, in the order of the list: a bracket holds numbers and ranges, whose leading zeros count;
     * a name may have several brackets.
     *
     * @throws InputException that names what is wrong
     */
    @JvmStatic
    public fun hosts(text: String): List<String> {
        val names = split(text).asSequence().flatMap { expand(it.trim(), text) }.take(MOST + 1).toList()
        if (names.size > MOST) throw wrong(text, "it means more than $MOST hosts")
        return names
    }

    /** The parts between the commas that are outside of brackets. */
    private fun split(text: String): List<String> {
        val parts = ArrayList<String>()
        var depth = 0
        var start = 0
        for ((i, c) in text.withIndex()) {
            when (c) {
                '[' -> depth++
                ']' -> depth--
                ',' -> if (depth == 0) {
                    parts += text.substring(start, i)
                    start = i + 1
                }
            }
            if (depth !in 0..1) throw wrong(text, "the brackets do not match")
        }
        if (depth != 0) throw wrong(text, "the brackets do not match")
        return parts + text.substring(start)
    }

    private fun expand(part: String, text: String): Sequence<String> {
        val open = part.indexOf('[')
        if (open < 0) {
            if (!NAME.matches(part)) throw wrong(text, "'$part' is no name of a host")
            return sequenceOf(part)
        }
        val close = part.indexOf(']', open)
        val numbers = part.substring(open + 1, close).split(',').flatMap { range(it, text) }
        // The rest may have brackets too, or be empty.
        val tail = part.substring(close + 1)
        return numbers.asSequence().flatMap { expand(part.substring(0, open) + it + tail, text) }
    }

    private fun range(word: String, text: String): List<String> {
        val ends = RANGE.matchEntire(word) ?: throw wrong(text, "'$word' is no number and no range of numbers")
        val first = ends.groupValues[1]
        val last = ends.groupValues[2].ifEmpty { first }
        val count = last.toInt() - first.toInt() + 1
        if (count < 1) throw wrong(text, "the range '$word' ends before it begins")
        if (count > MOST) throw wrong(text, "it means more than $MOST hosts")
        return List(count) { "${first.toInt() + it}".padStart(first.length, '0') }
    }

    private fun wrong(text: String, what: String) = InputException(VARIABLE, null, "'$text': $what")

    private val NAME = Regex("[A-Za-z0-9]([A-Za-z0-9._-]*[A-Za-z0-9])?")
    private val RANGE = Regex("(\\d{1,9})(?:-(\\d{1,9}))?")
}
