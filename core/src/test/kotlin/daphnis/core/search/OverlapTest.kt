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

    @Test
    fun `any number of threads names the same pair, also of many that are equally deep`() {
        val pairs = List(LARGE) { Sphere(x = 8.0 * (it % 40), y = 4.0 * (it / 40 % 40), z = 4.0 * (it / 1600)) }
        val equal = populationOf(*(pairs + pairs.map { Sphere(x = it.x + 1.9, y = it.y, z = it.z) }).toTypedArray())
        val deeper = Sphere(x = pairs[LARGE - 1].x, y = pairs[LARGE - 1].y, z = pairs[LARGE - 1].z + 1.5)
        val one = populationOf(*(pairs + deeper).toTypedArray())
        for (population in listOf(equal, one)) {
            val expected = Overlap.deepest(population, Open, 0.0)
            assertEquals(if (population === equal) 0.05 else 0.25, expected.depth, 1e-12)
            for (threads in 2..4) {
                val found = Overlap.deepest(population, Open, 0.0, threads)
                assertEquals(
                    listOf(expected.first, expected.second, expected.depth),
                    listOf(found.first, found.second, found.depth),
                ) {
                    "$threads threads"
                }
            }
        }
    }

    private companion object {
        const val LARGE = 20_800
    }
}
