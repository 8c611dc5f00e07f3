package daphnis.core.search

import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs

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
        for (sphere in listOf<(Double) -> Sphere>({ Sphere(y = it) }, { Sphere(z = it) })) {
            val q = populationOf(sphere(-4.5), sphere(4.5))
            assertEquals(0.5, Overlap.deepest(q, Periodic(Box.centred(10.0, 10.0, 10.0)), 0.0).depth, 1e-15)
        }
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

    @Test
    fun `spheres that touch do not overlap, and the pair is named by ids, the lower one first`() {
        val touching = Overlap.deepest(populationOf(Sphere(x = 0.0), Sphere(x = 2.0)), Open, 0.0)
        assertEquals(listOf(-1, -1, 0.0), listOf(touching.first, touching.second, touching.depth))
        // 0.5 and 1 and 1 are 1.5 together.
        val oblique = Overlap.deepest(populationOf(Sphere(), Sphere(x = -0.5, y = 1.0, z = -1.0)), Open, 0.0)
        assertEquals(0.25, oblique.depth, 1e-15)
        for (order in listOf(listOf(0.0, 1.0, 9.0), listOf(9.0, 1.0, 0.0), listOf(1.0, 9.0, 0.0))) {
            val found = Overlap.deepest(populationOf(*order.map { Sphere(y = it) }.toTypedArray()), Open, 0.0)
            val ids = listOf(order.indexOf(0.0), order.indexOf(1.0)).sorted()
            assertEquals(ids + 0.5, listOf(found.first, found.second, found.depth))
        }
    }

    @Test
    fun `near pairs are all pairs that touch once one is so much larger, each once, in sheared images too`() {
        val box = Box.centred(10.0, 12.0, 9.0)
        for (boundary in listOf(LeesEdwards(box, 0.7), Periodic(box), Open)) {
            val p = randomSpheres(80, Periodic(box), 3, 1.0) { 0.3 }
            val pairs = NearPairs(p, boundary, 1.3)
            val runs = pairs.runs()
            val found = ArrayList<List<Number>>()
            fun rounded(v: Double) = Math.rint(v * 1e9) / 1e9 + 0.0
            for (slot in 0 until p.size) {
                pairs.forEach(runs, slot, 0.9) { k, j, dx, dy, dz ->
                    assertEquals(k, pairs.index(slot))
                    if (maxOf(abs(dx), abs(dy), abs(dz)) > 1.2) return@forEach
                    val sign = if (k < j) 1 else -1
                    found += listOf<Number>(minOf(k, j), maxOf(k, j)) + listOf(dx, dy, dz).map { rounded(sign * it) }
                }
            }
            val images = Images().also { it.prepare(boundary, 1.3) }
            val wanted = ArrayList<List<Number>>()
            for (i in 0 until p.size) {
                for (j in i + 1 until p.size) {
                    for (code in imagesWithin(2, boundary)) {
                        val d = listOf(p.x, p.y, p.z).mapIndexed { axis, a -> a[j] - a[i] + images.shift(code, axis) }
                        if (d.all { abs(it) <= 1.2 }) wanted += listOf<Number>(i, j) + d.map { rounded(it) }
                    }
                }
            }
            assertTrue(wanted.size > 30)
            assertEquals(wanted.toSet(), found.toSet())
            assertEquals(found.size, found.toSet().size) { "a pair is given twice" }
        }
    }

    private companion object {
        const val LARGE = 20_800
    }
}
