package daphnis.analysis.correlation

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.theory.HardDiscs
import daphnis.analysis.theory.HardSphereMixture
import daphnis.analysis.theory.HardSpheres
import daphnis.core.Output
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.population.Population
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cbrt
import kotlin.math.ln
import kotlin.math.pow
import kotlin.math.sqrt

class InsertionTest {
    @TempDir
    lateinit var directory: Path
    private val isFull = System.getProperty("daphnis.physics") == "full"

    private fun state(radius: Double, vararg places: DoubleArray, time: Double = 0.0): State {
        val n = places.size
        val at = Array(3) { axis -> DoubleArray(n) { places[it][axis] } }
        val p = Population(
            at[0],
            at[1],
            at[2],
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n) { radius },
            DoubleArray(n) { 1.0 },
        )
        return State(p, Periodic(Box.centred(3.0, 4.0, 5.0)), time)
    }

    @Test
    fun `around one sphere, wherever it is, the room is that of a ball, and of a point what spheres leave free`() {
        // In the middle, across a face, and in a corner, far from the origin.
        val places =
            listOf(doubleArrayOf(0.1, 0.2, 0.3), doubleArrayOf(1.45, 0.0, 0.0), doubleArrayOf(-1.5, -2.0, -2.5))
        for ((k, place) in places.withIndex()) {
            val insertion = Insertion(1.0, 4, 200_000)
            val found = insertion.of(state(0.5, place, time = k + 1.0))
            assertEquals(-ln(1 - PI / 6 / 60), found[0], 1e-14)
            for (bin in 1..4) {
                val p = 1 - 4 * PI / 3 * (0.5 + insertion.diameter(bin) / 2).pow(3) / 60
                assertEquals(-ln(p), found[bin], 4 * sqrt((1 - p) / p / 200_000)) { "$k, ${insertion.diameter(bin)}" }
            }
        }
    }

    @Test
    fun `of two sizes each has its own radius, and equal states have equal numbers`() {
        val p = Population(
            doubleArrayOf(0.0, 1.2),
            doubleArrayOf(0.0, 0.0),
            doubleArrayOf(0.0, 1.0),
            DoubleArray(2),
            DoubleArray(2),
            DoubleArray(2),
            doubleArrayOf(0.5, 0.2),
            doubleArrayOf(1.0, 1.0),
        )
        val state = State(p, Periodic(Box.centred(4.0, 4.0, 4.0)), 1.0)
        val insertion = Insertion(0.4, 2, 100_000)
        val found = insertion.of(state)
        val taken = 4 * PI / 3 * (0.7.pow(3) + 0.4.pow(3)) / 64
        assertEquals(-ln(1 - taken), found[2], 4 * sqrt(taken / 100_000))
        assertTrue(found.contentEquals(insertion.of(state)))
        assertTrue(!found.contentEquals(insertion.of(State(p, state.boundary, 2.0))))
    }

    @Test
    fun `where nothing fits there is no number, and boxes with faces or shear are refused`() {
        val crowd = Array(60) { doubleArrayOf(it % 3 - 1.0, it / 3 % 4 - 1.5, it / 12 - 2.0) }
        val found = Insertion(1.0, 2, 1000).of(state(0.5, *crowd))
        assertEquals(-ln(1 - PI / 6), found[0], 1e-12)
        assertTrue(found[2].isNaN())
        val p = state(0.5, doubleArrayOf(0.0, 0.0, 0.0)).population
        val box = Box.centred(3.0, 4.0, 5.0)
        for (wrong in listOf(Periodic(box, true, true, false), LeesEdwards(box, 1.0))) {
            assertThrows(IllegalArgumentException::class.java) { Insertion(1.0).of(State(p, wrong, 0.0)) }
        }
        for (make in listOf({ Insertion(0.0) }, { Insertion(1.0, 0) }, { Insertion(1.0, 2, 0) })) {
            assertThrows(IllegalArgumentException::class.java) { make() }
        }
    }

    /** −ln p by diameter, from 100 states of a fluid 0.4 apart. */
    private fun fluid(filling: Double, radii: List<Double>, seed: Int, discs: Boolean = false): Averages {
        val volume = 250 * radii.sumOf { if (discs) PI * it * it else 4 * PI / 3 * it.pow(3) } / radii.size / filling
        val edge = if (discs) sqrt(volume) else cbrt(volume)
        val averages = Averages(Insertion(2 * radii.max()), from = 4.0, every = 4)
        val settings = listOfNotNull(
            "dimensions=2".takeIf { discs },
            if (discs) "box.lengths=[$edge,$edge]" else "box.lengths=[$edge,$edge,$edge]",
            "particles={\"count\":250,\"sizes\":{\"type\":\"list\",\"radii\":$radii},\"mass\":1}",
            "velocities={\"type\":\"gaussian\",\"temperature\":1,\"exact\":true}",
            "timeStep={\"type\":\"fixed\",\"dt\":0.1}",
            "output={}",
            "until=44",
            "seed=$seed",
        )
        val path = directory.resolve("$filling-$seed-$discs-${radii.size}")
        Run.start(BuiltIn.scenario("elastic-gas", settings), "elastic-gas", path).use { run ->
            run.execute(Output { averages.write(it) })
        }
        return averages
    }

    @Test
    fun `the fluid has the chemical potential of Carnahan and Starling, and errors hold`() {
        val seeds = if (isFull) 60 else 1
        for (filling in if (isFull) listOf(0.1, 0.2, 0.3) else listOf(0.2)) {
            val known = HardSpheres.carnahanStarlingChemicalPotential(filling)
            val all = List(seeds) { fluid(filling, listOf(0.5), it + 1).average(20) }
            val mean = all.map { it.mean }.average()
            val covered = all.count { abs(it.mean - mean) <= it.error }
            if (isFull) {
                println(
                    "φ $filling: $known, $mean, error ${all.map {
                        it.error
                    }.average()}, covered $covered of $seeds",
                )
            }
            // Of 250 spheres, and the formula itself.
            for (a in all) assertEquals(known, a.mean, 4 * a.error + 0.015 * known) { "$filling" }
            if (isFull) assertTrue(covered in 33..51) { "$covered" }
        }
    }

    @Tag("thorough")
    @Test
    fun `a mixture has that of its equation of state at every diameter, and discs have that of Henderson`() {
        val radii = listOf(0.5, 0.3)
        val found = fluid(0.25, radii, 1)
        val volume = 250 * radii.sumOf { 4 * PI / 3 * it.pow(3) } / 2 / 0.25
        val mixture = HardSphereMixture(doubleArrayOf(1.0, 0.6), DoubleArray(2) { 125 / volume })
        for (k in 0..20) {
            val known = mixture.excessChemicalPotential(k * 0.05)
            assertEquals(known, found.average(k).mean, 4 * found.average(k).error + 0.015 * known) { "$k" }
        }
        val discs = fluid(0.4, listOf(0.5), 1, discs = true).average(20)
        val henderson = HardDiscs.hendersonChemicalPotential(0.4)
        assertEquals(henderson, discs.mean, 4 * discs.error + 0.015 * henderson)
    }
}
