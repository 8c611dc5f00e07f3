package daphnis.core.engine.lists

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollapseGuard
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.ContactDurationGuard
import daphnis.core.collision.FloorSpeedGuard
import daphnis.core.collision.NoGuard
import daphnis.core.compression.GrowingSpheres
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SurfaceDraw
import daphnis.core.engine.exchange
import daphnis.core.force.Force
import daphnis.core.force.Kick
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.Restitution
import kotlin.math.pow

/** A dense system, and the meddling with it between steps. Everything follows from [seed]. */
class DenseDraw(private val seed: Long) {
    private val random = SeededRandom(seed)
    private val surface = SurfaceDraw(seed)
    private val nx = 3 + random.nextInt(5)
    private val ny = 3 + random.nextInt(5)
    private val nz = 3 + random.nextInt(5)
    private val unit = if (random.nextInt(4) == 0) 10.0.pow(random.nextInt(9) - 4) else 1.0

    /** Distance of neighbours on the lattice of the start, in diameters. */
    private val apart = if (random.nextInt(40) == 0) 1.0 else random.nextDouble(1.0, 1.5)
    private val isLattice = random.nextInt(5) == 0
    private val isMixed = random.nextInt(3) == 0
    private val lower = unit * if (random.nextInt(3) == 0) random.nextDouble(-100.0, 100.0) else 0.0
    private val pitch = 2 * unit * apart
    private val box = Box(
        lower,
        lower,
        lower,
        lower + pitch * nx,
        lower + pitch * ny,
        lower + pitch * nz,
    )
    val boundary: BoundaryConditions = when (random.nextInt(8)) {
        0 -> Open
        1 -> Periodic(box, periodicX = false)
        2 -> Periodic(box, periodicY = false, periodicZ = random.nextInt(2) == 0)
        else -> Periodic(box)
    }
    private val dt = 10.0.pow(random.nextDouble(-3.0, 0.4))
    private val guard: CollapseGuard = when (random.nextInt(4)) {
        0 -> ContactDurationGuard(1e-3 * dt)
        1 -> FloorSpeedGuard(0.05 * unit)
        else -> NoGuard
    }
    private val restitution: Restitution =
        ConstantRestitution(if (guard == NoGuard) 1.0 else random.nextDouble(0.0, 1.0))
    private val spring = random.nextDouble(0.0, 0.2)
    private val hasForce = random.nextInt(3) == 0
    val isMeddled = random.nextInt(2) == 0
    private val start = surface.of(population())

    private fun population(): Population {
        val n = nx * ny * nz
        val jitter = if (isLattice) 0.0 else (apart - 1) * unit * 0.99
        fun at(c: Int) = lower + pitch * (c + 0.5) + if (jitter > 0) random.nextDouble(-jitter, jitter) / 2 else 0.0
        val x = DoubleArray(n) { at(it % nx) }
        val y = DoubleArray(n) { at(it / nx % ny) }
        val z = DoubleArray(n) { at(it / nx / ny) }
        fun speeds() = DoubleArray(n) {
            if (isLattice) unit * (random.nextInt(3) - 1) else unit * random.nextGaussian()
        }
        val radii = DoubleArray(n) { unit * if (isMixed) random.nextDouble(0.4, 1.0) else 1.0 }
        return Population(x, y, z, speeds(), speeds(), speeds(), radii, DoubleArray(n) { radii[it].pow(3) })
    }

    /** In some of the boxes that repeat spheres grow or shrink; a boundary for each simulation, since it knows its step. */
    private fun around(): BoundaryConditions {
        val isWhole = boundary is Periodic && (0..2).all { boundary.hasImages(it) }
        if (!isWhole || seed % 3 != 0L || apart < 1.1) return boundary
        val part = 0.03 * (apart - 1)
        return GrowingSpheres(box, (if (seed % 2 == 0L) part else -part) / dt, thermostat = seed % 5 != 0L)
    }

    fun simulation(engine: CollisionEngine, restitution: Restitution = this.restitution) = Simulation(
        start.copy(),
        around(),
        surface.collisions(restitution, guard, engine),
        FixedTimeStep(dt),
        if (hasForce) listOf(pull()) else emptyList(),
    )

    val law get() = CollisionLaw(surface.law(restitution), guard, momentFactor = surface.momentFactor)

    private fun pull(): Force = Kick { p, time, duration ->
        // Only some, and not in every step.
        if ((time / duration).toInt() % 2 == 0) {
            for (k in 0 until p.size) if (p.id[k] % 3 != 0) p.vx[k] -= spring * duration * (p.x[k] - lower)
        }
    }

    /** Does the same to the spheres of each of [simulations] after step [step], by their ids. */
    fun meddle(step: Int, simulations: List<Simulation>) {
        val what = SeededRandom(seed * 1000 + step).nextInt(14)
        for (simulation in simulations) {
            val random = SeededRandom(seed * 7919 + step)
            val p = simulation.population
            val one = p.indexOf(p.id.max())
            val other = p.indexOf(p.id.min())
            when (what) {
                0 -> p.vy[one] = random.nextDouble(-4.0, 4.0) * unit
                1 -> p.z[one] = lower + random.nextDouble(0.0, pitch * nz)
                2 -> p.retain { p.id[it] % 17 != step % 17 || p.size < 20 }
                3 -> p.add(visitor(1000 + step))
                4 -> p.radius[other] *= 1.02
                5 -> p.mass[other] *= 2.0
                6 -> exchange(p, 0, p.size - 1)
                7 -> p.vx[other] = -0.0
                8 -> for (k in 0 until p.size) p.vx[k] += 0.1 * unit
                9 -> p.x[one] += 0.01 * unit
                10 -> if (p.hasSpin) p.wz[one] = -p.wx[other]
            }
        }
    }

    private fun visitor(id: Int): Population {
        fun one(v: Double) = doubleArrayOf(v)
        val at = lower + pitch
        val place = List(3) { one(at) }
        val speed = List(3) { one(unit - it) }
        return Population(
            place[0],
            place[1],
            place[2],
            speed[0],
            speed[1],
            speed[2],
            one(0.4 * unit),
            one(0.1),
            intArrayOf(id),
        )
    }

    override fun toString() =
        "seed $seed: ${start.size} spheres, ${boundary.javaClass.simpleName}, $apart apart, dt $dt" +
            (if (isLattice) ", lattice" else "") + (if (isMixed) ", mixed" else "") + ", unit $unit"
}
