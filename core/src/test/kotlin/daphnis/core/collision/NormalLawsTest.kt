package daphnis.core.collision

import daphnis.core.surface.StepRestitution
import daphnis.core.surface.TableRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Steps and tables. */
class NormalLawsTest {
    @Test
    fun `a step is elastic below its speed, and has its coefficient at it and above`() {
        for (unit in listOf(1.0, 4.0)) {
            val law = StepRestitution(2.0, 0.75, cmPerSecond = unit)
            val at = 2.0 / unit
            assertEquals(
                listOf(1.0, 1.0, 0.75, 0.75),
                listOf(0.0, Math.nextDown(at), at, 1e9).map { law.coefficient(it) },
            )
        }
        val plastic = StepRestitution(2.0, 1.0, below = 0.25)
        assertEquals(listOf(0.25, 1.0), listOf(1.0, 3.0).map { plastic.coefficient(it) })
    }

    @Test
    fun `a table goes through its points, is straight between them, and constant beyond its ends`() {
        val speeds = doubleArrayOf(0.5, 1.0, 3.0, 4.0, 8.0)
        val coefficients = doubleArrayOf(1.0, 0.5, 0.75, 0.0, 0.25)
        for (unit in listOf(1.0, 2.0)) {
            val law = TableRestitution(speeds, coefficients, unit)
            fun at(v: Double) = law.coefficient(v / unit)
            for (k in speeds.indices) assertEquals(coefficients[k], at(speeds[k])) { "point $k" }
            assertEquals(listOf(1.0, 1.0, 0.25, 0.25), listOf(0.0, 0.4, 9.0, 1e300).map { at(it) })
            assertEquals(listOf(0.75, 0.625, 0.1875, 0.125), listOf(0.75, 2.0, 3.75, 6.0).map { at(it) })
            // On either side of a point there is no jump.
            for (v in speeds) assertEquals(at(Math.nextDown(v)), at(Math.nextUp(v)), 1e-14)
        }
        val one = TableRestitution(doubleArrayOf(0.0), doubleArrayOf(0.5))
        assertEquals(listOf(0.5, 0.5), listOf(0.0, 7.0).map { one.coefficient(it) })
        val given = doubleArrayOf(1.0)
        val law = TableRestitution(doubleArrayOf(1.0), given)
        given[0] = 0.0
        assertEquals(1.0, law.coefficient(1.0))
    }

    @Test
    fun `a table of many points has what a search from its start finds`() {
        val speeds = DoubleArray(37) { it * it * 0.1 }
        val coefficients = DoubleArray(37) { 1.0 / (1 + it % 5) }
        val law = TableRestitution(speeds, coefficients)
        for (k in 0 until 4000) {
            val v = 0.031 * k
            val next = speeds.indexOfFirst { it > v }
            val expected = if (next < 0) {
                coefficients.last()
            } else {
                val share = (v - speeds[next - 1]) / (speeds[next] - speeds[next - 1])
                coefficients[next - 1] * (1 - share) + coefficients[next] * share
            }
            assertEquals(expected, law.coefficient(v), 1e-14) { "at $v" }
        }
    }

    @Test
    fun `what makes no law is refused with its number`() {
        fun table(vararg points: Double) = TableRestitution(
            DoubleArray(points.size / 2) { points[2 * it] },
            DoubleArray(points.size / 2) { points[2 * it + 1] },
        )

        val infinity = Double.POSITIVE_INFINITY
        val wrong = listOf<Pair<String, () -> Any>>(
            "the speed of the step is 0.0 cm/s; it must be > 0" to { StepRestitution(0.0, 0.5) },
            "the speed of the step is Infinity" to { StepRestitution(infinity, 0.5) },
            "coefficient of restitution is 1.1; it must be in [0, 1]" to { StepRestitution(1.0, 1.1) },
            "coefficient of restitution below the step is NaN" to { StepRestitution(1.0, 0.5, Double.NaN) },
            "one unit of speed is 0.0 cm/s" to { StepRestitution(1.0, 0.5, cmPerSecond = 0.0) },
            "there are 0 speeds and 0 coefficients" to { table() },
            "there are 2 speeds and 1 coefficients" to {
                TableRestitution(doubleArrayOf(1.0, 2.0), doubleArrayOf(1.0))
            },
            "speed 1 of the table is -1.0 cm/s; it must be at least 0" to { table(-1.0, 1.0) },
            "speed 2 of the table is 1.0 cm/s" to { table(1.0, 1.0, 1.0, 0.5) },
            "speed 3 of the table is NaN cm/s" to { table(1.0, 1.0, 2.0, 0.5, Double.NaN, 0.5) },
            "speed 2 of the table is Infinity cm/s" to { table(1.0, 1.0, infinity, 0.5) },
            "coefficient 2 of the table is 1.5; it must be in [0, 1]" to { table(1.0, 1.0, 2.0, 1.5) },
            "one unit of speed is NaN cm/s" to {
                TableRestitution(doubleArrayOf(1.0), doubleArrayOf(1.0), Double.NaN)
            },
        )
        for ((says, make) in wrong) {
            val e = assertThrows(IllegalArgumentException::class.java, { make() }, says)
            assertTrue(e.message!!.startsWith(says)) { "${e.message} is not: $says" }
        }
    }
}
