package daphnis.analysis.occultation

import daphnis.analysis.insitu.State
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.cos
import kotlin.math.floor
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * A star behind a patch, seen through the [footprint] of an instrument that moves along a straight [path]. Tracks lie
 * side by side in a rectangle around the middle of the patch, as large as the patch is: along x or y it is the patch
 * itself, along another direction parts of it are images, where they stand at that time.
 *
 * The light in a footprint is that of rays on a lattice, a quarter of a typical radius apart or less. A lattice measures
 * the area of a shadow so well that the variance of what it misses is below a thousandth of that of the shadows, where
 * as many random rays would add T(1 − T) over their number. The mean over points in the place of that over the footprint
 * makes a variance larger by some h²(1/length + 1/width)/9r at the distance h between rays; where r/4 would make that
 * more than 2 ‰, h is smaller. So nothing of the method has to be taken from a variance. With more than [MOST_RAYS] rays
 * they would be farther apart.
 *
 * @param line of sight
 * @param path direction of the path in the plane, from x toward y in radians: 0 is radial, π/2 along the orbit
 */
public class Scan @JvmOverloads constructor(
    public val line: LineOfSight,
    public val footprint: Footprint,
    public val path: Double = 0.0,
) {
    init {
        require(path.isFinite()) { "path is $path; it must be finite" }
    }

    private val c = snapped(cos(path))
    private val s = snapped(sin(path))

    /** Axis-parallel paths run through the patch and no image of it, to the last bit. */
    private fun snapped(value: Double) = if (abs(value) < STRAIGHT) 0.0 else value

    /** Extent along the path and across it, of the rectangle in [box] that tracks have room in. */
    private fun room(box: Box): Pair<Double, Double> {
        val along = box.length(0) * abs(c) + box.length(1) * abs(s)
        return along to box.length(0) * box.length(1) / along
    }

    /** Why there is no scan in [boundary], as the end of a sentence; null if there is one. */
    public fun problem(boundary: BoundaryConditions): String? {
        val (along, across) = room(boundary.box)
        if (footprint.length > along * ENOUGH || footprint.width > across * ENOUGH) {
            return "it must fit into the patch, which has room for $along along the path and $across across it"
        }
        val most = along / footprint.length * (across / footprint.width)
        if (most > MOST_FOOTPRINTS) return "$most of them fit into the patch; at most $MOST_FOOTPRINTS are looked at"
        val open = (0..1).find { !boundary.hasImages(it) }
        if (open == null || c == 0.0 || s == 0.0) return null
        return "the path leaves the patch, which does not repeat along ${"xy"[open]}: it must be along x or y"
    }

    /**
     * The light curves of [state].
     *
     * @throws IllegalArgumentException where there is a [problem]
     */
    public fun of(state: State): LightCurve = caster(state).let { it.lattice.light(it.cast()) }

    /** What drops the shadows of [state]. */
    internal fun caster(state: State): ShadowCaster {
        problem(state.boundary)?.let { throw IllegalArgumentException("a footprint, $footprint: $it") }
        val (along, across) = room(state.boundary.box)
        val lattice = Lattice(
            footprint,
            floor(along / footprint.length * ENOUGH).toInt(),
            floor(across / footprint.width * ENOUGH).toInt(),
            spacing(state, along * across),
        )
        return ShadowCaster(state, line, c, s, lattice)
    }

    /** Largest distance between rays, for tracks that cover [area]. */
    internal fun spacing(state: State, area: Double): Double {
        val p = state.population
        var squares = 0.0
        var cubes = 0.0
        for (k in 0 until p.size) {
            val r = p.radius[k]
            squares += r * r
            cubes += r * r * r
        }
        val typical = if (squares > 0) cubes / squares else sqrt(area)
        val narrow = sqrt(typical * footprint.length * footprint.width / (footprint.length + footprint.width))
        return maxOf(minOf(typical / FINE, narrow / NARROW), sqrt(area / MOST_RAYS))
    }

    public companion object {
        /** Of all tracks of a state together. */
        public const val MOST_RAYS: Int = 1 shl 27

        /** In a state. */
        public const val MOST_FOOTPRINTS: Int = 4_000_000

        /** Rays per typical radius, which is ⟨r³⟩/⟨r²⟩. */
        private const val FINE = 4

        /** Rays per root of that radius times the harmonic size of the footprint. */
        private const val NARROW = 8

        /** What rounding may take from an edge that a whole number of footprints fills. */
        private const val ENOUGH = 1 + 1e-9
        private const val STRAIGHT = 1e-12
    }
}

/**
 * The rays of [tracks] tracks of [places] footprints each: [nu] along the path and [nv] across it in the rectangle
 * around each footprint.
 */
internal class Lattice(private val footprint: Footprint, val places: Int, val tracks: Int, spacing: Double) {
    val nu = ceil(footprint.length / spacing).toInt().coerceAtLeast(FEWEST)
    val nv = ceil(footprint.width / spacing).toInt().coerceAtLeast(FEWEST)
    val stepU = footprint.length / nu
    val stepV = footprint.width / nv

    /** Rays of each row of a footprint: from the first until the end, within its rectangle. */
    private val first = IntArray(nv)
    private val end = IntArray(nv)
    private val rays: Int

    init {
        for (row in 0 until nv) {
            end[row] = nu
            if (!footprint.isDisc) continue
            val radius = footprint.length / 2
            val v = (row + 0.5) * stepV - radius
            val half = sqrt(maxOf(0.0, radius * radius - v * v))
            first[row] = ceil((radius - half) / stepU - 0.5).toInt().coerceIn(0, nu)
            end[row] = (floor((radius + half) / stepU - 0.5).toInt() + 1).coerceIn(first[row], nu)
        }
        rays = (0 until nv).sumOf { end[it] - first[it] }
    }

    fun mask() = ShadowMask(Math.multiplyExact(tracks, nv), Math.multiplyExact(places, nu))

    fun light(mask: ShadowMask) = LightCurve(
        Array(tracks) { track ->
            DoubleArray(places) { place ->
                var blocked = 0
                for (row in 0 until nv) {
                    blocked += mask.blocked(track * nv + row, place * nu + first[row], place * nu + end[row])
                }
                1 - blocked / rays.toDouble()
            }
        },
        footprint.length,
        rays,
    )

    private companion object {
        /** Rays along a footprint, at least. */
        const val FEWEST = 2
    }
}
