package daphnis.app

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.long
import daphnis.analysis.brightness.Brightness
import daphnis.analysis.brightness.ObservedBrightness
import daphnis.analysis.brightness.PhaseTable
import daphnis.analysis.brightness.ScatteringLaw
import daphnis.analysis.report.BrightnessOptions
import daphnis.core.input.InputException
import daphnis.core.input.Nearest

/** What `analyze` computes of the brightness of a patch when it is asked. */
internal class BrightnessFlags : OptionGroup() {
    private val law by option(
        "--brightness",
        metavar = "law",
        help = "I/F of spheres with this law of scattering: ${LAWS.joinToString()}; over --elevations and --azimuths",
    )
    private val albedo by option(
        "--albedo",
        help = "albedo of the law, 0..1: of a surface, of grains in it, or of a sphere (default 1)",
    ).double()
    private val phaseFunction by option(
        "--phase-function",
        metavar = "file",
        help = "CSV of phase_angle, phase_function: of grains with lommel-seeliger, of spheres with tabulated",
        completionCandidates = Candidates.files,
    )
    private val lightElevation by option(
        "--light-elevation",
        help = "elevation of the light, degrees; below 0 for light from below (default: that of the eye)",
    ).double()
    private val phaseAngle by option(
        "--phase-angle",
        help = "phase angle of that grid, degrees; below 0 with the light at smaller azimuths (default: the least)",
    ).double()
    private val phaseAngles by option(
        "--phase-angles",
        metavar = "degrees",
        help = "I/F over these phase angles, with commas between, at --elevation and --azimuth",
    )
    private val orders by option(
        "--orders",
        help = "orders of scattering, 1..${Brightness.MOST_ORDERS} (default 1)",
    ).int()
    private val paths by option(
        "--paths",
        help = "random paths per state for the second order and more (default ${Brightness.PATHS})",
    ).int()
    private val seed by option("--brightness-seed", help = "seed of these paths (default 1)").long()
    private val observed by option(
        "--observed-brightness",
        metavar = "file",
        help = "compare with a CSV of elevation, azimuth, light_elevation, phase_angle, i_over_f, error",
        completionCandidates = Candidates.files,
    )

    /** Whether azimuths are asked for something. */
    val isAsked: Boolean get() = law != null

    /** Reads the tables, too; null where no brightness is asked for. */
    fun options(): BrightnessOptions? {
        val name = law ?: return refuseOthers()
        if (name !in LAWS) {
            val nearest = Nearest.question(name, LAWS)
            throw InputException("--brightness", null, "is $name; ${nearest}it must be one of ${LAWS.joinToString()}")
        }
        val share = albedo ?: 1.0
        if (share !in 0.0..1.0) throw wrong("--albedo", "$share", "in 0..1")
        val angles = phaseAngles?.let { numbersOf("--phase-angles", it) }
        if (paths != null && (orders ?: 1) < 2) throw wrong("--paths", "$paths", "given with --orders of 2 at least")
        if (seed != null && (orders ?: 1) < 2) {
            throw wrong("--brightness-seed", "$seed", "given with --orders of 2 at least")
        }
        return BrightnessOptions(
            scattering(name, share),
            lightElevation,
            phaseAngle,
            angles ?: DoubleArray(0),
            orders ?: 1,
            paths ?: Brightness.PATHS,
            seed ?: 1,
            observed?.let { ObservedBrightness.read(pathOf(it, "--observed-brightness")) },
        )
    }

    private fun scattering(name: String, share: Double): ScatteringLaw {
        val file = phaseFunction
        val table = file?.let { PhaseTable.read(pathOf(it, "--phase-function")) }
        if (name == LAMBERT) {
            if (file != null) throw wrong("--phase-function", file, "given with $SEELIGER or $TABULATED")
            return ScatteringLaw.lambert(share)
        }
        if (name == SEELIGER) return ScatteringLaw.lommelSeeliger(share, table)
        if (table == null) throw wrong("--brightness", name, "given with --phase-function")
        return ScatteringLaw.ofSpheres(share, table)
    }

    private fun refuseOthers(): BrightnessOptions? {
        val given = listOf(
            "--albedo" to albedo,
            "--phase-function" to phaseFunction,
            "--light-elevation" to lightElevation,
            "--phase-angle" to phaseAngle,
            "--phase-angles" to phaseAngles,
            "--orders" to orders,
            "--paths" to paths,
            "--brightness-seed" to seed,
            "--observed-brightness" to observed,
        ).find { it.second != null } ?: return null
        throw wrong(given.first, "${given.second}", "given with --brightness")
    }

    private companion object {
        const val LAMBERT = "lambert"
        const val SEELIGER = "lommel-seeliger"
        const val TABULATED = "tabulated"
        val LAWS = listOf(LAMBERT, SEELIGER, TABULATED)
    }
}
