package daphnis.analysis.plot

import daphnis.analysis.table.UnitNames
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow

/** A bar that tells how long things in a picture are. */
internal object ScaleBar {
    /** A round length of about a fifth of [width]. */
    fun length(width: Double): Double {
        val wanted = width / 5
        val power = 10.0.pow(floor(log10(wanted)))
        return power * listOf(5.0, 2.0, 1.0).first { wanted / power >= it || it == 1.0 }
    }

    /** What is written at a bar of [length] in the unit [lengthName]: `5 m`. */
    fun text(length: Double, lengthName: String): String = UnitNames.amount(
        if (length == Math.rint(length) && length < 1e6) length.toLong().toString() else length.toString(),
        lengthName,
    )
}
