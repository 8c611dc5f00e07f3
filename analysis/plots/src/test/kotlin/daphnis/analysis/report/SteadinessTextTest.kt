package daphnis.analysis.report

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SteadinessTextTest {
    private val time = DoubleArray(400) { it * 0.5 }
    private val random = SeededRandom(6)
    private fun history(name: String, signal: (Int) -> Double) = History(
        name,
        time,
        DoubleArray(400) {
            signal(it) +
                0.01 * random.nextGaussian()
        },
    )

    @Test
    fun `a drift is named with its size, its rate, and the time from which the run is steady`() {
        val falls = history("scale height") { k -> if (k < 200) 2 - k / 200.0 else 1.0 }
        val lines = SteadinessText(20.0, "orbit", 10.0).of(
            listOf(
                falls,
                History(
                    "dispersion",
                    time,
                    DoubleArray(400) {
                        3.0
                    },
                ),
            ),
        )
        assertEquals(2, lines.size)
        assertTrue(
            lines[0].startsWith("Not steady: scale height fell by ") &&
                "per orbit" in lines[0] &&
                "MSER-5" in lines[0] &&
                "no ± is given" in lines[0],
        ) {
            lines[0]
        }
        val found = Regex("from time (\\d+) \\(([\\d.]+) orbits\\) on").find(lines[0])!!
        val (from, orbits) = found.destructured
        assertTrue(from.toInt() in 90..100) { lines[0] }
        assertEquals(from.toDouble() / 10, orbits.toDouble(), 0.01)
        assertEquals("No drift is seen in the other quantity.", lines[1])
    }

    @Test
    fun `from where it is steady it is not called drifting, and what goes on rising wants a longer run`() {
        val falls = history("scale height") { k -> if (k < 200) 2 - k / 200.0 else 1.0 }
        val rises = history("temperature") { k -> 1 + k / 400.0 }
        val lines = SteadinessText(100.0, "unit of time", 1.0).of(listOf(falls, rises))
        // From 1.5 to 2 in 100 units of time: 29 % of the mean.
        assertTrue(
            Regex(
                "Not steady: temperature rose by 2[789] % .* \\(0\\.2[789] % per unit of time\\).*a longer run.*",
            ).matches(lines[0]),
        ) {
            lines[0]
        }
        // Noise of 1 % in 200 rows has a mean within 0.07 %, and a trend within 0.24 %.
        val missed = Regex("$OTHER: scale height (.*) %\\.").matchEntire(lines[1])!!.groupValues[1].toDouble()
        assertTrue(missed in 0.2..1.0) { lines[1] }
    }

    @Test
    fun `what changes by more than its average is told in averages, not in percent`() {
        // From 1 to 0 in a line, of which the average is a half.
        val falls = history("temperature") { k -> 1 - k / 400.0 }
        val line = SteadinessText(1.0, "unit of time", 1.0).of(listOf(falls)).single()
        assertTrue(Regex("Not steady: temperature fell by (2|1\\.9\\d) times its average .*").matches(line)) { line }
    }

    @Test
    fun `where a wave grows that is said, not a later time`() {
        val falls = history("scale height") { k -> if (k < 200) 2 - k / 200.0 else 1.0 }
        val said = SteadinessText(20.0, "orbit", 10.0, growing = "a wave grows").of(listOf(falls)).single()
        assertTrue(said.endsWith("; a wave grows.")) { said }
    }

    @Test
    fun `a gas that cools for ever is not told to run longer, nor to look later`() {
        val falls = history("temperature") { k -> if (k < 200) 2 - k / 200.0 else 1.0 }
        for (one in listOf(falls, history("temperature") { k -> 2 - k / 400.0 })) {
            val said = SteadinessText(20.0, "unit of time", 1.0, isCooling = true).of(listOf(one)).single()
            val longer = "nothing replaces the energy that collisions take, so a longer run is not steady either; "
            assertTrue(longer in said && "--set 'forces=[{\"type\":\"rescaling\"" in said) { said }
            assertTrue("ratios of temperatures may be steady meanwhile, but have no ± either" in said) { said }
        }
    }

    @Test
    fun `where averages begin late it says when, in orbits too`() {
        val said = SteadinessText(25.0, "orbit", 10.0).found()
        assertEquals("The run became steady at time 25 (2.50 orbits), by MSER-5; averages begin there.", said)
        assertTrue("time 25, by" in SteadinessText(25.0, "unit of time", 1.0).found())
    }

    @Test
    fun `too few rows, none after the time, and drifts too small for a word`() {
        val lines = SteadinessText(195.0, "orbit", 1.0).of(listOf(history("a") { 1.0 * it }))
        assertTrue(
            lines.single().startsWith(
                "Whether it is steady cannot be told from fewer than 24 rows in the time averaged: a (10 of 400).",
            ),
        ) {
            lines[0]
        }
        assertTrue("cannot be told" in SteadinessText(1e9, "orbit", 1.0).of(listOf(history("a") { 1.0 })).single())
        val tiny = SteadinessText(0.0, "orbit", 1.0).of(
            listOf(
                History(
                    "energy",
                    time,
                    DoubleArray(400) {
                        1 + 1e-6 * it
                    },
                ),
            ),
        )
        assertTrue(Regex("$NONE: energy 0\\.04\\d? %\\.").matches(tiny.single())) { tiny.single() }
        assertTrue(SteadinessText(0.0, "orbit", 1.0).of(emptyList()).isEmpty())
    }

    @Test
    fun `what to do is said once for all that drift alike, and of the others that they do not`() {
        val rises = listOf("a", "b").map { name -> history(name) { k -> 1 + k / 400.0 } }
        val still = listOf("c", "d").map { name -> history(name) { 1.0 } }
        val lines = SteadinessText(0.0, "orbit", 1.0, otherwise = "that is how it is").of(rises + still)
        assertEquals(3, lines.size)
        assertTrue(lines[0].startsWith("Not steady: a rose") && lines[0].endsWith("no ± is given.")) { lines[0] }
        assertTrue(lines[1].startsWith("Not steady: b rose") && lines[1].endsWith("; that is how it is.")) { lines[1] }
        assertTrue(lines[2].startsWith("No drift is seen in the other quantities. ")) { lines[2] }
    }

    @Test
    fun `of what is conserved no drift is missed`() {
        val energy = History("energy", time, DoubleArray(400) { 1 + 1e-15 * (it % 3) })
        val nothing = History("collisions", time, DoubleArray(400))
        val text = SteadinessText(0.0, "orbit", 1.0)
        assertEquals("No drift is seen over the time averaged.", text.of(listOf(energy, nothing)).single())
        val said = text.of(listOf(energy, history("height") { 1.0 })).single()
        assertTrue(said.startsWith("$NONE: height ") && "energy" !in said) { said }
    }

    @Test
    fun `where a drift as large as a quarter of the average may have been missed, whether it is steady is left open`() {
        val noisy = History("viscosity", time, DoubleArray(400) { 1 + 2 * random.nextGaussian() })
        val still = history("height") { 1.0 }
        val text = SteadinessText(0.0, "orbit", 1.0)
        val alone = text.of(listOf(noisy)).single()
        assertEquals(OPEN, alone)
        val both = text.of(listOf(noisy, still))
        assertTrue(both[0].startsWith("No drift is seen in height. A smaller one") && both[1] == alone) { "$both" }
    }

    private companion object {
        const val OPEN = "Whether it is steady cannot be told of viscosity: a drift of a quarter of the average may " +
            "hide in the fluctuations."
        const val NONE = "No drift is seen over the time averaged. " +
            "A smaller one than this part of the average may have been missed, with 95 % confidence"
        val OTHER = NONE.replace("over the time averaged", "in the other quantity")
    }
}
