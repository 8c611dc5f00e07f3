package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.prepare
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.ExactSum
import daphnis.core.population.Partition
import daphnis.core.population.Partitioned
import daphnis.core.population.Population
import daphnis.core.population.SphereSum
import daphnis.core.space.Images
import kotlin.math.sqrt

/**
 * Gravity between a few heavy spheres and every sphere, pair by pair: moonlets embedded in a ring. Light spheres do not
 * attract one another. Along periodic axes the nearest image counts; images that slide are taken where they are at the
 * time. A light sphere pulls a body as much as the body pulls it, so Σ m v is conserved to round-off. The force on a
 * body is summed exactly, so it does not depend on the order of the arrays.
 *
 * @param bodies ids of the heavy spheres; those that were removed are skipped
 * @param constant G, in length³/(mass · time²)
 * @param softening ε in 1/(r² + ε²), length
 */
public class BodyGravity @JvmOverloads constructor(
    private val bodies: IntArray,
    private val boundary: BoundaryConditions,
    private val constant: Double,
    private val softening: Double = 0.0,
) : Kick,
    Partitioned {
    override var partition: Partition = Partition.Whole
    private var loop: RangeLoop = InlineLoop
    private val images = Images()
    private val sum = SphereSum()

    // Position and mass of each body, and the components of the pull of all spheres on it.
    private val place = DoubleArray(4 * bodies.size)
    private val reaction = Array(3 * bodies.size) { ExactSum() }

    /** On the present body. */
    private val pulls = Pulls()

    init {
        require(constant >= 0 && constant.isFinite()) { "G is $constant; it must be at least 0" }
        require(softening >= 0 && softening.isFinite()) { "softening is $softening; it must be at least 0" }
    }

    override fun useLoop(loop: RangeLoop) {
        this.loop = loop
    }

    override fun kick(population: Population, time: Double, duration: Double) {
        images.prepare(boundary, time)
        pulls.prepare(population.size)
        partition.find(population, bodies, place)
        for (n in bodies.indices) {
            val isThere = !place[4 * n].isNaN()
            if (isThere) loop.run(population.size) { _, from, to -> kickOthers(population, n, duration, from, to) }
            pulls.sum(if (isThere) population.size else 0, reaction, 3 * n)
        }
        partition.merge(reaction)
        for (n in bodies.indices) react(population, n)
    }

    /**
     * Kicks all spheres but the body and the bodies before it, with which it has exchanged kicks; notes the kicks that
     * they give it.
     */
    private fun kickOthers(p: Population, n: Int, duration: Double, from: Int, to: Int) {
        val d = DoubleArray(3)
        val x = place[4 * n]
        val y = place[4 * n + 1]
        val z = place[4 * n + 2]
        val mass = place[4 * n + 3]
        pulls.clear(from, to)
        for (k in from until to) {
            if (p.id[k] == bodies[n] || isEarlierBody(p.id[k], n)) continue
            towardNearest(d, x - p.x[k], y - p.y[k], z - p.z[k])
            val d2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + softening * softening
            if (d2 == 0.0) continue
            val f = constant * duration / (d2 * sqrt(d2))
            p.vx[k] += f * mass * d[0]
            p.vy[k] += f * mass * d[1]
            p.vz[k] += f * mass * d[2]
            pulls.put(k, f * p.mass[k], d[0], d[1], d[2])
        }
    }

    private fun isEarlierBody(id: Int, n: Int): Boolean {
        for (m in 0 until n) if (bodies[m] == id) return true
        return false
    }

    private fun towardNearest(d: DoubleArray, dx: Double, dy: Double, dz: Double) {
        d[0] = dx
        d[1] = dy
        d[2] = dz
        images.toNearest(d)
    }

    /** Gives body [n] what it has given. Its own kicks by the bodies before it are done, and no others follow. */
    private fun react(p: Population, n: Int) {
        val body = p.indexOf(bodies[n])
        if (body < 0) return
        p.vx[body] -= reaction[3 * n].value()
        p.vy[body] -= reaction[3 * n + 1].value()
        p.vz[body] -= reaction[3 * n + 2].value()
    }

    /** −G Σ m_b m/√(d² + ε²) over pairs with a body b, each once, where d is the distance of the nearest images. */
    override fun potentialEnergy(population: Population, boundary: BoundaryConditions, time: Double): Double {
        images.prepare(this.boundary, time)
        val p = population
        val d = DoubleArray(3)
        var energy = 0.0
        partition.find(p, bodies, place)
        for (n in bodies.indices) {
            val b = 4 * n
            if (place[b].isNaN()) continue
            energy += sum.of(p, partition) { k ->
                towardNearest(d, place[b] - p.x[k], place[b + 1] - p.y[k], place[b + 2] - p.z[k])
                val d2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + softening * softening
                val isCounted = p.id[k] != bodies[n] && d2 > 0 && !isEarlierBody(p.id[k], n)
                if (isCounted) -constant * place[b + 3] * p.mass[k] / sqrt(d2) else 0.0
            }
        }
        return energy
    }
}
