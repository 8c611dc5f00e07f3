package daphnis.drills

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.ShearedPeriodic
import daphnis.core.boundary.Walls
import daphnis.core.collision.ConstantRestitution
import daphnis.core.collision.FloorSpeedGuard
import daphnis.core.collision.NoGuard
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.initial.Lattice
import daphnis.core.initial.LatticePlacement
import daphnis.core.initial.PlacementException
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import java.util.Locale

/** A system on which engines are timed, of any kind that a user may have. Everything follows from [seed]. */
internal class CliffCase(private val seed: Long) {
    private val random = SeededRandom(seed)
    private val spheres = between(30.0, 3000.0).toInt()
    private val filling = if (isOneIn(2)) random.nextDouble(0.3, 0.6) else between(0.003, 0.3)
    private val radii = drawRadii()
    private val box = drawBox()
    private var boundary = drawBoundary()
    private val start = populate()
    private val restitution = listOf(1.0, 1.0, 0.8, 0.3)[random.nextInt(4)]
    val threads = 1 + random.nextInt(2)

    /** Collisions per sphere in a step, over four decades, but no more than can be waited for. */
    private val collisions = minOf(between(1e-3, 10.0), MOST_COLLISIONS / spheres)
    val steps = (MOST_COLLISIONS / (collisions * spheres)).coerceIn(LEAST_STEPS, MOST_STEPS).toInt()
    private val dt = collisions * meanFreeTime()

    /** How epochs are laid out where somebody wants them; null in most cases. */
    private val epochSteps = 1 + random.nextInt(if (isOneIn(3)) 64 else 6)
    private val tuning = if (isOneIn(4)) drawTuning() else null

    private fun isOneIn(many: Int) = random.nextInt(many) == 0

    private fun between(least: Double, most: Double) = least * Math.pow(most / least, random.nextDouble(0.0, 1.0))

    private fun drawRadii(): DoubleArray {
        val smallest = listOf(1.0, 1.0, 0.7, 0.3, 0.05)[random.nextInt(5)]
        return DoubleArray(spheres) {
            when {
                smallest == 1.0 -> 1.0

                // A few much larger ones among many small.
                smallest < 0.1 -> if (it % 100 == 0) 1.0 else random.nextDouble(smallest, 2 * smallest)

                else -> random.nextDouble(smallest, 1.0)
            }
        }
    }

    private fun drawBox(): Box {
        val volume = radii.sumOf { 4.0 / 3 * Math.PI * it * it * it } / filling
        val flatness = if (isOneIn(3)) 3.0 else 1.0
        val edge = Math.cbrt(volume * flatness)
        fun atLeast(length: Double) = maxOf(length, 3.0)
        return Box.centred(atLeast(edge * random.nextDouble(0.8, 1.25)), atLeast(edge), atLeast(edge / flatness))
    }

    private fun drawBoundary(): BoundaryConditions = when (random.nextInt(8)) {
        0 -> Open
        1 -> Walls(box, 1.0)
        2 -> ShearedPeriodic(box, random.nextDouble(-1.0, 1.0))
        3, 4 -> LeesEdwards(box, random.nextDouble(-1.0, 1.0))
        5 -> HillSheet(box, OMEGA)
        else -> Periodic(box)
    }

    private fun populate(): Population {
        val walled = BooleanArray(AXES) { boundary.contactFaces(it) != ContactFaces.PERIODIC }
        val places = try {
            if (filling > 0.25) {
                LatticePlacement(Lattice.FACE_CENTRED_CUBIC).place(radii, box, walled, random)
            } else {
                RandomPlacement(TRIES).place(radii, box, walled, random)
            }
        } catch (e: PlacementException) {
            // The radii differ too much for that density: loosely packed in open space does as well.
            boundary = Open
            val pitch = 2.01
            val edge = Math.ceil(Math.cbrt(1.0 * spheres)).toInt()
            fun lattice(stride: Int) = DoubleArray(spheres) { (it / stride % edge - (edge - 1) / 2.0) * pitch }
            return made(lattice(1), lattice(edge), lattice(edge * edge))
        }
        return made(places.x, places.y, places.z)
    }

    private fun made(x: DoubleArray, y: DoubleArray, z: DoubleArray): Population {
        fun gauss() = DoubleArray(spheres) { random.nextGaussian() }
        return Population(x, y, z, gauss(), gauss(), gauss(), radii, DoubleArray(spheres) { Math.pow(radii[it], 3.0) })
    }

    /** Of a gas of spheres of one size; half of it, since two spheres share a collision. */
    private fun meanFreeTime(): Double {
        val free = 1 - filling
        val contact = (1 - filling / 2) / (free * free * free)
        return 2 * radii.average() / (12 / Math.sqrt(Math.PI) * filling * contact)
    }

    private fun drawTuning() = HorizonTuning(
        steps = epochSteps,
        classBound = between(0.1, 5.0),
        deviation = if (isOneIn(2)) 0.0 else between(1e-3, 0.3),
        cellsAlong = between(0.3, 8.0),
        cellsAcross = between(0.3, 4.0),
    )

    /** The engine of that [name] as users get it from [make], or with epochs in all steps. */
    fun engine(name: String, make: () -> CollisionEngine): CollisionEngine =
        if (name == "horizon" && tuning != null) HorizonEngine(FixedPool(threads), 1, tuning) else make()

    /** Of a copy of the start. */
    fun simulation(engine: CollisionEngine): Simulation {
        val guard = if (restitution == 1.0) NoGuard else FloorSpeedGuard(1e-2)
        val forcing = CollisionForcing(ConstantRestitution(restitution), guard, engine)
        val forces = if (boundary is HillSheet && dt * OMEGA < 1) listOf(HillFrame(OMEGA)) else emptyList()
        return Simulation(start.copy(), boundary, forcing, FixedTimeStep(dt), forces)
    }

    override fun toString() = "seed %d: %d spheres of %.2f to 1, filling %.3f, %s, restitution %.1f, %.1e collisions, %s"
        .format(
            Locale.ROOT,
            seed,
            spheres,
            radii.min(),
            filling,
            boundary.javaClass.simpleName,
            restitution,
            collisions,
            "$threads threads" + if (tuning == null) "" else ", epochs of $epochSteps steps",
        )

    private companion object {
        const val AXES = 3
        const val OMEGA = 0.1
        const val TRIES = 2000

        /** Expected in a case, and how many steps are for that. */
        const val MOST_COLLISIONS = 6000.0
        const val LEAST_STEPS = 2.0
        const val MOST_STEPS = 8.0
    }
}
