package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class JudgementTest {
    private val time = DoubleArray(400) { it * 1.0 }

    /** Noise, and a drift by so many of the errors that a line through it has. */
    private fun history(name: String, errors: Double, key: String): History {
        val random = SeededRandom(4)
        val noise = DoubleArray(400) { 10 + random.nextGaussian() }
        val still = History(name, time, noise).steadiness(0.0)
        val drift = errors * still.error - still.change
        return History(name, time, DoubleArray(400) { noise[it] + drift * it / 399 }, setOf(key))
    }

    private val rows = listOf("scale_height", "viscosity_total", "self_diffusion").map {
        NumberRow(it, 1.0, 0.1, "", key = it)
    }

    private fun judged(height: Double, states: Int = 16) = Judgement(0.0, states) {
        listOf(
            history("scale height", height, "scale_height"),
            history("viscosity", 0.0, "viscosity_total"),
            history("a", 0.0, "a"),
            history("b", 0.0, "b"),
        )
    }

    private fun marked(judgement: Judgement) =
        judgement.shown(rows).filter { it.unknown == Unknown.UNSTEADY }.map { it.key }

    @Test
    fun `a steady run keeps all errors, a small drift takes those that go with it, and a large one all`() {
        assertEquals(emptyList<String>(), marked(judged(2.9)))
        assertEquals(listOf("scale_height"), marked(judged(3.2)))
        assertFalse(judged(3.2).isDrifting)
        // Of four quantities, one beyond 4.5 errors.
        assertEquals(listOf("scale_height"), marked(judged(4.4)))
        assertEquals(rows.map { it.key }, marked(judged(4.6)))
        assertTrue(judged(4.6).isDrifting && "no bars" in judged(4.6).bars())
    }

    @Test
    fun `what is part of a number that drifts has no error`() {
        val average = BlockAverage(1.0, 0.1, 100, 40.0)
        fun errors(height: Double) = listOf("scale_height", "viscosity_total", null).map {
            judged(height).error(average, it)
        }
        assertEquals(listOf(0.1, 0.1, 0.1), errors(2.9))
        assertEquals(listOf(Double.NaN, 0.1, 0.1), errors(3.2))
        assertEquals(listOf(Double.NaN, Double.NaN, Double.NaN), errors(4.6))
    }

    @Test
    fun `where the temperature of a box is too slow for an error, what follows it has none either`() {
        fun shown(temperature: Double) = Judgement(0.0, 16) { emptyList() }.shown(
            NumberRows().also { all ->
                val keys = listOf("viscosity_total", "reduced_shear_stress", "collisions_per_particle")
                all.average("granular_temperature", "T", BlockAverage(1.0, temperature, 100, 4.0), "")
                for (key in keys + "partial_temperature_light" + "compressibility") {
                    all.average(key, key, BlockAverage(1.0, 0.1, 100, 40.0), "")
                }
            }.list(),
        ).filter { it.unknown == Unknown.TOO_FEW }.map { it.key }
        assertEquals(emptyList<String>(), shown(0.1))
        assertEquals(
            listOf("granular_temperature", "viscosity_total", "reduced_shear_stress", "collisions_per_particle") +
                "partial_temperature_light",
            shown(Double.NaN),
        )
    }

    @Test
    fun `bars that cannot be there are not promised`() {
        assertEquals("There are no bars: 2 states are too few.", judged(2.9, 2).bars())
        assertEquals("There are no bars: 1 state is too few.", judged(2.9, 1).bars())
        assertTrue("too few" in judged(2.9, 15).bars())
        assertTrue(
            judged(2.9, 16).bars().startsWith("Bars are one standard error; a point has none where fewer than 16"),
        )
        assertTrue("not steady" in judged(4.6, 2).bars())
    }

    @Test
    fun `a drift that takes only its own error says so, and one without words is none`() {
        val text = SteadinessText(0.0, "orbit", 1.0)
        assertTrue("what goes with it has no ±" in text.of(judged(3.2).histories).first())
        assertTrue("so no ± is given" in text.of(judged(4.6).histories).first())
        assertTrue(judged(3.2).isUnjudged.not())
    }
}
