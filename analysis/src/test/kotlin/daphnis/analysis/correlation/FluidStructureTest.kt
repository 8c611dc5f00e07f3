package daphnis.analysis.correlation

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.SizeGroups
import daphnis.analysis.insitu.SphereGroups
import daphnis.analysis.theory.HardDiscs
import daphnis.analysis.theory.HardSphereMixture
import daphnis.analysis.theory.HardSpheres
import daphnis.analysis.theory.PercusYevick
import daphnis.analysis.uniform
import daphnis.core.Output
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cbrt
import kotlin.math.pow

/** S(k), S(0⁺) and contact values of fluids that were run, beside theory; `-Ddaphnis.physics=full` for many seeds. */
class FluidStructureTest {
    @TempDir
    lateinit var directory: Path
    private val isFull = System.getProperty("daphnis.physics") == "full"
    private var runs = 0

    /** Averages of [measures] over [states] states of an elastic gas with [settings], 0.4 apart. */
    private fun averages(measures: List<Measure>, states: Int, settings: List<String>): List<Averages> {
        val averages = measures.map { Averages(it, from = 4.0, every = 4) }
        val all = settings + listOf(
            "velocities={\"type\":\"gaussian\",\"temperature\":1,\"exact\":true}",
            "timeStep={\"type\":\"fixed\",\"dt\":0.1}",
            "output={}",
            "until=${4 + 0.4 * states}",
        )
        Run.start(BuiltIn.scenario("elastic-gas", all), "elastic-gas", directory.resolve("${runs++}")).use { run ->
            run.execute(Output { simulation -> for (a in averages) a.write(simulation) })
        }
        return averages
    }

    private fun spheres(count: Int, filling: Double, radii: List<Double> = listOf(0.5), seed: Int = 1): List<String> {
        val edge = cbrt(count * radii.sumOf { 4 * PI / 3 * it.pow(3) } / radii.size / filling)
        return listOf(
            "particles={\"count\":$count,\"sizes\":{\"type\":\"list\",\"radii\":$radii},\"mass\":1}",
            "box.lengths=[$edge,$edge,$edge]",
            "seed=$seed",
        )
    }

    @Test
    fun `S(k) is that of Percus, Yevick, Verlet and Weis, S(0) that of Carnahan and Starling, and errors hold`() {
        val filling = 0.3
        val known = HardSpheres.carnahanStarlingLongWaveLimit(filling)
        val contact = HardSpheres.carnahanStarlingContact(filling)
        val factor = SpatialStructureFactor(10.0, 20)
        val seeds = if (isFull) 60 else 1
        val (zeros, touching) = List(2) { ArrayList<Pair<Double, Double>>() }
        repeat(seeds) { seed ->
            val (s, zero, touch) = averages(
                listOf(factor, LongWaveLimit(2.5), ContactValues()),
                if (isFull) 150 else 50,
                spheres(256, filling, seed = seed + 1),
            )
            zeros += zero.average(0).let { it.mean to it.error }
            touching += touch.average(0).let { it.mean to it.error }
            if (seed > 0) return@repeat
            val edge = cbrt(256 * PI / 6 / filling)
            val waveNumbers = factor.waveNumbers(uniform(256, Periodic(Box.centred(edge, edge, edge))))
            for (bin in 4 until 20) {
                val found = s.average(bin)
                val theory = PercusYevick.structureFactor(waveNumbers[bin], filling)
                assertEquals(theory, found.mean, 4 * found.error + 0.03 * theory) { "kσ = ${waveNumbers[bin]}" }
            }
        }
        for ((value, all) in listOf(known to zeros, contact to touching)) {
            val mean = all.map { it.first }.average()
            val covered = all.count { abs(it.first - mean) <= it.second }
            if (isFull) {
                println(
                    "theory $value, mean $mean, error ${all.map {
                        it.second
                    }.average()}, covered $covered of $seeds",
                )
            }
            assertTrue(all.all { abs(it.first - value) < 4 * it.second }) { "$value: $all" }
        }
    }

    @Tag("thorough")
    @Test
    fun `contact values of a mixture are those of Boublik and Mansoori, of discs those of Jenkins and Mancini`() {
        val radii = listOf(0.5, 0.3)
        val groups = SizeGroups(doubleArrayOf(0.2, 0.4, 0.6))
        val settings = spheres(400, 0.3, radii)
        val contact = ContactValues(groups)
        val found = averages(listOf(contact), 60, settings)[0]
        val volume = 400 * radii.sumOf { 4 * PI / 3 * it.pow(3) } / 2 / 0.3
        val diameters = doubleArrayOf(0.6, 1.0)
        check(found, contact, HardSphereMixture(diameters, DoubleArray(2) { 200 / volume })::contactValue)
        val area = 400 * radii.sumOf { PI * it * it } / 2 / 0.4
        val edge = Math.sqrt(area)
        val discs = settings.drop(2) + listOf("dimensions=2", "box.lengths=[$edge,$edge]", settings[0])
        check(averages(listOf(contact), 60, discs)[0], contact) { a, b ->
            HardDiscs.contactValue(a, b, diameters, DoubleArray(2) { 200 / area })
        }
    }

    private fun check(found: Averages, contact: ContactValues, theory: (Int, Int) -> Double) {
        for (a in 0..1) {
            for (b in a..1) {
                val average = found.average(contact.at(b, a))
                val known = theory(a, b)
                assertEquals(known, average.mean, 4 * average.error + 0.02 * known) { "$a $b ± ${average.error}" }
                assertTrue(average.error < 0.1 * known)
            }
        }
    }

    @Test
    fun `random points have contact values of 1`() {
        val box = Periodic(Box.centred(4.0, 4.0, 4.0))
        val averages = Averages(ContactValues(SphereGroups.ALL, 1.0))
        for (seed in 1L..200) averages.add(uniform(100, box, seed, 0.4))
        val found = averages.average(0)
        assertEquals(1.0, found.mean, 4 * found.error)
        assertTrue(found.error < 0.05)
    }
}
