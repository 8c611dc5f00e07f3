package daphnis.core.engine.horizon

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.ShearedPeriodic
import daphnis.core.boundary.Walls
import daphnis.core.collision.CollapseGuard
import daphnis.core.collision.ContactDurationGuard
import daphnis.core.collision.NoGuard
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SurfaceDraw
import daphnis.core.engine.exchange
import daphnis.core.force.Force
import daphnis.core.force.Kick
import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.hill.Satellite
import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRestitution

/**
 * A dilute system for many steps, and the meddling of outputs with it between steps. Everything follows from [seed].
 *
 * @param longer factor by which steps are longer than usual
 */
class LongDraw(private val seed: Long, longer: Double = 1.0) {
    private val random = SeededRandom(seed)
    private val surface = SurfaceDraw(seed)
    private val edge = 4 + random.nextInt(3)
    private val apart = random.nextDouble(2.2, 4.5)
    private val isMixed = random.nextInt(3) == 0
    private val hasGiants = random.nextInt(3) == 0
    private val omega = random.nextDouble(0.02, 0.1)
    private val orbits = OrbitalFrequencies(omega, if (random.nextInt(2) == 0) 1.0 else 0.8, 1.5)

    /** In some draws floats are hardly good enough for lines. */
    private val farther = if (seed % 5 == 0L) 100.0 else 1.0
    private val low = if (random.nextInt(3) == 0) random.nextDouble(-300.0, 300.0) * farther else -apart * edge / 2
    private val box = Box(low, low, low, low + apart * edge, low + apart * edge, low + apart * edge)
    val boundary: BoundaryConditions = when (random.nextInt(10)) {
        0 -> Open
        1 -> Periodic(box, periodicX = false)
        2, 3 -> LeesEdwards(box, random.nextDouble(-0.2, 0.2))
        4 -> ShearedPeriodic(box, random.nextDouble(-2.0, 2.0))
        5, 6 -> HillSheet(box, orbits)
        7 -> Walls(box, random.nextDouble(0.3, 1.0), roughness = surface.walls)
        8 -> Walls(box, 1.0, booleanArrayOf(false, true, random.nextInt(2) == 0), surface.walls)
        else -> Periodic(box)
    }
    private val dt = longer * random.nextDouble(0.05, 0.4)
    private val guard: CollapseGuard = if (random.nextInt(3) == 0) ContactDurationGuard(1e-3 * dt) else NoGuard
    private val restitution = ConstantRestitution(if (guard == NoGuard) 1.0 else 0.7)
    private val spring = random.nextDouble(0.0, 0.05)
    private val hasForce = random.nextInt(2) == 0
    private val start = surface.of(population(edge * edge * edge, 0))
    val isMeddled = random.nextInt(3) == 0

    private fun population(count: Int, firstId: Int): Population {
        fun at(c: Int) = low + apart * (c + 0.5) + random.nextDouble(-0.1, 0.1)
        val x = DoubleArray(count) { at(it % edge) }
        val y = DoubleArray(count) { at(it / edge % edge) }
        val z = DoubleArray(count) { at(it / edge / edge) }
        val speed = random.nextDouble(0.3, 1.5)
        fun gauss() = DoubleArray(count) { speed * random.nextGaussian() }
        // Some are much faster than the rest.
        val vx = DoubleArray(count) { speed * random.nextGaussian() * if (random.nextInt(20) == 0) 6.0 else 1.0 }
        val radii = DoubleArray(count) { if (isMixed) random.nextDouble(0.3, 1.0) else 1.0 }
        if (hasGiants) for (k in 0 until count) if (random.nextInt(20) > 0) radii[k] *= 0.1
        val masses = DoubleArray(count) { radii[it] * radii[it] * radii[it] }
        return Population(x, y, z, vx, gauss(), gauss(), radii, masses, IntArray(count) { firstId + it })
    }

    fun simulation(engine: CollisionEngine) = Simulation(
        start.copy(),
        boundary,
        surface.collisions(restitution, guard, engine),
        FixedTimeStep(dt),
        forces(),
    )

    private fun forces(): List<Force> {
        val middle = low + apart * edge / 2
        val pull = Kick { p, _, duration ->
            for (k in 0 until p.size) p.vx[k] -= spring * duration * (p.x[k] - middle)
            for (k in 0 until p.size) p.vz[k] -= spring * duration * (p.z[k] - middle)
        }
        if (boundary is HillSheet) {
            val moon = Satellite(omega * omega * 10, Epicycle(2 * box.upperX, 0.0, 0.5, 1.0), orbits, softening = 0.5)
            return listOf(moon, HillFrame(orbits))
        }
        val fall = Kick { p, _, duration -> for (k in 0 until p.size) p.vy[k] -= 4 * spring * duration }
        return if (!hasForce) emptyList() else listOf(if (boundary is Walls) fall else pull)
    }

    /** Does the same to the spheres of each of [simulations] after step [step], by their ids. */
    fun meddle(step: Int, simulations: List<Simulation>) {
        val what = SeededRandom(seed * 1000 + step).nextInt(12)
        for (simulation in simulations) {
            val random = SeededRandom(seed * 7919 + step)
            val p = simulation.population
            val one = p.indexOf(p.id.max())
            val other = p.indexOf(p.id.min())
            when (what) {
                0 -> p.vy[one] = random.nextDouble(-4.0, 4.0)
                1 -> p.z[one] = low + random.nextDouble(0.0, apart * edge)
                2 -> p.retain { p.id[it] % 17 != step % 17 || p.size < 20 }
                3 -> p.add(visitor(1000 + step))
                4 -> p.radius[other] *= 1.02
                5 -> p.mass[other] *= 2.0
                6 -> exchange(p, 0, p.size - 1)
                7 -> if (p.hasSpin) p.wz[one] = -p.wx[other]
            }
        }
    }

    private fun visitor(id: Int) = Population(
        doubleArrayOf(low + apart),
        doubleArrayOf(low + apart),
        doubleArrayOf(low + apart),
        doubleArrayOf(1.0),
        doubleArrayOf(-1.0),
        doubleArrayOf(0.5),
        doubleArrayOf(0.4),
        doubleArrayOf(0.1),
        intArrayOf(id),
    )

    override fun toString() = "seed $seed: ${start.size} spheres, ${boundary.javaClass.simpleName}, dt $dt"
}
