package daphnis.core.boundary

import daphnis.core.population.Population
import kotlin.math.floor

/** No boundary: spheres may go anywhere. */
public object Open : BoundaryConditions {
    override val box: Box get() = Box.UNBOUNDED

    override fun endStep(population: Population, time: Double): Unit = Unit
}

/** A box that repeats along the axes marked in [periodic] (x, y, z) and is open along the others; contacts are found through the faces. */
public class Periodic(override val box: Box, periodicX: Boolean = true, periodicY: Boolean = true, periodicZ: Boolean = true) : BoundaryConditions {
    private val periodic = booleanArrayOf(periodicX, periodicY, periodicZ)

    init {
        requireFinite(box) { periodic[it] }
    }

    override fun contactFaces(axis: Int): ContactFaces = if (periodic[axis]) ContactFaces.PERIODIC else ContactFaces.OPEN

    override fun endStep(population: Population, time: Double) {
        if (periodic[0]) wrap(population.x, box.lowerX, box.upperX)
        if (periodic[1]) wrap(population.y, box.lowerY, box.upperY)
        if (periodic[2]) wrap(population.z, box.lowerZ, box.upperZ)
    }
}

/**
 * Reflecting walls: the surface of a sphere never passes a face; its normal velocity is reversed at the moment of contact and
 * multiplied by [wallRestitution]. Axes for which [walled] is false are periodic.
 */
public class Walls(override val box: Box, override val wallRestitution: Double = 1.0, private val walled: BooleanArray = booleanArrayOf(true, true, true)) :
    BoundaryConditions {
    init {
        requireFinite(box) { true }
        require(wallRestitution in 0.0..1.0) { "wall restitution is $wallRestitution; it must be in [0, 1]" }
        require(walled.size == AXES) { "walled has ${walled.size} entries, one for each of x, y, z is needed" }
    }

    override fun contactFaces(axis: Int): ContactFaces = if (walled[axis]) ContactFaces.WALL else ContactFaces.PERIODIC

    override fun endStep(population: Population, time: Double) {
        if (!walled[0]) wrap(population.x, box.lowerX, box.upperX)
        if (!walled[1]) wrap(population.y, box.lowerY, box.upperY)
        if (!walled[2]) wrap(population.z, box.lowerZ, box.upperZ)
    }
}

/**
 * The sheared periodic box of Lewis & Massingill: at the end of a step a sphere beyond a face is put on the other side, and one
 * that passed a y face has its x velocity changed by [velocityJump]. There is no offset of position and no collision search
 * through the faces, so such a box is not a consistent replica of itself and a wrap can land one sphere on another; the
 * pair then collides if it approaches and separates if it recedes. Use it for the paper's figures, [LeesEdwards] for physics.
 */
public class ShearedPeriodic(override val box: Box, public val velocityJump: Double) : BoundaryConditions {
    init {
        requireFinite(box) { true }
        require(velocityJump.isFinite()) { "velocity jump is $velocityJump; it must be finite" }
    }

    override val isSheared: Boolean get() = true

    override fun endStep(population: Population, time: Double) {
        val y = population.y
        val vx = population.vx
        val length = box.length(1)
        for (k in 0 until population.size) {
            if (y[k] >= box.lowerY && y[k] < box.upperY) continue
            // v_x = γ y with γ L_y = jump: who leaves above enters below, where the flow is slower by the jump.
            val boxes = floor((y[k] - box.lowerY) / length)
            y[k] = inside(y[k] - boxes * length, box.lowerY, box.upperY)
            vx[k] -= boxes * velocityJump
        }
        wrap(population.x, box.lowerX, box.upperX)
        wrap(population.z, box.lowerZ, box.upperZ)
    }
}

/**
 * Lees–Edwards boundaries (Lees & Edwards 1972, J. Phys. C 5, 1921), the consistent form of a sheared periodic box: the image
 * above the upper y face slides with `shearRate · L_y` along x, its offset is `shearRate · L_y · t` (mod L_x), and contacts are
 * found through all faces. x and z are periodic.
 */
public class LeesEdwards(override val box: Box, public val shearRate: Double) : BoundaryConditions {
    init {
        requireFinite(box) { true }
        require(shearRate.isFinite()) { "shear rate is $shearRate; it must be finite" }
    }

    override val shear: ImageShear = ImageShear(normalAxis = 1, slideAxis = 0, velocity = shearRate * box.length(1), slideLength = box.length(0))

    override fun contactFaces(axis: Int): ContactFaces = ContactFaces.PERIODIC

    override fun endStep(population: Population, time: Double) {
        val x = population.x
        val y = population.y
        val vx = population.vx
        val offset = shear.offset(time)
        val length = box.length(1)
        for (k in 0 until population.size) {
            if (y[k] >= box.lowerY && y[k] < box.upperY) continue
            val boxes = floor((y[k] - box.lowerY) / length)
            y[k] = inside(y[k] - boxes * length, box.lowerY, box.upperY)
            x[k] -= boxes * offset
            vx[k] -= boxes * shear.velocity
        }
        wrap(x, box.lowerX, box.upperX)
        wrap(population.z, box.lowerZ, box.upperZ)
    }
}

private const val AXES = 3

private inline fun requireFinite(box: Box, which: (Int) -> Boolean) {
    for (axis in 0 until AXES) {
        require(!which(axis) || box.length(axis).isFinite()) { "box along ${"xyz"[axis]} must be finite for this boundary" }
    }
}

/** Puts every entry back into [lower, upper). */
internal fun wrap(a: DoubleArray, lower: Double, upper: Double) {
    val length = upper - lower
    for (k in a.indices) {
        val v = a[k]
        if (v >= lower && v < upper) continue
        a[k] = inside(v - floor((v - lower) / length) * length, lower, upper)
    }
}

/** −tiny + length rounds to the upper face itself, which is outside; the nearest double inside is the same point to half an ulp. */
private fun inside(v: Double, lower: Double, upper: Double): Double = if (v < lower) {
    lower
} else if (v >= upper) {
    Math.nextDown(upper)
} else {
    v
}
