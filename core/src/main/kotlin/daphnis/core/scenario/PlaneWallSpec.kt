package daphnis.core.scenario

import daphnis.core.input.Described
import daphnis.core.input.ValueCheck
import daphnis.core.surface.RoughnessSpec
import daphnis.core.wall.PlaneWall
import daphnis.core.wall.Wall
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import java.util.function.DoubleFunction
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.math.sqrt

/** @property belt velocity of the surface along itself */
@Serializable
@SerialName("plane")
@Described("a plane, which may move along its normal")
public class PlaneWallSpec @JvmOverloads constructor(
    @Described("of the plane")
    public val point: List<Double>,
    @Described("into the room")
    public val normal: List<Double>,
    @Described("in [0, 1]; default that of the walls")
    override val restitution: Double? = null,
    @Described("its surface, whatever `boundary.roughness` says; default smooth")
    override val roughness: RoughnessSpec? = null,
    @Described("of a thermal wall, mass · speed²; default reflects")
    override val temperature: Double? = null,
    @Described("along its normal, no piston; default rests")
    override val motion: WallMotionSpec? = null,
    @Described("velocity of its surface along itself; acts by `roughness` alone; default [0, 0, 0]")
    public val belt: List<Double> = NOWHERE,
) : WallSurfaceSpec {
    override val slides: Boolean get() = belt.any { it != 0.0 }

    override fun surface(key: String, check: ValueCheck): Wall {
        val its = WallTraits(this, key, check)
        val n = its.direction("normal", normal)
        its.vector("belt", belt).forEachIndexed { k, it -> check.speed("$key.belt[$k]", it) }
        // Scaled first, since squares of the smallest numbers are 0.
        val scale = n.maxOf { abs(it) }
        val across = (0 until AXES).sumOf { belt[it] * (n[it] / scale) } / sqrt(n.sumOf { (it / scale) * (it / scale) })
        check.that("$key.belt", belt, abs(across) <= ROUNDING * belt.sumOf { abs(it) }) {
            "must be along the plane; what moves along the normal is a motion"
        }
        check.must("$key.motion", motion?.isFree != true) {
            "is of a piston, which must be a face of the box; give it in ${WallFacesSpec.KEY}"
        }
        return PlaneWall(its.vector("point", point), n, its.face, its.roughness, belt)
    }

    /** Its outline in what is seen, and a lattice. */
    override fun curves(corners: List<DoubleArray>, displacement: Double): List<SurfaceCurve> {
        val n = unit(normal)
        val (u, v) = across(n)
        val tolerance = toleranceOf(corners)
        val outline = crossings(corners, DoubleArray(AXES) { point[it] + displacement * n[it] }, n, tolerance)
        if (outline.isEmpty()) return emptyList()
        val middle = DoubleArray(AXES) { axis -> outline.sumOf { it[axis] } / outline.size }
        fun along(at: DoubleArray, d: DoubleArray) = (0 until AXES).sumOf { (at[it] - middle[it]) * d[it] }
        val round = outline.sortedBy { atan2(along(it, v), along(it, u)) }
        val curves = round.indices.map { line(round[it], round[(it + 1) % round.size]) }.toMutableList()
        for ((d, other) in listOf(u to v, v to u)) {
            val least = outline.minOf { along(it, d) }
            val most = outline.maxOf { along(it, d) }
            val reach = outline.maxOf { abs(along(it, other)) }
            for (k in 1 until LATTICE) {
                val s = least + (most - least) * k / LATTICE
                fun at(t: Double) = DoubleArray(AXES) { middle[it] + s * d[it] + t * other[it] }
                if (reach > tolerance && most - least > tolerance) curves += line(at(-reach), at(reach))
            }
        }
        return curves
    }

    /** Where the plane meets the twelve edges of what is seen. */
    private fun crossings(
        corners: List<DoubleArray>,
        point: DoubleArray,
        n: DoubleArray,
        tolerance: Double,
    ): List<DoubleArray> {
        val found = ArrayList<DoubleArray>()
        for (k in corners.indices) {
            for (axis in 0 until AXES) {
                val m = k or (1 shl axis)
                if (m == k) continue
                val (a, b) = corners[k] to corners[m]
                val (da, db) = dot(a, n) - dot(point, n) to dot(b, n) - dot(point, n)
                if (da * db > 0 || da == db) continue
                val at = DoubleArray(AXES) { a[it] + (b[it] - a[it]) * (da / (da - db)) }
                if (found.none { other -> (0 until AXES).all { abs(other[it] - at[it]) <= tolerance } }) found += at
            }
        }
        return found
    }

    override fun named(length: DoubleFunction<String>): String = "plane with normal ${directionInWords(normal)}" +
        (if (motion != null) " that moves" else "") + if (slides) " with a belt" else ""

    override fun inWords(number: DoubleFunction<String>): String =
        "plane with normal ${number.all(normal)} through ${number.all(point)}" + traits(number) +
            (motion?.let { ", ${it.inWords(number)}" } ?: "") + if (slides) ", belt with ${number.all(belt)}" else ""
}

private const val ROUNDING = 1e-12
private const val LATTICE = 6
