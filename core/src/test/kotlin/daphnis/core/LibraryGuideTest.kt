package daphnis.core

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.force.Kick
import daphnis.core.force.PerSphereEnergy
import daphnis.core.force.SelfGravity
import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.hill.Satellite
import daphnis.core.population.Conserved
import daphnis.core.population.Population
import daphnis.core.population.granularTemperature
import daphnis.core.population.stateDigest
import daphnis.core.run.Program
import daphnis.core.run.Run
import daphnis.core.run.RunOrigin
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.OutputSpec
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.surface.BridgesRestitution
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.Restitution
import daphnis.core.table.UnitsOfDimensions
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

// The examples of docs/library.md, compiled and run. GuideExamplesTest compares the text.

// example: force
class CentralSpring(private val stiffness: Double) :
    Kick,
    PerSphereEnergy {
    override fun kick(population: Population, time: Double, duration: Double) {
        for (k in 0 until population.size) {
            val f = -stiffness / population.mass[k] * duration
            population.vx[k] += f * population.x[k]
            population.vy[k] += f * population.y[k]
            population.vz[k] += f * population.z[k]
        }
    }

    override fun potentialEnergies(population: Population, time: Double, from: Int, to: Int, into: DoubleArray) {
        val p = population
        for (k in from until to) {
            into[k - from] = stiffness / 2 * (p.x[k] * p.x[k] + p.y[k] * p.y[k] + p.z[k] * p.z[k])
        }
    }
}
// end

// example: boundary
class AbsorbingFloor(private val floor: Double) : BoundaryConditions {
    override val box = Box.UNBOUNDED

    override fun endStep(population: Population, time: Double) {
        population.retain { k -> population.z[k] >= floor }
    }
}
// end

// example: output
class EnergyHistory : Output {
    val energies = ArrayList<Double>()

    override fun write(simulation: Simulation) {
        energies += simulation.conserved().kineticEnergy
    }

    override fun save(state: OutputState) {
        state.put("energies", energies.toDoubleArray())
    }

    override fun restore(state: OutputState) {
        energies += state.doubles("energies").asList()
    }
}
// end

// example: program
class Chain : Program {
    override val name = "chain"
    override val version = "1"
    override val until = 2.0
    override val output = OutputSpec(seriesEvery = 1, snapshotEvery = 10, checkpointEvery = 5)
    val history = EnergyHistory()

    override fun population() = Population(
        x = doubleArrayOf(-1.0, 1.0),
        y = DoubleArray(2),
        z = DoubleArray(2),
        vx = DoubleArray(2),
        vy = doubleArrayOf(0.3, -0.3),
        vz = DoubleArray(2),
        radius = doubleArrayOf(0.01, 0.01),
        mass = doubleArrayOf(1.0, 1.0),
    )

    override fun simulation(population: Population): Simulation {
        val collisions = CollisionForcing(ConstantRestitution(1.0))
        return Simulation(population, Open, collisions, FixedTimeStep(0.1), listOf(CentralSpring(1.0)))
    }

    override fun outputs() = mapOf("history" to history)
}
// end

class LibraryGuideTest {
    @Test
    fun `a simulation from a few lines`() {
        // example: simulation
        val n = 3
        val population = Population(
            x = doubleArrayOf(-3.0, 0.0, 3.0),
            y = DoubleArray(n),
            z = DoubleArray(n),
            vx = doubleArrayOf(1.0, 0.0, -0.5),
            vy = DoubleArray(n),
            vz = DoubleArray(n),
            radius = DoubleArray(n) { 0.5 },
            mass = DoubleArray(n) { 1.0 },
        )
        val boundary = Periodic(Box.centred(10.0, 10.0, 10.0))
        val history = EnergyHistory()
        Simulation(
            population,
            boundary,
            CollisionForcing(ConstantRestitution(0.8)),
            FixedTimeStep(0.1),
            outputs = listOf(history),
        ).use {
            while (it.time < 5.0) it.advance()
        }
        println("energy ${history.energies.first()} -> ${history.energies.last()}, digest ${stateDigest(population)}")
        // end
        assertTrue(history.energies.last() < history.energies.first())
        assertEquals(51, history.energies.size)
    }

    @Test
    fun `the same from a builder`() {
        val p = populationOf(Sphere(x = -2.0, vx = 1.0), Sphere(x = 2.0, vx = -1.0))
        val q = p.copy()
        // example: builder
        val simulation = Simulation.builder(p)
            .boundary(Open)
            .restitution { speed -> 1 / (1 + speed) }
            .timeStep(0.1)
            .output { if (it.step % 10 == 0L) println(it.time) }
            .build()
        // end
        while (simulation.time < 2.0) simulation.advance()
        val other = Simulation(q, Open, CollisionForcing(Restitution { v -> 1 / (1 + v) }), FixedTimeStep(0.1))
        while (other.time < 2.0) other.advance()
        assertEquals(stateDigest(q), stateDigest(p))
        assertEquals(1, simulation.collisions!!.counters.collisions)
    }

    @Test
    fun `a scenario as a library call`() {
        // example: scenario
        val setup = ScenarioSetup.of(
            BuiltIn.scenario("cooling-gas", settings = listOf("particles.count=200")),
            "cooling-gas",
        )
        val collisions = setup.collisions()
        val simulation = Simulation(setup.population, setup.boundary, collisions, setup.timeStep, setup.forces)
        simulation.use { while (it.time < 2.0) it.advance() }
        println("${collisions.counters.collisions} collisions")
        // end
        assertTrue(collisions.counters.collisions > 10)
    }

