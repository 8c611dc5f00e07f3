package daphnis.core.engine

import daphnis.core.CellCrossingTimeStep
import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.ContactDurationGuard
import daphnis.core.force.Force
import daphnis.core.force.SelfGravity
import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.hill.Satellite
import daphnis.core.hill.SatelliteSurface
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue

/** What the failing simulation consists of. Each has forces, a guard that needs times of collisions, two outputs. */
enum class FailingCase {
    /** A shearing sheet with self-gravity: spheres cross faces that slide. */
    SHEET,

    /** A moon that swallows spheres, and a time step that changes. */
    MOON,

    /** No forces: the population alone has to be put back. */
    GAS,
}

/**
 * Throws at every call of every function that a user gives to a simulation, one after the other. A step that throws
 * must leave everything to the last bit as it was, and the steps that are done must be those of the serial engine that
 * nothing disturbs. An engine may also get over a failure within it, and do the step.
 *
 * @param engine makes the engine, null for none
 */
class FailingSteps(private val case: FailingCase, private val seed: Long, engine: () -> CollisionEngine?) :
    AutoCloseable {
    private class Made(
        val simulation: Simulation,
        val wire: Tripwire,
        val outputs: List<WiredOutput>,
        val moon: SatelliteSurface?,
    )

    private val made = make(engine())
    private val undisturbed = make(if (made.simulation.collisions == null) null else SerialEngine())
    private val simulation = made.simulation
    private val story get() = "$case, seed $seed, ${simulation.collisions?.engine?.name}, step ${simulation.step}"

    /** Steps that threw. */
    var failed = 0
        private set

    /** Calls that threw, those which an engine got over included. */
    var thrown = 0
        private set

    /** Where it has thrown at all. */
    val places = sortedSetOf<String>()

    init {
        for (m in listOf(made, undisturbed)) m.simulation.open()
    }

    /**
     * Throws what [failure] makes at call 0, 1, 2, … of a step, until a step has no such call any more, or at each
     * [every] of them: first of the calls around the engine, then of those within, which it may get over.
     */
    fun throwAtEachCall(every: Int = 1, failure: (Int) -> Throwable = { IllegalStateException("on purpose, $it") }) {
        throwAtEachCall(every, failure) { it !in WITHIN_ENGINE }
        throwAtEachCall(every, failure) { it in WITHIN_ENGINE }
    }

    private fun throwAtEachCall(every: Int, failure: (Int) -> Throwable, counts: (String) -> Boolean) {
        var call = 0
        while (true) {
            val thrown = failure(call)
            made.wire.arm(call, thrown, counts)
            val before = BitState(simulation)
            val caught = runCatching { simulation.advance() }.exceptionOrNull()
            val place = made.wire.tripped
            made.wire.disarm()
            if (caught == null) {
                compareDone("$story, call $call at $place")
            } else {
                assertTrue(isBecauseOf(caught, thrown)) { "$story, call $call at $place threw $caught" }
                before.assertIsStill(simulation, "$story, call $call at $place")
                failed++
            }
            if (place == null) return
            if (caught == null) {
                assertTrue(place in WITHIN_ENGINE) { "$story: what $place threw is lost" }
            } else if (place !in WITHIN_ENGINE) {
                assertSame(thrown, caught) { "$story at $place" }
            }
            places += place
            this.thrown++
            call += every
        }
    }

    /** More steps that nothing disturbs, and what the outputs have seen in the end: each state once. */
    fun finish() {
        repeat(UNDISTURBED) {
            simulation.advance()
            compareDone(story)
        }
        val p = simulation.population
        val isEventful = if (made.moon != null) made.moon.removed > 0 else p.id.any { p.boxesCrossed(it, 0) != 0 }
        assertTrue(isEventful) { "$story: none crossed a face, or fell onto the moon" }
        for (output in made.outputs) assertEquals(undisturbed.outputs[0].seen, output.seen) { story }
        assertEquals(undisturbed.moon?.removed, made.moon?.removed) { story }
    }

    override fun close() {
        simulation.close()
        undisturbed.simulation.close()
    }

    private fun compareDone(story: String) {
        undisturbed.simulation.advance()
        assertEquals(BitState(undisturbed.simulation).byId(), BitState(simulation).byId()) { story }
    }

    private fun isBecauseOf(caught: Throwable, thrown: Throwable): Boolean =
        generateSequence(caught) { it.cause }.any { it === thrown || thrown in it.suppressed }

    private fun make(engine: CollisionEngine?): Made {
        val wire = Tripwire()
        val sheet = HillSheet(Box.centred(EDGE, EDGE, EDGE), OMEGA)
        val moon = Satellite(4.0, Epicycle(0.0, 0.0, 0.0, 0.0), OMEGA, softening = 0.5)
        val surface = if (case == FailingCase.MOON) SatelliteSurface(Periodic(sheet.box), moon, 1.5) else null
        // Feels them: what it carries is taken back with a step.
        val free = Satellite(4.0, Epicycle(EDGE, 0.0, 0.0, 0.0), OrbitalFrequencies(OMEGA), softening = 0.5, mass = 4.0)
        val boundary: BoundaryConditions = when (case) {
            FailingCase.SHEET -> WiredPieces(sheet, wire)
            FailingCase.MOON -> WiredBoundary(surface!!, wire)
            FailingCase.GAS -> WiredPieces(Periodic(sheet.box), wire)
        }
        val forces: List<Force> = when (case) {
            FailingCase.SHEET -> {
                val gravity = WiredForce(SelfGravity(boundary, 0.02), wire)
                listOf(gravity, free, WiredSpring(wire), WiredDrift(HillFrame(OMEGA), wire))
            }
            FailingCase.MOON -> listOf(WiredSpring(wire), WiredForce(moon, wire))
            FailingCase.GAS -> emptyList()
        }
        val timeStep = if (case == FailingCase.MOON) CellCrossingTimeStep(0.5, 2.0, 1.0) else FixedTimeStep(0.6)
        val collisions = engine?.let {
            CollisionForcing(
                WiredRestitution(ConstantRestitution(0.8), wire),
                WiredGuard(ContactDurationGuard(0.05), wire),
                it,
                recordCollisions = true,
            )
        }
        val outputs = List(2) { WiredOutput(wire) }
        val wiredStep = WiredTimeStep(timeStep, wire)
        val simulation = Simulation(population(), boundary, collisions, wiredStep, forces, outputs)
        return Made(simulation, wire, outputs, surface)
    }

    private fun population(): Population {
        val random = SeededRandom(seed)
        val radii = DoubleArray(COUNT) { random.nextDouble(0.4, 0.6) }
        val box = Box.centred(EDGE, EDGE, EDGE)
        val p = RandomPlacement().place(radii, box, BooleanArray(3), random)
        fun gauss() = DoubleArray(COUNT) { random.nextGaussian() }
        val masses = DoubleArray(COUNT) { radii[it] * radii[it] * radii[it] }
        return Population(p.x, p.y, p.z, gauss(), gauss(), gauss(), radii, masses)
    }

    private companion object {
        const val UNDISTURBED = 3
        const val COUNT = 90
        const val EDGE = 8.0
        const val OMEGA = 0.1
        val WITHIN_ENGINE = setOf("restitution", "guard")
    }
}

