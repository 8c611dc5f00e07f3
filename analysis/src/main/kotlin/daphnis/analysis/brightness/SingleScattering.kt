package daphnis.analysis.brightness

import daphnis.analysis.insitu.State
import daphnis.analysis.occultation.FirstHits
import kotlin.math.abs

/** I/F of light that was scattered once, by the spheres of [state] in [field]. */
internal class SingleScattering(state: State, field: SphereField, private val law: ScatteringLaw) {
    private val population = state.population
    private val ray = FieldRay(field)
    private val place = DoubleArray(SphereField.AXES)

    /** Mean over all rays of [hits], those of the eye of [line]. */
    fun of(hits: FirstHits, line: Illumination): Double {
        val (eyeX, eyeY, eyeZ) = line.toEye
        val (lightX, lightY, lightZ) = line.light
        val phase = abs(line.phaseAngle)
        // At opposition the ray to the light is that to the eye, which is free.
        val isOpposition = line.toEye.contentEquals(line.light)
        var sum = 0.0
        for (i in 0 until hits.nx) {
            // Row by row, so that sums stay short.
            var row = 0.0
            for (at in i * hits.ny until (i + 1) * hits.ny) {
                val k = hits.sphere[at]
                if (k < 0) continue
                val x = hits.normalX[at]
                val y = hits.normalY[at]
                val z = hits.normalZ[at]
                val lit = x * lightX + y * lightY + z * lightZ
                val seen = x * eyeX + y * eyeY + z * eyeZ
                // Seen at 0 or less only by rounding, at the rim of a sphere.
                if (lit <= 0 || seen <= 0) continue
                val radius = population.radius[k]
                place[0] = population.x[k] + radius * x
                place[1] = population.y[k] + radius * y
                place[2] = population.z[k] + radius * z
                if (isOpposition || ray.isFree(place, line.light)) row += law.radiance(lit, seen, phase)
            }
            sum += row
        }
        return sum / hits.sphere.size
    }
}
