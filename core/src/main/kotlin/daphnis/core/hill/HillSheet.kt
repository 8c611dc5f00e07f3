package daphnis.core.hill

import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.ImageShear
import daphnis.core.boundary.PerSphereBoundary
import daphnis.core.boundary.count
import daphnis.core.boundary.inside
import daphnis.core.boundary.requireFinite
import daphnis.core.boundary.wrap
import daphnis.core.population.MeanFlow
import daphnis.core.population.Population
import kotlin.math.floor

/**
 * The shearing sheet for Hill's frame of angular speed [omega] (Wisdom & Tremaine 1988, AJ 95, 925): a patch of a ring
 * that goes on as its own images, radially with the Keplerian shear, along the orbit without, and is open vertically.
 * The image at +L_x slides with −(3/2) Ω L_x along y. A sphere that leaves outward comes back at the inner face
 * displaced by +(3/2) Ω L_x t along y (mod L_y) and faster by (3/2) Ω L_x; e, φ, i and ζ of its epicycle stay what they
 * were.
 *
 * ```
 *   x ▲ (outward)    image: ◀── ○ ○  −(3/2) Ω L_x
 *     ├──────────────────────┐
 *     │            ◀─────    │  outer half lags
 *     │    ──────▶           │  inner half leads
 *     └──────────────────────┴─▶ y (along the orbit)
 *          image: ○ ○ ──▶  +(3/2) Ω L_x
 * ```
 *
 * @param box finite along x and y; its extent along z is nominal: spheres are put there at the start and may leave it
 * @param radiallyOpen whether the patch ends at its radial faces (a ringlet, a ring edge) instead of going on as images
 */
public class HillSheet @JvmOverloads constructor(
    override val box: Box,
    public val omega: Double,
    public val radiallyOpen: Boolean = false,
) : PerSphereBoundary {
    init {
        requireFinite(box) { true }
        require(omega > 0 && omega.isFinite()) { "angular speed is $omega; it must be > 0" }
    }

    override val shear: ImageShear? =
        if (radiallyOpen) {
            null
        } else {
            ImageShear(
                normalAxis = 0,
                slideAxis = 1,
                velocity = -1.5 * omega * box.length(0),
                slideLength = box.length(1),
            )
        }

    override val meanFlow: MeanFlow = MeanFlow(normalAxis = 0, flowAxis = 1, rate = -1.5 * omega)

    override fun contactFaces(axis: Int): ContactFaces = if (axis == 1 || axis == 0 && !radiallyOpen) {
        ContactFaces.PERIODIC
    } else {
        ContactFaces.OPEN
    }

    override fun endStep(population: Population, time: Double, from: Int, to: Int) {
        val shear = shear
        if (shear != null) {
            val x = population.x
            val y = population.y
            val vy = population.vy
            val offset = shear.offset(time)
            val length = box.length(0)
            for (k in from until to) {
                if (x[k] >= box.lowerX && x[k] < box.upperX) continue
                val boxes = floor((x[k] - box.lowerX) / length)
                x[k] = inside(x[k] - boxes * length, box.lowerX, box.upperX)
                y[k] -= boxes * offset
                vy[k] -= boxes * shear.velocity
                shear.count(population, k, boxes, time)
            }
        }
        wrap(population, 1, box, from, to)
    }
}