/** All that a step changes, to the bit, with the order of the arrays. */
private class BitState(simulation: Simulation) {
    private val p = simulation.population
    private val ids = p.id.copyOf()
    private val columns = listOf(p.x, p.y, p.z, p.vx, p.vy, p.vz, p.radius, p.mass, p.lastCollision).map { a ->
        List(p.size) { a[it].toRawBits() }
    }
    private val crossed = ids.map { id -> List(3) { p.boxesCrossed(id, it) } }
    private val digest = stateDigest(p)
    private val clock = listOf(simulation.step, simulation.time.toRawBits())
    private val counts = simulation.collisions?.counters?.run { listOf(collisions, wallCollisions, guardActivations) }
    private val ways = simulation.collisions?.counters?.run { listOf(redoneSteps, causalityReplays) }

    /** Everything but the order of the arrays and how the engine got there. */
    fun byId(): List<Any?> {
        val spheres = ids.indices.sortedBy { ids[it] }.map { k -> columns.map { it[k] } + crossed[k] }
        return listOf(spheres, ids.sorted(), digest, clock, counts)
    }

    fun assertIsStill(simulation: Simulation, story: String) {
        val now = BitState(simulation)
        assertEquals(ids.asList(), now.ids.asList()) { "order, $story" }
        for (c in columns.indices) assertEquals(columns[c], now.columns[c]) { "column $c, $story" }
        assertEquals(crossed, now.crossed) { "boxes crossed, $story" }
        assertEquals(listOf(digest, clock, counts, ways), listOf(now.digest, now.clock, now.counts, now.ways)) { story }
        assertEquals(0, simulation.collisions?.record?.size ?: 0) { "record, $story" }
    }
}
