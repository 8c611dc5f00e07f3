package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.prepare
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Partition
import daphnis.core.population.Partitioned
import daphnis.core.population.Population
import daphnis.core.population.SphereSum
import daphnis.core.space.Images

/**
 * Gravity of all spheres on one another, by a tree (Barnes & Hut 1986, Nature 324, 446): a node whose size is below
 * [openingAngle] times its distance counts as one mass at its centre of mass; other nodes are opened. Spheres of one
 * leaf share a walk, so the distance is that from the leaf's box, and a sphere's error is smaller than with a walk of
 * its own.
 *
 * Along periodic axes images attract too; those that slide are taken where they are at the time. Gravity on a particle
 * ends at one distance around itself ([range]) and fades from half of it on. So a uniform sheet exerts no force along
 * itself, and a patch has no preferred centre. Without periodic axes everything attracts.
 *
 * The sums are taken in the order of the tree, which depends on positions and ids alone, so the bits are the same on
 * any number of threads. The force at the end of a step is kept for the beginning of the next. Momentum is conserved as
 * well as the opening angle allows, not to round-off.
 *
 * @param constant G, length³/(mass · time²)
 * @param openingAngle θ in [0, 1]; 0 opens everything
 * @param softening ε in 1/(r² + ε²), length
 * @param images boxes on each side, in 0..[MOST_IMAGES]: gravity reaches ([images] + ½) of the shortest periodic edge
 */
public class SelfGravity @JvmOverloads constructor(
    private val boundary: BoundaryConditions,
    public val constant: Double,
    public val openingAngle: Double = 0.5,
    public val softening: Double = 0.0,
    images: Int = 1,
) : MutualGravity,
    Partitioned {
    override var partition: Partition = Partition.Whole
    private var loop: RangeLoop = InlineLoop
    private val tree = GravityTree()
    private val periodicImages = Images()
    private var walks = arrayOf<GravityWalk>()

    // From the last evaluation, by index in the population: accelerations, and the positions they were computed for.
    private var stress = DoubleArray(0)
    private var potential = DoubleArray(0)
    private val sum = SphereSum()
    private val last = Accelerations()

    init {
        require(constant >= 0 && constant.isFinite()) { "G is $constant; it must be at least 0" }
        require(openingAngle in 0.0..1.0) { "opening angle is $openingAngle; it must be in [0, 1]" }
        require(softening >= 0 && softening.isFinite()) { "softening is $softening; it must be at least 0" }
        require(images in 0..MOST_IMAGES) { "images is $images; it must be in 0..$MOST_IMAGES" }
    }

    private val cut = GravityCut(boundary, images)

    /** Where gravity ends, by the distance along the periodic axes; infinite when nothing repeats. Length. */
    override val range: Double get() = cut.range

    override fun useLoop(loop: RangeLoop) {
        this.loop = loop
    }

    override fun kick(population: Population, time: Double, duration: Double) {
        evaluate(population, time)
        last.kick(population, duration, loop)
    }

    override fun accelerations(population: Population, time: Double): Array<DoubleArray> {
        evaluate(population, time)
        return arrayOf(last.x, last.y, last.z)
    }

    override fun stressXY(population: Population, time: Double): Double {
        evaluate(population, time)
        return sum.of(population, partition) { k -> -0.5 * population.mass[k] * stress[k] }
    }

    /**
     * ½ Σ m Φ over all spheres and images that attract, with Φ = −G Σ m_j/√(r² + ε²), raised so that it is 0 where
     * gravity ends (see [FadingPotential]). Exact up to the opening angle. The potential is summed in the walk of the
     * force, so there is no second walk when the last kick was at this [time].
     */
    override fun potentialEnergy(population: Population, boundary: BoundaryConditions, time: Double): Double {
        evaluate(population, time)
        return sum.of(population, partition) { k -> 0.5 * population.mass[k] * potential[k] }
    }

    private fun evaluate(population: Population, time: Double) {
        if (last.areOf(population, time, partition)) return
        last.begin(population.size)
        if (potential.size < population.size) {
            stress = DoubleArray(population.size)
            // Assigned last, as in Accelerations.
            potential = DoubleArray(population.size)
        }
        tree.build(partition.everyone(population, Partition.MASSES))
        periodicImages.prepare(boundary, time)
        cut.choose(periodicImages)
        if (walks.size < loop.workers) walks = Array(loop.workers) { GravityWalk(tree, openingAngle, softening, cut) }
        loop.run(tree.leaves.size, LEAVES_A_PIECE) { worker, from, to ->
            val walk = walks[worker]
            for (leaf in from until to) {
                if (!tree.hasAny(tree.leaves[leaf], population.size)) continue
                walk.begin(tree.leaves[leaf])
                for (code in cut.codes) {
                    walk.collect(
                        periodicImages.shift(code, 0),
                        periodicImages.shift(code, 1),
                        periodicImages.shift(code, 2),
                    )
                }
                walk.sum(population.size, constant, last.x, last.y, last.z, stress, potential)
            }
        }
        last.keep(population, time)
    }

    public companion object {
        /** The most boxes on each side: with sliding images their numbers along two axes must fit a code. */
        public const val MOST_IMAGES: Int = 60
        private const val LEAVES_A_PIECE = 8
    }
}