    @Test
    fun `a spring holds spheres together and conserves energy to second order`() {
        val energies = listOf(0.02, 0.01).map { dt ->
            val p = populationOf(Sphere(x = 1.0, vy = 0.3, r = 0.01), Sphere(x = -1.0, vy = -0.3, r = 0.01))
            fun total() =
                Conserved.of(p).kineticEnergy + (0 until 2).sumOf { p.x[it] * p.x[it] + p.y[it] * p.y[it] } / 2
            val before = total()
            val simulation =
                Simulation(
                    p,
                    daphnis.core.boundary.Open,
                    CollisionForcing(ConstantRestitution(1.0)),
                    FixedTimeStep(dt),
                    listOf(CentralSpring(1.0)),
                )
            while (simulation.time < 1.3) simulation.advance()
            Math.abs(total() - before)
        }
        assertTrue(energies[0] < 1e-4 && energies[0] / energies[1] in 3.0..5.0) { "$energies" }
    }

    @Test
    fun `a floor takes spheres away`() {
        val p = populationOf(Sphere(z = 5.0, vz = -1.0), Sphere(z = 9.0, vx = 1.0), Sphere(z = 0.5, x = 9.0, vz = -1.0))
        val simulation = Simulation(p, AbsorbingFloor(0.0), CollisionForcing(BridgesRestitution()), FixedTimeStep(1.0))
        repeat(3) { simulation.advance() }
        assertEquals(2, p.size)
        assertEquals(-1, p.indexOf(2))
        assertTrue(p.indexOf(0) >= 0 && p.indexOf(1) >= 0)
        repeat(20) { simulation.advance() }
        assertEquals(1, p.size)
    }

    @Test
    fun `a program stopped and resumed ends as one in one go`(@TempDir home: Path) {
        val directory = home.resolve("chain")
        // example: resume
        Run.start(Chain(), directory).use { run ->
            run.execute(cancelled = { run.simulation.step >= 7 })
        }
        val summary = Run.resume(Chain(), directory).use { it.execute() }
        // end
        val whole = Chain()
        val inOneGo = Run.start(whole, home.resolve("whole")).use { it.execute() }
        assertEquals(inOneGo.stateDigest, summary.stateDigest)
        assertEquals(21, whole.history.energies.size)
        val rows = Files.readAllLines(directory.resolve("series.csv")).map { it.split(',') }
        val totals = rows.drop(1).map { it[rows[0].map(UnitsOfDimensions::nameIn).indexOf("total_energy")].toDouble() }
        assertEquals(21, totals.size)
        for (total in totals) assertEquals(2 * (0.5 + 0.09 / 2), total, 0.005)
    }

    @Test
    fun `a run is read state by state, and another starts from one of them`(@TempDir home: Path) {
        val directory = home.resolve("gas")
        val settings = listOf("particles.count=200", "timeStep.dt=0.05", "until=1", "output.snapshotEvery=5")
        Run.start(BuiltIn.scenario("cooling-gas", settings), "cooling-gas", directory).use { it.execute() }
        // example: recorded
        val recorded = Run.open(directory)
        for (state in recorded.states()) println("${state.time}: ${state.size} spheres")
        val early = recorded.states().asSequence().map { granularTemperature(it.population(), null) }.take(2).toList()
        val start = recorded.at(0.5) // or atStep(10), last()
        val longer = recorded.scenario()!!.copy(until = 2.0)
        val origin = RunOrigin(recorded, start)
        val summary = Run.start(longer, "longer", home.resolve("longer"), from = origin).use { it.execute() }
        // end
        assertTrue(early.size == 2 && early[1] < early[0]) { "$early" }
        assertEquals(listOf(30L to 2.0, 10L), listOf(summary.steps to summary.time, start.step))
    }

    @Test
    fun `the snippet of the first page`() {
        // example: readme
        val scenario = BuiltIn.scenario("cooling-gas", settings = listOf("particles.count=200"))
        val setup = ScenarioSetup.of(scenario, "cooling-gas")
        val collisions = CollisionForcing(setup.restitution, setup.guard)
        val simulation = Simulation(setup.population, setup.boundary, collisions, setup.timeStep, setup.forces)
        simulation.use { while (it.time < 2.0) it.advance() }
        println("${collisions.counters.collisions} collisions, digest ${stateDigest(setup.population)}")
        // end
        assertTrue(collisions.counters.collisions > 0)
    }

    @Test
    fun `a ring with a moon and gravity`() {
        val population = randomSpheres(60, HillSheet(Box.centred(100.0, 100.0, 20.0), 1.0), 3, 1.0) { 1.0 }
        for (k in 0 until population.size) population.vy[k] -= 1.5 * population.x[k]

        // example: ring
        val omega = 1.0 // units: Ω and the radius of a particle
        val sheet = HillSheet(Box.centred(100.0, 100.0, 20.0), omega)
        val frame = HillFrame(omega) // always acts next to the drift, whatever its place in the list
        val moon = Satellite(3.0, Epicycle(guidingX = -40.0, guidingY = 0.0, e = 0.0, phase = 0.0), omega)
        val gravity = SelfGravity(sheet, constant = 0.01, openingAngle = 0.5)
        val simulation =
            Simulation(
                population,
                sheet,
                CollisionForcing(BridgesRestitution(cmPerSecond = 0.02)),
                FixedTimeStep(0.03),
                listOf(moon, gravity, frame),
            )
        // end

        repeat(50) { simulation.advance() }
        assertInvariants(simulation)
        val e = Epicycle.of(
            population.x[0],
            population.y[0],
            population.z[0],
            population.vx[0],
            population.vy[0],
            population.vz[0],
            omega,
        )
        assertEquals(population.vx[0], e.state(omega)[3], 1e-12)
    }
}
