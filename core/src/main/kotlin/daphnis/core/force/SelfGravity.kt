package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.Images
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.OrderedSum
import daphnis.core.population.Population

/**
 * Gravity of all spheres on one another, by a tree (Barnes & Hut 1986, Nature 324, 446): a node whose size is below [openingAngle] times its distance counts as
 * one mass at its centre of mass, others are opened. Spheres of one leaf share a walk, so the distance is that from the leaf's box, and a sphere's
 * error is smaller than that of a walk of its own. Along periodic axes [images] boxes on each side attract too, where they are at the time if they slide.
 *
 * The sums are taken in the order of the tree, which depends on positions and ids alone: the same bits on any number of threads. The force at the end
 * of a step is kept for the beginning of the next. Momentum is conserved as well as the opening angle allows, not to round-off.
 *
 * @param constant G, length³/(mass · time²)
 * @param openingAngle θ in [0, 1]; 0 opens everything
 * @param softening ε in 1/(r² + ε²), length
 * @param images boxes on each side, ≥ 0
 */
public class SelfGravity(
    private val boundary: BoundaryConditions,
    public val constant: Double,
    public val openingAngle: Double = 0.5,
    public val softening: Double = 0.0,
    images: Int = 1,
) : Kick {
    private var loop: RangeLoop = InlineLoop
    private val tree = GravityTree()
    private val periodicImages = Images()

    // Which images, centred on the original: those across sliding faces begin with the nearest.
    private val ranges = IntArray(3) { if (boundary.contactFaces(it) == ContactFaces.PERIODIC) images else 0 }
    private val codes = IntArray(ranges.fold(1) { n, range -> n * (2 * range + 1) })
    private val stressRange: Double
    private var walks = arrayOf<GravityWalk>()

    // Of the last evaluation, by index in the population: accelerations, and what they were computed for.
    private var ax = DoubleArray(0)
    private var ay = DoubleArray(0)
    private var az = DoubleArray(0)
    private var stress = DoubleArray(0)
    private var potential = DoubleArray(0)
    private val energy = OrderedSum()
    private val seen = SeenPositions()

    init {
        require(constant >= 0 && constant.isFinite()) { "G is $constant; it must be >= 0" }
        require(openingAngle in 0.0..1.0) { "opening angle is $openingAngle; it must be in [0, 1]" }
        require(softening >= 0 && softening.isFinite()) { "softening is $softening; it must be >= 0" }
        require(images in 0..MOST_IMAGES) { "images is $images; it must be in 0..$MOST_IMAGES" }
        // So far images reach in all directions from everybody, wherever they have slid to.
        val shortest = (0..2).filter { ranges[it] > 0 }.minOfOrNull { boundary.box.length(it) }
        stressRange = if (shortest == null) Double.POSITIVE_INFINITY else shortest * (images - 0.5)
    }

    override fun useLoop(loop: RangeLoop) {
        this.loop = loop
    }

    override fun kick(population: Population, time: Double, duration: Double) {
        evaluate(population, time)
        loop.run(population.size) { _, from, to ->
            for (k in from until to) {
                population.vx[k] += ax[k] * duration
                population.vy[k] += ay[k] * duration
                population.vz[k] += az[k] * duration
            }
        }
    }

    /** Accelerations x y z by index in [population], as it stands at [time]; valid until the next call. */
    public fun accelerations(population: Population, time: Double): Array<DoubleArray> {
        evaluate(population, time)
        return arrayOf(ax, ay, az)
    }

    /**
     * Flux of y momentum along +x that gravity carries at this moment, times the volume: −½ Σ_ij F_y,ij (x_j − x_i), F_ij the force of j on i, over images too, of
     * pairs no farther apart than images reach in every direction, so that a uniform sheet carries none. Of the last kick, whose population this must be;
     * summed in the order of ids.
     */
    public fun stressXY(population: Population): Double {
        if (stress.size < population.size) return 0.0
        var sum = 0.0
        for (id in 0 until population.idBound) {
            val k = population.indexOf(id)
            if (k >= 0) sum -= 0.5 * population.mass[k] * stress[k]
        }
        return sum
    }

    /**
     * ½ Σ m Φ, Φ = −G Σ m_j/√(r² + ε²) over all spheres and images that attract: exact up to the opening angle. The
     * potential is summed in the walk of the force, so where the last kick was at this [time] nothing is walked again.
     */
    override fun potentialEnergy(population: Population, boundary: BoundaryConditions, time: Double): Double {
        evaluate(population, time)
        return energy.of(population) { k -> 0.5 * population.mass[k] * potential[k] }
    }

    private fun evaluate(population: Population, time: Double) {
        if (seen.isSame(population, time)) return
        if (ax.size < population.size) {
            ax = DoubleArray(population.size)
            ay = DoubleArray(population.size)
            az = DoubleArray(population.size)
            stress = DoubleArray(population.size)
            potential = DoubleArray(population.size)
        }
        tree.build(population)
        periodicImages.prepare(boundary, time)
        chooseImages()
        if (walks.size < loop.workers) walks = Array(loop.workers) { GravityWalk(tree, openingAngle, softening, stressRange) }
        loop.run(tree.leafCount, LEAVES_A_PIECE) { worker, from, to ->
            val walk = walks[worker]
            for (leaf in from until to) {
                walk.begin(tree.leaves[leaf])
                for (code in codes) walk.collect(periodicImages.shift(code, 0), periodicImages.shift(code, 1), periodicImages.shift(code, 2))
                walk.sum(constant, ax, ay, az, stress, potential)
            }
        }
        seen.keep(population, time)
    }

    private fun chooseImages() {
        val shear = boundary.shear
        val center = IntArray(3)
        var n = 0
        for (x in -ranges[0]..ranges[0]) {
            for (y in -ranges[1]..ranges[1]) {
                for (z in -ranges[2]..ranges[2]) {
                    if (shear != null) {
                        val boxes = if (shear.normalAxis == 0) {
                            x
                        } else if (shear.normalAxis == 1) {
                            y
                        } else {
                            z
                        }
                        center[shear.slideAxis] = -Math.rint(boxes * periodicImages.shearOffset / boundary.box.length(shear.slideAxis)).toInt()
                    }
                    codes[n++] = Images.code(x + center[0], y + center[1], z + center[2])
                }
            }
        }
    }

    private companion object {
        const val MOST_IMAGES = 60
        const val LEAVES_A_PIECE = 8
    }
}

/** What a force was last computed for: it need not be computed again when nobody has moved. */
private class SeenPositions {
    private var x = DoubleArray(0)
    private var y = DoubleArray(0)
    private var z = DoubleArray(0)
    private var time = Double.NaN

    fun isSame(p: Population, time: Double): Boolean = time == this.time && x.size == p.size && x.contentEquals(p.x) && y.contentEquals(p.y) && z.contentEquals(p.z)

    fun keep(p: Population, time: Double) {
        this.time = time
        if (x.size != p.size) {
            x = DoubleArray(p.size)
            y = DoubleArray(p.size)
            z = DoubleArray(p.size)
        }
        p.x.copyInto(x)
        p.y.copyInto(y)
        p.z.copyInto(z)
    }
}
