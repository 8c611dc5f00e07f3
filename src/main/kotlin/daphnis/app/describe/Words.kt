package daphnis.app.describe

import daphnis.core.input.Quantities
import daphnis.core.input.Quantities.Companion.number
import daphnis.core.scenario.GrowthSpec
import daphnis.core.scenario.RestitutionSpec
import daphnis.core.space.Space

/** What is simulated in [space], in the singular. */
internal fun one(space: Space): String = if (space.isPlane) "disc" else "sphere"

/** `1 sphere`, `2 spheres`; discs in a plane. */
internal fun spheres(count: Int, space: Space = Space.VOLUME): String = counted(count.toLong(), one(space))

/** `1 step`, `2 steps`. */
internal fun counted(number: Long, what: String): String = if (number == 1L) "1 $what" else "$number ${what}s"

/** The law and its numbers; speeds in cm/s, as the law has them. */
internal fun RestitutionSpec.inWords(say: Quantities): String = when (this) {
    is RestitutionSpec.Constant -> "${number(coefficient)} at every speed"
    is RestitutionSpec.Bridges -> "bridges, ${number(prefactor)} v^${number(exponent)} with v in cm/s"
    is RestitutionSpec.Borderies -> "borderies, elastic below ${number(criticalSpeed)} cm/s"
    is RestitutionSpec.Step ->
        "step, ${number(below)} below ${number(speed)} cm/s, ${number(coefficient)} from there on"
    is RestitutionSpec.Table -> {
        val ends = listOf(points.first(), points.last()).map { (speed, its) ->
            "${number(its)} at ${number(speed)} cm/s"
        }
        if (points.size ==
            1
        ) {
            "table of 1 point, ${ends[0]}"
        } else {
            "table of ${points.size} points from ${ends[0]} to ${ends[1]}"
        }
    }
    is RestitutionSpec.Viscoelastic -> {
        val of = listOfNotNull(
            radius?.let { "radius ${say.length(it)}" },
            mass?.let { "mass ${say.mass(it)}" },
        ).joinToString(" and ")
        "viscoelastic, ${number(coefficient)} at ${number(speed)} cm/s" +
            if (of.isEmpty()) "" else " of two spheres of $of"
    }
}

/** [text] in lines of at most [columns], broken between words; longer words stand alone. */
internal fun wrapped(text: String, columns: Int): List<String> {
    val lines = arrayListOf("")
    for (word in text.split(' ')) {
        val line = lines.last()
        if (line.isNotEmpty() && line.length + 1 + word.length > columns) {
            lines += word
        } else {
            lines[lines.lastIndex] = if (line.isEmpty()) word else "$line $word"
        }
    }
    return lines
}

/** What ends a run before its time. */
internal fun GrowthSpec.goals(): List<String> = listOfNotNull(
    untilFillingFactor?.let { "filling factor ${number(it)}" },
    untilPressure?.let { "reduced pressure ${number(it)}" },
)
