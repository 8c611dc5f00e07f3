package daphnis.analysis.sweep

import daphnis.analysis.plot.NamedMarks
import daphnis.analysis.plot.Ticks

/**
 * Places 0, 1, 2, … of an axis that stand for [names]. Where these have no room beside each other the places are
 * numbered, and what the numbers mean stands below the axis.
 *
 * @param title of the axis
 */
internal class NamedPlaces(title: String, private val names: List<String>) {
    private val isShort = names.all { it.length <= LONGEST } && names.sumOf { it.length + BETWEEN } <= ROOM

    /** The title of the axis, with the meaning of the numbers if there are any. */
    val label: String = if (isShort) title else (listOf(title) + legend()).joinToString("\n")

    /** The marks of that axis. */
    fun marks(): NamedMarks {
        val labels = if (isShort) names else names.indices.map { "(${it + 1})" }
        val ticks = Ticks(names.indices.map { it.toDouble() }, labels)
        return NamedMarks(ticks, -MARGIN, names.lastIndex + MARGIN)
    }

    /** Lines that are no longer than the axis. */
    private fun legend(): List<String> {
        val lines = ArrayList<String>()
        for ((k, name) in names.withIndex()) {
            val entry = "(${k + 1}) $name"
            val line = lines.lastOrNull()
            if (line == null || line.length + BETWEEN + entry.length > ROOM) {
                lines += entry
            } else {
                lines[lines.lastIndex] = "$line; $entry"
            }
        }
        return lines
    }

    private companion object {
        /** Characters that have room along the axis. */
        const val ROOM = 80
        const val BETWEEN = 2

        /** Longer ones are one too many for a glance along the axis. */
        const val LONGEST = 20

        /** Room beside the first place and the last. */
        const val MARGIN = 0.4
    }
}
