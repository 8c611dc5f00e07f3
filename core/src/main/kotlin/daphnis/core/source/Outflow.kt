package daphnis.core.source

import daphnis.core.boundary.Box

/**
 * Takes away the spheres whose centres are in [region] at the end of a step. One that is so fast that it crosses the
 * region within a step is not seen there.
 */
public class Outflow(public val region: Box) : Source() {
    override fun act(step: SourceStep) {
        val p = step.population
        step.remove { region.contains(p.x[it], p.y[it], p.z[it]) }
    }
}

/** Whether a point is in this box; of the faces, the lower ones belong to it. */
internal fun Box.contains(x: Double, y: Double, z: Double): Boolean =
    x >= lowerX && x < upperX && y >= lowerY && y < upperY && z >= lowerZ && z < upperZ
