package daphnis.analysis.brightness

import daphnis.analysis.insitu.State
import daphnis.core.initial.SeededRandom
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * I/F of light that the spheres of [state] scattered several times, by Monte Carlo. A path begins at the eye, whose ray
 * goes through a random point of the plane, and follows the light back from sphere to sphere. At each the light that
 * comes straight from its source is added, which of sphere n is that of order n. A path has random numbers of its own,
 * which [seed], the time of the state and its number decide.
 */
internal class PhotonPaths(
    state: State,
    private val field: SphereField,
    private val law: ScatteringLaw,
    private val seed: Long,
) {
    private val population = state.population
    private val time = state.time
    private val box = state.boundary.box
    private val shadow = FieldRay(field)
    private val ray = FieldRay(field)
    private val place = DoubleArray(AXES)
    private val normal = DoubleArray(AXES)
    private val toward = DoubleArray(AXES)
    private val back = DoubleArray(AXES)

    /** Mean I/F of [orders] orders along [line], the first included, over [paths] paths. */
    fun of(line: Illumination, orders: Int, paths: Int): DoubleArray {
        val sums = DoubleArray(orders)
        val first = SeededRandom(seed xor time.toRawBits()).nextLong()
        for (path in 0 until paths) follow(line, SeededRandom(first + path), sums)
        for (k in 0 until orders) sums[k] /= paths
        return sums
    }

    private fun follow(line: Illumination, random: SeededRandom, sums: DoubleArray) {
        // From above all spheres down to the plane.
        val height = maxOf(0.0, field.high[2]) / line.toEye[2]
        place[0] = box.lower(0) + random.nextDouble() * box.length(0) + height * line.toEye[0]
        place[1] = box.lower(1) + random.nextDouble() * box.length(1) + height * line.toEye[1]
        place[2] = height * line.toEye[2]
        for (axis in 0 until AXES) {
            back[axis] = line.toEye[axis]
            toward[axis] = -back[axis]
        }
        var weight = 1.0
        for (order in sums.indices) {
            if (!ray.meets(place, toward)) return
            arrive()
            val eye = dot(normal, back)
            if (eye <= 0) return
            val lit = dot(normal, line.light)
            if (lit > 0 && shadow.isFree(place, line.light)) {
                val angle = if (order == 0) abs(line.phaseAngle) else angle(line.light)
                sums[order] += weight * law.radiance(lit, eye, angle)
            }
            if (order == sums.lastIndex) return
            val from = law.drawn(random.nextDouble())
            draw(from, 2 * PI * random.nextDouble())
            weight *= law.weight(from, eye, angle(toward))
            if (weight == 0.0) return
            for (axis in 0 until AXES) back[axis] = -toward[axis]
        }
    }

    /** To the surface of the sphere that [ray] has met, where it stands in the box of this state. */
    private fun arrive() {
        ray.normal.copyInto(normal)
        val k = ray.sphere
        val r = population.radius[k]
        place[0] = population.x[k] + r * normal[0]
        place[1] = population.y[k] + r * normal[1]
        place[2] = population.z[k] + r * normal[2]
    }

    /** Lets [toward] be the direction at the cosine [along] to the normal and the angle [around] it. */
    private fun draw(along: Double, around: Double) {
        val (x, y, z) = normal
        val sign = if (z < 0) -1.0 else 1.0
        val a = -1 / (sign + z)
        val b = x * y * a
        val beside = sqrt(maxOf(0.0, 1 - along * along))
        val u = beside * StrictMath.cos(around)
        val v = beside * StrictMath.sin(around)
        toward[0] = along * x + u * (1 + sign * x * x * a) + v * b
        toward[1] = along * y + u * sign * b + v * (sign + y * y * a)
        toward[2] = along * z - u * sign * x - v * y
        val length = sqrt(dot(toward, toward))
        for (axis in 0 until AXES) toward[axis] /= length
    }

    /** Between [back] and [other], if it matters. */
    private fun angle(other: DoubleArray) =
        if (law.table == null) 0.0 else StrictMath.acos(dot(back, other).coerceIn(-1.0, 1.0))

    private fun dot(a: DoubleArray, b: DoubleArray) = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

    private companion object {
        const val AXES = SphereField.AXES
    }
}
