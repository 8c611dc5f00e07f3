package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.force.mesh.CompactShape
import daphnis.core.force.mesh.MeshCells
import daphnis.core.force.mesh.MeshPoints
import daphnis.core.force.mesh.MeshWeights
import daphnis.core.force.mesh.NearPulls
import daphnis.core.force.mesh.SheetMesh
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Partition
import daphnis.core.population.Partitioned
import daphnis.core.population.Population
import daphnis.core.population.SphereColumns
import daphnis.core.population.SphereSum

/**
 * Gravity of all spheres of a patch on one another, with all of its images: near spheres pair by pair, the others by a
 * mesh and Fourier transforms (Hockney & Eastwood 1988, Computer Simulation Using Particles, chapter 8). For a box that
 * repeats along x and y, at rest or sliding along y, and is open along z. Nothing is cut: the waves on the mesh are
 * those of the endless sheet, where [SelfGravity] sees up to its range. The rms error of the force is 0.3 to 0.4 %
 * (docs/physics.md).
 *
 * Each sum is taken in the order of the cells of the mesh and of ids, so the bits are the same on any number of threads
 * and for any order of the arrays. Momentum is conserved as well as the mesh allows, not to round-off.
 *
 * @param constant G, length³/(mass · time²)
 * @param softening ε in 1/(r² + ε²), length; the mesh is never finer than 9 ε
 * @param spacing of the points of the mesh, length; 0 for about one point in the plane per sphere
 * @throws IllegalArgumentException when the box does not repeat so, or a number is out of range
 */
