package daphnis.analysis.brightness

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.State
import daphnis.analysis.occultation.FirstHits
import daphnis.analysis.occultation.LineOfSight
import daphnis.analysis.occultation.Transmissions

/**
 * How bright a patch is in reflected or transmitted light: I/F, the radiance over that of a white surface which the
 * light meets head on, averaged over the plane as the eye sees it. Single scattering is exact but for the finite number
 * of rays: each ray that [Transmissions] has blocked is followed from the sphere that is nearest to the eye to the
 * light, through images. Further orders are by Monte Carlo ([PhotonPaths]).
 *
 * A measure of [width] numbers for each of [lines], in their order: the transmission along the line of the eye, I/F of
 * single scattering, then of each further order, and the sum of all. The same bits on every machine, for every state
 * by itself.
 *
 * @param rays square root of the number of rays per line and state, as in [Transmissions]
 * @property orders of scattering that are computed, 1 for single scattering
 * @param paths per line and state by which further orders are found; the same random numbers for all lines
 * @param seed of these random numbers
 */
public class Brightness @JvmOverloads constructor(
    public val lines: List<Illumination>,
    private val law: ScatteringLaw,
    private val rays: Int = Transmissions.RAYS,
    public val orders: Int = 1,
    private val paths: Int = PATHS,
    private val seed: Long = 1,
) : Measure {
    init {
        require(rays >= 1) { "$rays rays; there must be one at least" }
        require(orders in 1..MOST_ORDERS) { "$orders orders; they must be in 1..$MOST_ORDERS" }
        require(paths >= 1) { "$paths paths; there must be one at least" }
    }

    /** Numbers for each line. */
    public val width: Int get() = orders + 2

    /** Where the transmission along line [k] is; I/F of the scattering of order n stands n places behind it. */
    public fun transmission(k: Int): Int = k * width

    /** Where I/F of all orders together is for line [k]. */
    public fun total(k: Int): Int = k * width + orders + 1

    override fun of(state: State): DoubleArray {
        val numbers = DoubleArray(lines.size * width)
        val field = SphereField(state)
        val single = SingleScattering(state, field, law)
        val further = if (orders > 1) PhotonPaths(state, field, law, seed) else null
        // Lines that have the eye in common stand side by side.
        var eye: LineOfSight? = null
        var hits = FirstHits(0, 0)
        for ((k, line) in lines.withIndex()) {
            if (eye == null || !isSame(eye, line.eye)) {
                eye = line.eye
                hits = Transmissions.casting(eye, state.boundary.box, rays).hits(state)
            }
            val at = transmission(k)
            numbers[at] = hits.free / hits.sphere.size.toDouble()
            numbers[at + 1] = single.of(hits, line)
            var sum = numbers[at + 1]
            further?.of(line, orders, paths)?.let {
                for (order in 2..orders) {
                    numbers[at + order] = it[order - 1]
                    sum += it[order - 1]
                }
            }
            numbers[total(k)] = sum
        }
        return numbers
    }

    private fun isSame(a: LineOfSight, b: LineOfSight) = a.elevation == b.elevation && a.azimuth == b.azimuth

    public companion object {
        /** Paths per line and state unless others are asked for. */
        public const val PATHS: Int = 4096

        /** Orders of scattering, at most. */
        public const val MOST_ORDERS: Int = 100
    }
}
