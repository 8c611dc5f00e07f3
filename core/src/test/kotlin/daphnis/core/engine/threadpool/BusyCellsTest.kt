package daphnis.core.engine.threadpool

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.randomSpheres
import daphnis.core.step.PreparedStep
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs

class BusyCellsTest {
    private val box = Box.centred(30.0, 50.0, 20.0)
    private val boundaries: List<BoundaryConditions> = listOf(Open, Periodic(box), LeesEdwards(box, 0.3), Walls(box))

    /**
     * Whether the two may see one another, image by image; images across the sheared faces may be anywhere along the
     * slide.
     */
    private fun isNear(p: Population, prepared: PreparedStep, boundary: BoundaryConditions, a: Int, b: Int): Boolean {
        if (b < 0) return false
        val i = prepared.rows.origin[a]
        val j = prepared.rows.origin[b]
        val apart = doubleArrayOf(p.x[j] - p.x[i], p.y[j] - p.y[i], p.z[j] - p.z[i])
        val sight = DoubleArray(3) {
            if (prepared.grid.classes >
                1
            ) {
                prepared.grid.sight(it, p.radius[i], p.radius[j])
            } else {
                prepared.grid.sight(it)
            }
        }
        val boxes = List(3) { if (boundary.contactFaces(it) == ContactFaces.PERIODIC) -1..1 else 0..0 }
        val shear = boundary.shear
        for (kx in boxes[0]) {
            for (ky in boxes[1]) {
                for (kz in boxes[2]) {
                    val k = intArrayOf(kx, ky, kz)
                    val isSeen = (0..2).all {
                        val isAnywhere = shear != null && it == shear.slideAxis && k[shear.normalAxis] != 0
                        val shift = if (k[it] == 0) 0.0 else k[it] * boundary.box.length(it)
                        isAnywhere || abs(apart[it] + shift) <= sight[it]
                    }
                    if (isSeen) return true
                }
            }
        }
        return false
    }

    @Test
    fun `a collision is free when none that is busy is near or simultaneous`() {
        var free = 0
        var asked = 0
        for (seed in 1L..60L) {
            val random = SeededRandom(seed)
            val boundary = boundaries[(seed % boundaries.size).toInt()]
            val isMixed = seed % 3 == 0L
            val p = randomSpheres(60, if (boundary === Open) Periodic(box) else boundary, seed, 0.5) {
                if (isMixed && it.nextInt(20) == 0) 4.0 else 0.2
            }
            val prepared = preparedOf(p, boundary)
            val busy = BusyCells(prepared.rows, prepared.grid).apply { prepare(p) }
            val expected = ArrayList<Triple<Int, Int, Double>>()
            fun slot() = random.nextInt(60)
            fun partner() = if (random.nextInt(4) == 0) -1 - random.nextInt(6) else slot()
            repeat(300) {
                if (expected.size > random.nextInt(4)) {
                    val (a, b, _) = expected.removeAt(random.nextInt(expected.size))
                    busy.remove(a, b)
                } else {
                    val pair = Triple(slot(), partner(), random.nextInt(8) / 8.0)
                    if (expected.none { it.first == pair.first && it.second == pair.second }) {
                        expected += pair
                        busy.add(pair.first, pair.second, pair.third)
                    }
                }
                val a = slot()
                val b = partner()
                val t = random.nextInt(8) / 8.0
                val isFree = expected.none { (c, d, time) ->
                    fun isSeen(slot: Int) = slot >= 0 && listOf(c, d).any { isNear(p, prepared, boundary, slot, it) }
                    time == t || isSeen(a) || isSeen(b)
                }
                assertEquals(isFree, busy.areFree(a, b, t)) { "seed $seed, $boundary: $a with $b beside $expected" }
                assertEquals(expected.any { it.third < t }, busy.hasBefore(t))
                asked++
                if (isFree) free++
            }
        }
        assertTrue(free in asked / 5..asked * 4 / 5) { "$free of $asked are free: the draw is one-sided" }
    }
}
