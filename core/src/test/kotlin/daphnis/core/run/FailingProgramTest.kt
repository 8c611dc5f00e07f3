package daphnis.core.run

import daphnis.core.FixedTimeStep
import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.force.Force
import daphnis.core.force.Kick
import daphnis.core.population.Population
import daphnis.core.randomSpheres
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

/** A force whose strength depends on how often it has acted, which it saves as an output. */
private class Tiring :
    Force,
    Output {
    private var acted = 0L

    override fun beforeDrift(population: Population, start: Double, duration: Double) {
        acted++
        for (k in 0 until population.size) population.vx[k] += 0.1 / acted
    }

    override fun afterDrift(population: Population, end: Double, duration: Double) = Unit

    override fun write(simulation: Simulation) = Unit

    override fun save(state: OutputState) {
        state.put("acted", longArrayOf(acted))
    }

    override fun restore(state: OutputState) {
        acted = state.longs("acted").single()
    }
}

/** A gas under [Tiring]; [late] acts after it in the second half of a step. */
private class TiringGas(private val outputs: Map<String, Output> = emptyMap(), private val late: Kick) : Program {
    override val name = "tiring gas"
    override val version = "1"
    override val until = 2.0
    private val boundary = Periodic(Box.centred(6.0, 6.0, 6.0))
    private val tiring = Tiring()

    override fun population(): Population = randomSpheres(40, boundary, 5, 1.0) { 0.5 }

    override fun simulation(population: Population): Simulation {
        val collisions = CollisionForcing(ConstantRestitution(0.9))
        return Simulation(population, boundary, collisions, FixedTimeStep(0.1), listOf(late, tiring))
    }

    override fun outputs(): Map<String, Output> = mapOf<String, Output>("tiring" to tiring) + outputs
}

/** What a run directory holds of a program whose functions, or whose user, do what they should not. */
class FailingProgramTest {
    @TempDir
    lateinit var home: Path

    private val nothing = Kick { _, _, _ -> }

    /** Fails in the second half of the step that ends at time [at]. */
    private fun failing(at: Double) = Kick { _, time, _ -> check(time < at - 0.01 || time > at + 0.01) { "too late" } }

    private fun digest(path: Path) = Summary.read(path.resolve("summary.json")).stateDigest

    @Test
    fun `a failed step leaves the checkpoint of before, and the run goes on to the same bits`() {
        val whole = home.resolve("whole").also { path ->
            Run.start(TiringGas(late = nothing), path).use { it.execute() }
        }
        val broken = home.resolve("broken")
        Run.start(TiringGas(late = failing(at = 1.2)), broken).use { run ->
            val message = assertThrows(RunException::class.java) { run.execute() }.message.orEmpty()
            assertEquals("step 12: too late", message)
        }
        Run.resume(TiringGas(late = nothing), broken).use { it.execute() }
        assertEquals(digest(whole), digest(broken))
    }

    @Test
    fun `a run that is closed writes nothing, whoever holds the directory since`() {
        val path = home.resolve("closed")
        val closed = Run.start(TiringGas(late = nothing), path).apply { close() }
        Run.resume(TiringGas(late = nothing), path).use { it.execute() }
        val before = bytesIn(path)
        assertThrows(IllegalStateException::class.java) { closed.execute() }
        assertEquals(before, bytesIn(path))
    }

    @Test
    fun `an output cannot carry the simulation on`() {
        val path = home.resolve("carried")
        val watcher = Output { if (it.step == 3L) it.advance() }
        Run.start(TiringGas(late = nothing), path).use { run ->
            val message = assertThrows(RunException::class.java) { run.execute(watcher) }.message.orEmpty()
            assertTrue("under way" in message) { message }
            assertEquals(3L, run.simulation.step)
        }
    }

    @Test
    fun `a name that no checkpoint can hold is refused before anything is made`() {
        for (length in listOf(0, 201, 70_000)) {
            val named = TiringGas(mapOf("n".repeat(length) to Output { }), nothing)
            assertThrows(IllegalArgumentException::class.java) { Run.start(named, home.resolve("named")) }
        }
        val longest = TiringGas(mapOf("n".repeat(200) to Output { }), nothing)
        Run.start(longest, home.resolve("longest")).use { it.execute() }
    }
}
