package daphnis.core.search

import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class OverlapTest {
    @Test
    fun `the deepest overlap is found and named`() {
        val p = populationOf(Sphere(x = 0.0), Sphere(x = 1.9), Sphere(x = 10.0), Sphere(x = 11.0))
        val overlap = Overlap.deepest(p, Open, 0.0)
        assertEquals(listOf(2, 3), listOf(overlap.first, overlap.second))
        assertEquals(0.5, overlap.depth, 1e-15)
    }

    @Test
    fun `an overlap through a face counts where contacts are found through it`() {
        val p = populationOf(Sphere(x = -4.5), Sphere(x = 4.5))
        assertEquals(0.5, Overlap.deepest(p, Periodic(Box.centred(10.0, 10.0, 10.0)), 0.0).depth, 1e-15)
        assertEquals(0.0, Overlap.deepest(p, Open, 0.0).depth)
    }
}
