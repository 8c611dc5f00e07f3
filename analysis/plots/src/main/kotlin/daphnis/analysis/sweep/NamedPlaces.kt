package daphnis.analysis.sweep

import org.jetbrains.letsPlot.intern.Scale
import org.jetbrains.letsPlot.scale.scaleXContinuous

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

    fun scale(): Scale {
        val labels = if (isShort) names else names.indices.map { "(${it + 1})" }
        val ends = -MARGIN to names.lastIndex + MARGIN
        return scaleXContinuous(
            breaks = names.indices.map { it.toDouble() },
            labels = labels,
            limits = ends,
        )
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

        /** The library cuts longer ones. */
        const val LONGEST = 20

        /** Room beside the first place and the last. */
        const val MARGIN = 0.4
    }
}
