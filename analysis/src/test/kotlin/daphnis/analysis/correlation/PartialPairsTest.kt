package daphnis.analysis.correlation

import daphnis.analysis.insitu.SizeGroups
import daphnis.analysis.insitu.SphereGroups
import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI

/** Pair correlation by pairs of groups. */
class PartialPairsTest {
    private val boundary = Periodic(Box.centred(6.0, 6.0, 6.0))

    private class Kinds(override val count: Int, private val kind: (Int) -> Int) : SphereGroups {
        override fun of(state: State, index: Int) = kind(state.population.id[index])
    }

    @Test
    fun `neighbours of a salt are of the other kind, those across the diagonal of the same`() {
        fun place(k: Int) = k - 2.5
        val n = 216
        val at = List(3) { axis ->
            IntArray(n) {
                it / (
                    if (axis == 0) {
                        1
                    } else if (axis == 1) {
                        6
                    } else {
                        36
                    }
                    ) % 6
            }
        }
        val x = List(3) { axis -> DoubleArray(n) { place(at[axis][it]) } }
        val zero = DoubleArray(n)
        val radius = DoubleArray(n) { if ((at[0][it] + at[1][it] + at[2][it]) % 2 == 0) 0.2 else 0.3 }
        val p = Population(x[0], x[1], x[2], zero, zero, zero, radius, DoubleArray(n) { 1.0 })
        val pairs = PairCorrelation(1.6, 8, groups = SizeGroups(doubleArrayOf(0.1, 0.25, 0.4)))
        val found = pairs.of(State(p, boundary, 0.0))
        assertEquals(3 * 8, found.size)
        fun g(a: Int, b: Int, bin: Int) = found[pairs.first(a, b) + bin]
        fun shell(bin: Int) = 4.0 / 3 * PI * 0.008 * ((bin + 1) * (bin + 1) * (bin + 1) - bin * bin * bin) / 216
        // At 1: 108 · 6 unlike pairs of 108². At 1.414: 108 · 12/2 like pairs of 108 · 107/2.
        for (kind in 0..1) {
            assertEquals(0.0, g(kind, kind, 5))
            assertEquals(108 * 6 / (108 * 107 / 2 * shell(7)), g(kind, kind, 7), 1e-9)
        }
        assertEquals(108 * 6 / (108.0 * 108 * shell(5)), g(0, 1, 5) + g(0, 1, 4), 1e-9)
        assertEquals(0.0, g(1, 0, 7))
    }

    @Test
    fun `partial ones come to the whole, each with its number of pairs`() {
        val state = uniform(60, boundary, 3)
        val kinds = Kinds(3) { it % 7 % 3 }
        val members = List(3) { kind -> (0 until 60).count { it % 7 % 3 == kind } }
        val pairs = PairCorrelation(3.0, 5, groups = kinds)
        val found = pairs.of(state)
        val whole = PairCorrelation(3.0, 5).of(state)
        for (bin in 0 until 5) {
            var sum = 0.0
            for (a in 0..2) {
                for (b in a..2) {
                    val number = if (a == b) members[a] * (members[a] - 1) / 2 else members[a] * members[b]
                    sum += number * found[pairs.first(b, a) + bin]
                }
            }
            assertEquals(whole[bin], sum / (60 * 59 / 2), 1e-12)
        }
    }

    @Test
    fun `a group of one has no pairs with itself, particles of no group count nowhere`() {
        val pairs = PairCorrelation(
            3.0,
            2,
            groups = Kinds(2) {
                if (it == 0) {
                    0
                } else if (it < 20) {
                    1
                } else {
                    -1
                }
            },
        )
        val found = pairs.of(uniform(40, boundary, 3))
        assertTrue(found[pairs.first(0, 0)].isNaN() && found[pairs.first(0, 1)].isFinite())
        val few = PairCorrelation(3.0, 2).of(uniform(20, boundary, 3))
        assertTrue(found[pairs.first(1, 1)] != few[0] && found[pairs.first(1, 1) + 1].isFinite())
        assertThrows(IllegalArgumentException::class.java) { pairs.first(0, 2) }
    }
}
