package daphnis.core

import daphnis.core.boundary.Open
import daphnis.core.engine.CollisionForcing
import daphnis.core.force.Kick
import daphnis.core.force.PerSphereEnergy
import daphnis.core.physics.fullPhysics
import daphnis.core.population.Population
import daphnis.core.run.Program
import daphnis.core.run.Run
import daphnis.core.scenario.OutputSpec
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.util.Random
import kotlin.io.path.readLines
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.sin

// The pipeline of docs/examples/kotlin.md, compiled and run. GuideExamplesTest compares the text.

// example: trap
/** The force −x on each sphere of mass 1: without collisions all of them swing with the period 2π. */
object Trap : Kick, PerSphereEnergy {
    override fun kick(population: Population, time: Double, duration: Double) {
        val p = population
        for (k in 0 until p.size) {
            p.vx[k] -= duration * p.x[k]
            p.vy[k] -= duration * p.y[k]
            p.vz[k] -= duration * p.z[k]
        }
    }

    override fun potentialEnergies(population: Population, time: Double, from: Int, to: Int, into: DoubleArray) {
        val p = population
        for (k in from until to) into[k - from] = (p.x[k] * p.x[k] + p.y[k] * p.y[k] + p.z[k] * p.z[k]) / 2
    }
}
// end

// example: widths

/** Time, mean of r² and mean of 2z² − x² − y² after each step, in [file] at the end. */
class Widths(private val file: Path) : Output {
    val rows = ArrayList<Double>()

    override fun write(simulation: Simulation) {
        val p = simulation.population
        val order = (0 until p.size).map { p.indexOf(it) } // in the order of ids: the same bits with every engine
        val along = order.sumOf { p.z[it] * p.z[it] } / p.size
        val across = order.sumOf { p.x[it] * p.x[it] + p.y[it] * p.y[it] } / p.size
        rows += listOf(simulation.time, across + along, 2 * along - across)
    }

    override fun save(state: OutputState) {
        state.put("rows", rows.toDoubleArray())
    }

    override fun restore(state: OutputState) {
        rows += state.doubles("rows").asList()
    }

    override fun finish(simulation: Simulation) {
        Files.write(file, listOf("time,breathing,shape") + rows.chunked(3).map { it.joinToString(",") })
    }
}
// end

// example: trappedGas

/** A gas of temperature 1 in the trap, stretched by half along z, which swings from then on. */
class TrappedGas(private val spheres: Int, private val diameter: Double, override val until: Double, file: Path) :
    Program {
    val widths = Widths(file)
    override val name = "trapped-gas"
    override val version = "1"
    override val output = OutputSpec(seriesEvery = 50, checkpointEvery = 500)

    override fun population(): Population {
        val random = Random(1)
        val places = ArrayList<List<Double>>()
        while (places.size < spheres) {
            val at = doubleArrayOf(1.0, 1.0, 1.5).map { it * random.nextGaussian() }
            if (places.none { near(it, at) }) places += at
        }
        fun column(axis: Int) = DoubleArray(spheres) { places[it][axis] }
        fun speeds() = DoubleArray(spheres) { random.nextGaussian() }
        val radius = DoubleArray(spheres) { diameter / 2 }
        val mass = DoubleArray(spheres) { 1.0 }
        return Population(column(0), column(1), column(2), speeds(), speeds(), speeds(), radius, mass)
    }

    private fun near(one: List<Double>, other: List<Double>) =
        (0..2).sumOf { (one[it] - other[it]) * (one[it] - other[it]) } < diameter * diameter

    override fun simulation(population: Population): Simulation {
        val collisions = CollisionForcing(ConstantRestitution(1.0))
        return Simulation(population, Open, collisions, FixedTimeStep(0.02), listOf(Trap))
    }

    override fun outputs() = mapOf("widths" to widths)
}
// end

// example: swing

/**
 * Amplitude of exp(2it) in column [column] of [rows], which is that of a swing with the period π, in a window of four
 * of these from [from] on: twice the mean of (value − mean) exp(2it).
 */
fun amplitude(rows: List<Double>, column: Int, from: Double): Double {
    val window = rows.chunked(3).filter { it[0] >= from && it[0] < from + 4 * PI }
    val mean = window.sumOf { it[column] } / window.size
    val cosine = window.sumOf { (it[column] - mean) * cos(2 * it[0]) } * 2 / window.size
    val sine = window.sumOf { (it[column] - mean) * sin(2 * it[0]) } * 2 / window.size
    return hypot(cosine, sine)
}
// end

class TrapExampleTest {
    @TempDir
    lateinit var home: Path

    private val spheres = if (fullPhysics) 2000 else 300
    private val diameter = if (fullPhysics) 0.05 else 0.1
    private val until = if (fullPhysics) 60.0 else 30.0

    @Test
    fun `a gas in a trap breathes for ever and loses its shape, also where the run is stopped`() {
        val directory = home.resolve("trap")
        val csv = home.resolve("widths.csv")
        // example: trapRun
        Run.start(TrappedGas(spheres, diameter, until, csv), directory).use { run ->
            run.execute(cancelled = { run.simulation.time > until / 2 }) // as by a deadline; a checkpoint is written
        }
        val gas = TrappedGas(spheres, diameter, until, csv)
        val summary = Run.resume(gas, directory).use { it.execute() }
        val rows = gas.widths.rows
        val ends = listOf(0.0, until - 4 * PI)
        val breathing = ends.map { amplitude(rows, 1, it) / rows[1] }
        val shape = ends.map { amplitude(rows, 2, it) / rows[2] }
        println("${2.0 * summary.collisions / spheres} collisions of each sphere")
        println("r²: $breathing of the start; shape: $shape")
        // end
        val whole = TrappedGas(spheres, diameter, until, home.resolve("whole.csv"))
        val digest = Run.start(whole, home.resolve("whole")).use { it.execute() }.stateDigest
        assertEquals(digest, summary.stateDigest) { "a run that was stopped ends with the same bits" }
        assertEquals(whole.widths.rows, gas.widths.rows)
        assertEquals(whole.widths.rows.size / 3 + 1, csv.readLines().size)
        assertTrue(breathing[1] > 0.8 * breathing[0]) { "breathing $breathing" }
        assertTrue(shape[1] < 0.7 * shape[0]) { "shape $shape" }
    }
}
