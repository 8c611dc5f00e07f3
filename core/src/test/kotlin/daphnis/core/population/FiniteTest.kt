package daphnis.core.population

import daphnis.core.Sphere
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class FiniteTest {
    @Test
    fun `of several numbers that are not finite, that of the first column and the lowest id is named`() {
        val one = populationOf(*Array(4) { Sphere() })
        val p = with(one) { Population(x, y, z, vx, vy, vz, radius, mass, intArrayOf(3, 1, 2, 0)) }
        assertEquals(null, p.firstNotFinite())
        p.mass[3] = Double.NaN
        p.vy[0] = Double.NaN
        p.vy[1] = Double.NEGATIVE_INFINITY
        p.vy[2] = Double.NaN
        assertEquals("vy of particle 1 is -Infinity", p.firstNotFinite())
    }
}
