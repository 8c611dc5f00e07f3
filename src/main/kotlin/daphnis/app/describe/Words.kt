package daphnis.app.describe

import daphnis.core.input.Quantities.Companion.number
import daphnis.core.scenario.GrowthSpec
import daphnis.core.space.Space

/** What is simulated in [space], in the singular. */
internal fun one(space: Space): String = if (space.isPlane) "disc" else "sphere"

/** `1 sphere`, `2 spheres`; discs in a plane. */
internal fun spheres(count: Int, space: Space = Space.VOLUME): String = counted(count.toLong(), one(space))

/** `1 step`, `2 steps`. */
internal fun counted(number: Long, what: String): String = if (number == 1L) "1 $what" else "$number ${what}s"

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