public class MeshGravity @JvmOverloads constructor(
    private val boundary: BoundaryConditions,
    public val constant: Double,
    public val softening: Double = 0.0,
    public val spacing: Double = 0.0,
) : MutualGravity,
    Partitioned {
    override var partition: Partition = Partition.Whole
    private var loop: RangeLoop = InlineLoop
    private val cells = MeshCells()
    private val sum = SphereSum()
    private val last = Accelerations()
    private var mesh: SheetMesh? = null
    private val meshes = ArrayList<SheetMesh>()
    private var weights = arrayOf<MeshWeights>()
    private var pulls = arrayOf<NearPulls>()

    // From the last evaluation, by index in the population, as [last].
    private var stress = DoubleArray(0)
    private var potential = DoubleArray(0)

    /** How many of the first spheres are those of the population. */
    private var own = 0

    /** Whether stress and potential are of that evaluation, too. */
    private var isMeasured = false

    init {
        require(constant >= 0 && constant.isFinite()) { "G is $constant; it must be at least 0" }
        require(softening >= 0 && softening.isFinite()) { "softening is $softening; it must be at least 0" }
        require(spacing >= 0 && spacing.isFinite()) { "spacing is $spacing; it must be at least 0" }
        require(fits(boundary)) { "gravity by a mesh needs a box that repeats along x and y, not along z" }
    }

    override val range: Double get() = Double.POSITIVE_INFINITY

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

    /** How far apart points of the mesh are for [population] along x or y, where they are further. Length. */
    public fun spacingFor(population: Population): Double = pointsFor(population).let { maxOf(it.hx, it.hy) }

    /** Takes a transform more than the force: the share of the mesh is not known by sphere. */
    override fun stressXY(population: Population, time: Double): Double {
        evaluate(population, time)
        val mesh = mesh ?: return 0.0
        measure()
        val near = sum.of(population, partition) { k -> -0.5 * population.mass[k] * stress[k] }
        // Takes the place of the potentials, which nobody needs any more.
        fill(mesh)
        return near - 0.5 * constant * mesh.stress(loop, cells.offset)
    }

    /**
     * ½ Σ m Φ over all spheres and images. Φ is that of the endless sheet without its mean, which is a constant: that
     * of a thin uniform sheet at z = 0 is 2πGΣ|z|.
     */
    override fun potentialEnergy(population: Population, boundary: BoundaryConditions, time: Double): Double {
        evaluate(population, time)
        measure()
        return sum.of(population, partition) { k -> 0.5 * population.mass[k] * potential[k] }
    }

    private fun evaluate(population: Population, time: Double) {
        if (last.areOf(population, time, partition)) return
        last.begin(population.size)
        isMeasured = false
        makeRoom(population.size)
        val all = partition.everyone(population, Partition.MASSES)
        own = population.size
        if (all.size > 0) {
            val mesh = meshFor(all)
            val box = boundary.box
            cells.sort(all, mesh.points, box.lowerX, box.lowerY, boundary.shear?.offset(time) ?: 0.0)
            fill(mesh)
            mesh.solve(loop, cells.offset)
            read(mesh)
        }
        last.keep(population, time)
    }

    private fun makeRoom(size: Int) {
        if (weights.size < loop.workers) {
            pulls = Array(loop.workers) { NearPulls(cells, softening) }
            // Last, as below.
            weights = Array(loop.workers) { MeshWeights(cells) }
        }
        if (potential.size >= size) return
        stress = DoubleArray(size)
        // Assigned last, as in Accelerations.
        potential = DoubleArray(size)
    }

    /** One of the last evaluations, where it fits: how high spheres rise goes up and down. */
    private fun meshFor(p: SphereColumns): SheetMesh {
        val points = pointsFor(p)
        val found = meshes.find { it.points == points } ?: SheetMesh(points)
        if (mesh !== found) {
            meshes.remove(found)
            if (meshes.size == MESHES) meshes.removeAt(0)
            meshes.add(found)
            mesh = found
        }
        return found
    }

    private fun pointsFor(p: SphereColumns): MeshPoints {
        var lowest = Double.POSITIVE_INFINITY
        var highest = Double.NEGATIVE_INFINITY
        for (k in 0 until p.size) {
            lowest = Math.min(lowest, p.z[k])
            highest = Math.max(highest, p.z[k])
        }
        val box = boundary.box
        return MeshPoints.choose(p.size, box.length(0), box.length(1), lowest, highest, spacing, softening)
    }

    private fun fill(mesh: SheetMesh) {
        loop.run(mesh.points.nx, COLUMNS) { worker, from, to ->
            for (column in from until to) weights[worker].fill(mesh, column)
        }
    }

    private fun read(mesh: SheetMesh) {
        for (near in pulls) near.begin(mesh.points)
        val ax = last.x
        val ay = last.y
        val az = last.z
        loop.run(cells.count, SPHERES) { worker, from, to ->
            val far = weights[worker]
            val near = pulls[worker]
            for (place in from until to) {
                val k = cells.order[place]
                if (k >= own) continue
                far.read(mesh, place)
                near.pull(place)
                ax[k] = constant * (far.ax + near.ax)
                ay[k] = constant * (far.ay + near.ay)
                az[k] = constant * (far.az + near.az)
            }
        }
    }

    /** Stress of near pairs and potential of every sphere, for the state of the last evaluation. */
    private fun measure() {
        val mesh = mesh ?: return
        if (isMeasured) return
        val self = CompactShape(mesh.points.reach).middle
        loop.run(cells.count, SPHERES) { worker, from, to ->
            val far = weights[worker]
            val near = pulls[worker]
            for (place in from until to) {
                val k = cells.order[place]
                if (k >= own) continue
                far.read(mesh, place)
                near.measure(place)
                stress[k] = constant * near.stress
                potential[k] = -constant * (far.depth + near.depth - cells.mass[place] * self)
            }
        }
        isMeasured = true
    }

    public companion object {
        private const val COLUMNS = 4
        private const val SPHERES = 256

        /** Meshes that are kept. */
        private const val MESHES = 3

        /** Whether a mesh fits a box with [boundary]: it repeats along x and y, and slides along y if at all. */
        @JvmStatic
        public fun fits(boundary: BoundaryConditions): Boolean = boundary.hasImages(0) &&
            boundary.hasImages(1) &&
            !boundary.repeats(2) &&
            (boundary.shear?.normalAxis ?: 0) == 0
    }
}
