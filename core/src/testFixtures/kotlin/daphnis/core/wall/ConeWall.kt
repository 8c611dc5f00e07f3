package daphnis.core.wall

import daphnis.core.collision.WallImpact
import daphnis.core.surface.Roughness
import kotlin.math.abs
import kotlin.math.sqrt

/** Around [axis] from [apex] on, with the [slope] of its side: at h along the axis it is slope · h wide. */
public class ConeWall(
    apex: List<Double>,
    axis: List<Double>,
    private val slope: Double,
    face: WallFace = WallFace(),
    roughness: Roughness? = null,
) : CurvedWall(apex, axis, face, roughness) {
    private val cosine = 1 / sqrt(1 + slope * slope)
    private val sine = slope * cosine

    /** From where on along the axis there is room for the middle of a sphere of radius [r]. */
    private fun above(h: Double, r: Double) = h - r / sine

    override fun gap(q2: Double, h: Double, r: Double): Double = above(h, r).let { slope * slope * it * abs(it) - q2 }

    override fun rate(qw: Double, h: Double, u: Double, r: Double): Double =
        2 * (slope * slope * abs(above(h, r)) * u - qw)

    override fun bending(
        least: Double,
        most: Double,
        h: Double,
        u: Double,
        fall: Double,
        rest: Double,
        r: Double,
    ): Double {
        val lowest = if (fall == 0.0) 0.0 else (-u / fall).coerceIn(0.0, rest)
        val now = 2 * (u * u + above(h, r) * fall)
        return slope * slope * (now + (6 * u * fall + 3 * fall * fall * lowest) * lowest) - most
    }

    override fun distance(q: Double, h: Double): Double = h * sine - q * cosine

    override fun meet(
        qx: Double,
        qy: Double,
        qz: Double,
        q: Double,
        across: Double,
        fall: Double,
        impact: WallImpact,
    ) {
        val lean = sine * q
        impact.normal(
            lean * direction[0] - cosine * qx,
            lean * direction[1] - cosine * qy,
            lean * direction[2] - cosine * qz,
        )
        impact.length = q
        impact.lean = lean
        impact.press = cosine * across - sine * fall
    }

    override fun isSameAlong(axis: Int): Boolean = false

    override fun cut(at: DoubleArray, axis: Int, into: DoubleArray) {
        val from = DoubleArray(3) { at[it] - origin[it] }
        val h = (0..2).sumOf { from[it] * direction[it] }
        val (px, py, pz) = List(3) { from[it] - h * direction[it] }
        val a = direction[axis]
        val t = slope * slope
        val qu = doubleArrayOf(px, py, pz)[axis]
        val square = t * a * a - (1 - a * a)
        val half = t * h * a - qu
        val root = half * half - square * (t * h * h - (px * px + py * py + pz * pz))
        val ends = listOf((-half - sqrt(root)) / square, (-half + sqrt(root)) / square)
        val isOpen = square > 0
        val isMet = root > 0 && (isOpen || h + a * ends.average() > 0)
        into[0] = if (!isMet) {
            1.0
        } else if (isOpen && a < 0) {
            Double.NEGATIVE_INFINITY
        } else {
            ends.min()
        }
        into[1] = if (!isMet) {
            -1.0
        } else if (isOpen && a > 0) {
            Double.POSITIVE_INFINITY
        } else {
            ends.max()
        }
        if (isMet && isOpen && a > 0) into[0] = ends.max()
        if (isMet && isOpen && a < 0) into[1] = ends.min()
    }

    override fun toString(): String = "cone from ${origin.toList()} along ${direction.toList()}"
}
