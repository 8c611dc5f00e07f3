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
import daphnis.core.collision.FloorSpeedGuard
import daphnis.core.collision.NoGuard
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.initial.Lattice
import daphnis.core.initial.LatticePlacement
import daphnis.core.initial.PlacementException
import daphnis.core.initial.Positions
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRestitution
import java.util.Locale

/** A system on which engines are timed, of any kind that a user may have. Everything follows from [seed]. */
internal class CliffCase(private val seed: Long) {
    private val random = SeededRandom(seed)
    private val spheres = between(30.0, 3000.0).toInt()
    private val radii = drawRadii()
    private val flatness = if (isOneIn(3)) 3.0 else 1.0
    private val start: Population

    /** Collisions per sphere in a step over four decades, but no more of these in all than can be waited for. */
    private val wanted = minOf(between(1e-3, 10.0), MOST_COLLISIONS / spheres)

    /** How much a sheared box is strained in a step. */
    private val strain = random.nextDouble(-0.3, 0.3)

    /** What was drawn, or as much less as it takes to place the spheres. */
    private var filling = if (isOneIn(2)) random.nextDouble(0.3, 0.6) else between(0.003, 0.3)
    private var box = drawBox()
    private var boundary = drawBoundary()

    init {
        var places = place()
        while (places == null) {
            filling *= 0.9
            box = drawBox()
            boundary = drawBoundary()
            places = place()
        }
        start = made(places)
    }

    private val restitution = listOf(1.0, 1.0, 0.8, 0.3)[random.nextInt(4)]
    val threads = 1 + random.nextInt(2)

    private val dt = stepLength()
    private val collisions = dt / meanFreeTime()
    val steps = (MOST_COLLISIONS / (collisions * spheres)).coerceIn(LEAST_STEPS, MOST_STEPS).toInt()

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
        val edge = Math.cbrt(volume * flatness)
        fun atLeast(length: Double) = maxOf(length, 3.0)
        return Box.centred(atLeast(edge * random.nextDouble(0.8, 1.25)), atLeast(edge), atLeast(edge / flatness))
    }

    private fun drawBoundary(): BoundaryConditions = when (random.nextInt(8)) {
        0 -> Open
        1 -> Walls(box, 1.0)
        2 -> ShearedPeriodic(box, strain / stepLength())
        3, 4 -> LeesEdwards(box, strain / stepLength())
        5 -> HillSheet(box, OMEGA)
        else -> Periodic(box)
    }

    /** @return null where there is no room for all */
    private fun place(): Positions? {
        val walled = BooleanArray(AXES) { boundary.contactFaces(it) != ContactFaces.PERIODIC }
        return try {
            if (filling > 0.25) {
                LatticePlacement(Lattice.FACE_CENTRED_CUBIC).place(radii, box, walled, random)
            } else {
                RandomPlacement(TRIES).place(radii, box, walled, random)
            }
        } catch (e: PlacementException) {
            null
        }
    }

    private fun made(at: Positions): Population {
        fun gauss() = DoubleArray(spheres) { random.nextGaussian() }
        // By volume the small ones would soon be far too fast for the step.
        val masses = radii.copyOf()
        return Population(at.x, at.y, at.z, gauss(), gauss(), gauss(), radii, masses)
    }

    /** Not so long that the step is refused, or that the serial engine takes too long for it. */
    private fun stepLength(): Double {
        val edge = minOf(box.length(0), box.length(1), box.length(2))
        var dt = minOf(wanted * meanFreeTime(), MOST_BOXES * edge / FASTEST)
        while (searched(dt) > MOST_SEARCHED) dt *= 0.8
        return dt
    }

    /** How many spheres the serial engine looks at in a step of [dt], about. */
    private fun searched(dt: Double): Double {
        val range = 4 * radii.max() + 2 * FASTEST * dt
        return 2 * dt / meanFreeTime() * spheres * spheres * range * range * range / box.volume
    }

    /** Of a gas, with half the collisions, since two spheres share one. */
    private fun meanFreeTime(): Double {
        val free = 1 - filling
        val contact = (1 - filling / 2) / (free * free * free)
        val mean = radii.average()
        val area = 2 * Math.PI * (radii.sumOf { it * it } / spheres + mean * mean)
        return 2 / (spheres / box.volume * area * RELATIVE_SPEED * contact)
    }

    private fun drawTuning() = HorizonTuning(
        steps = epochSteps,
        classBound = between(0.1, 5.0),
        deviation = if (isOneIn(2)) 0.0 else between(1e-3, 0.3),
        cellsAlong = between(0.3, 8.0),
        cellsAcross = between(0.3, 4.0),
    )

    /** The engine of that [name] as users get it from [make], or with epochs in all steps. */
    fun engine(name: String, make: () -> CollisionEngine): CollisionEngine = if (name == "horizon" && tuning != null) {
        val pool = FixedPool(threads)
        HorizonEngine(pool, 1, tuning, if (threads == 1) null else IslandsEngine(pool))
    } else {
        make()
    }

    /** Of a copy of the start. */
    fun simulation(engine: CollisionEngine): Simulation {
        val guard = if (restitution == 1.0) NoGuard else FloorSpeedGuard(1e-2)
        val forcing = CollisionForcing(ConstantRestitution(restitution), guard, engine)
        val forces = if (boundary is HillSheet && dt * OMEGA < 1) listOf(HillFrame(OMEGA)) else emptyList()
        return Simulation(start.copy(), boundary, forcing, FixedTimeStep(dt), forces)
    }

    override fun toString() =
        "seed %d: %d spheres of %.2f to 1, filling %.3f, %s, restitution %.1f, %.1e collisions, %s"
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

    companion object {
        /** Of the serial engine, after which a case is ended. */
        const val MOST_SECONDS = 0.3
        private const val AXES = 3
        private const val OMEGA = 0.1
        private const val TRIES = 2000

        /** How many boxes the fastest may go in a step. */
        private const val MOST_BOXES = 1.0
        private const val FASTEST = 5.0

        /** Mean speed of two spheres relative to each other, 4 / √π. */
        private const val RELATIVE_SPEED = 2.2568

        /** Expected in a case, and how many steps are for that. */
        private const val MOST_COLLISIONS = 6000.0
        private const val MOST_SEARCHED = 3e7
        private const val LEAST_STEPS = 2.0
        private const val MOST_STEPS = 8.0
    }
}
