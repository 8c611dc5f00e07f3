package daphnis.app

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.int
import daphnis.analysis.occultation.Footprint
import daphnis.analysis.occultation.ObservedDepths
import daphnis.analysis.report.OccultationOptions
import daphnis.core.input.InputException

/** What `analyze` computes of the light through a patch when it is asked. */
internal class OccultationFlags : OptionGroup() {
    private val elevations by option(
        "--elevations",
        metavar = "degrees",
        help = "transmission over a grid: its elevations, with commas between, such as 10,20,40,60,90; 0.1 at least",
    )
    private val azimuths by option(
        "--azimuths",
        help = "azimuths of this grid, so many, evenly over half a turn (default ${OccultationOptions.AZIMUTHS})",
    ).int()
    private val footprint by option(
        "--footprint",
        metavar = "length",
        help =
        "light curves: footprint of the instrument, LENGTHxWIDTH along and across its path, or the diameter of " +
            "a disc, in the scenario's unit of length",
    )
    private val scanPath by option(
        "--scan-path",
        help = "direction of this path in the plane, from x toward y, degrees (default 0, radial)",
    ).double().default(0.0)
    private val photons by option(
        "--photons",
        help = "mean number of photons per footprint where nothing is in the way (default: no noise)",
    ).double()
    private val observed by option(
        "--observed",
        metavar = "file",
        help = "compare with a CSV of elevation, azimuth, optical_depth or transmission, error",
        completionCandidates = Candidates.files,
    )

    /** Reads the table of what was observed, too. [hasBrightness] is that azimuths are asked for by that, too. */
    fun options(hasBrightness: Boolean): OccultationOptions {
        val disc = footprint?.let(::footprintOf)
        if (disc == null && photons != null) throw wrong("--photons", "$photons", "given with --footprint")
        if (disc == null && scanPath != 0.0) throw wrong("--scan-path", "$scanPath", "given with --footprint")
        if (elevations == null && !hasBrightness) {
            azimuths?.let { throw wrong("--azimuths", "$it", "given with --elevations or --brightness") }
        }
        val heights = elevations?.let { numbersOf("--elevations", it) } ?: DoubleArray(0)
        val table = observed?.let { ObservedDepths.read(pathOf(it, "--observed")) }
        val turns = azimuths ?: OccultationOptions.AZIMUTHS
        return OccultationOptions(heights, turns, disc, scanPath, photons, table)
    }

    private fun footprintOf(text: String): Footprint {
        val sizes = text.split('x').map { it.trim().toDoubleOrNull() ?: Double.NaN }
        if (sizes.size > 2 || sizes.any { !(it > 0 && it.isFinite()) }) {
            throw wrong("--footprint", text, "a length > 0, or two such as 20x10")
        }
        return if (sizes.size == 1) Footprint.disc(sizes[0]) else Footprint.rectangle(sizes[0], sizes[1])
    }
}

/** The numbers of [text], which stands at [option] with commas between. */
internal fun numbersOf(option: String, text: String): DoubleArray = text.split(',').map {
    it.trim().toDoubleOrNull() ?: throw wrong(option, text, "numbers with commas between")
}.toDoubleArray()

internal fun wrong(option: String, value: String, right: String): InputException =
    InputException(option, null, "is $value; it must be $right")
