package daphnis.core.cluster.bricks

import daphnis.core.Sphere
import daphnis.core.boundary.Open
import daphnis.core.initial.SeededRandom
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What bricks are made of, each by itself. */
class BrickPartsTest {
    @Test
    fun `the hash of a path takes in every impact, their order, and every number of the start`() {
        val once = PathHash.mix(PathHash.STRAIGHT, 0.0)
        assertNotEquals(PathHash.STRAIGHT, once)
        assertNotEquals(once, PathHash.mix(once, 0.0))
        assertNotEquals(PathHash.mix(PathHash.mix(once, 0L), 1L), PathHash.mix(PathHash.mix(once, 1L), 0L))
        assertNotEquals(PathHash.mix(1L, 0.0), PathHash.mix(1L, -0.0))
        val p = populationOf(Sphere(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0))
            .withSpin(doubleArrayOf(9.0), doubleArrayOf(10.0), doubleArrayOf(11.0))
            .withMaterial(intArrayOf(0), listOf("ice"))
        val whole = PathHash.whole(once, p, 0, tracksLastCollision = true)
        for (column in List(p.columnCount) { p.column(it) }) {
            val before = column[0]
            column[0] = Math.nextUp(before)
            assertNotEquals(whole, PathHash.whole(once, p, 0, tracksLastCollision = true))
            column[0] = before
        }
        assertEquals(whole, PathHash.whole(once, p, 0, tracksLastCollision = true))
    }

    @Test
    fun `an index of ids finds what was put in, and nothing else, whenever it is used again`() {
        val random = SeededRandom(2)
        val index = IdIndex()
        for (count in listOf(0, 1, 3, 1000, 40, 5000)) {
            val ids = HashMap<Int, Int>()
            while (ids.size < count) ids[random.nextInt(if (ids.size % 2 == 0) 10_000 else Int.MAX_VALUE)] = ids.size
            index.clear(count)
            for ((id, place) in ids) index.put(id, place)
            for ((id, place) in ids) assertEquals(place, index.find(id))
            repeat(200) { _ ->
                val id = random.nextInt(Int.MAX_VALUE)
                assertEquals(ids[id] ?: -1, index.find(id))
            }
        }
    }

    @Test
    fun `a margin starts with its estimate, is kept when it was too narrow, and shrinks to the estimate again`() {
        val margins = HaloMargins()
        margins.diameter = 2.0
        margins.collisionsPerSphere = 1.0
        assertEquals(2 * (3 + 1.35), margins.least)
        margins.reset(2)
        val first = margins.next()
        assertEquals(listOf(margins.least, margins.least), first.asList())
        val widths = HaloWidths(DoubleArray(3), DoubleArray(3), DoubleArray(2), first)
        val wider = widths.widened(booleanArrayOf(false, true), doubleArrayOf(0.5, 0.0, 0.0), 0, margins)
        assertEquals(listOf(first[0], 1.5 * first[1]), listOf(wider.extra(0), wider.extra(1)))
        assertTrue(wider.width(0, 0) > widths.width(0, 0) + 0.99)
        margins.keep(wider)
        val next = margins.next()
        assertEquals(listOf(first[0], 1.5 * first[1] * 0.98), next.asList())
        repeat(100) { margins.next() }
        assertEquals(margins.least, margins.next()[1])
        assertTrue(HaloMargins(0.0, 0.0).also { it.diameter = 1.0 }.widened(0.0, 0) > 0)
    }

    @Test
    fun `a division has at least one part along each axis`() {
        assertThrows(IllegalArgumentException::class.java) { BrickDivision(0, 1, 1) }
        assertThrows(IllegalArgumentException::class.java) { BrickDivision(32, 32, 2) }
        assertEquals(BrickDivision.MOST_BRICKS, BrickDivision(32, 32, 1).bricks)
    }

    @Test
    fun `a brick is not right when it has not heard of a sphere in sight, or could not see far enough`() {
        // Its own sphere at 0, one of its neighbour at 3; the plane is at 1.
        val p = populationOf(Sphere(r = 0.5), Sphere(x = 3.0, r = 0.5))
        val territory = Territory(Cuts(listOf(doubleArrayOf(1.0), DoubleArray(0), DoubleArray(0)), Open), Open, 1)
        val brick = Brick()
        brick.spheres.begin(2)
        for (k in 0..1) brick.spheres.add(p, IndexRuns().also { it.add(k) }, areOwn = k == 0)
        val comparison = PathComparison(0, territory, brick).also { it.index() }
        fun isRight(bound: Double, planned: Double, total: Int): Boolean {
            val widths = HaloWidths(DoubleArray(3) { planned }, DoubleArray(3), DoubleArray(2) { 0.5 }, DoubleArray(2))
            val silent = Outcome(AttemptKey(1, 1, 0), 1, PathList(), DoubleArray(3) { bound })
            return comparison.isRight(widths, arrayOf(null, silent), total)
        }
        // Sight is bound + 0.5 and the radius, the distance 2: out of sight, in sight, farther than the halo reaches.
        assertEquals(listOf(true, false), listOf(isRight(0.9, 1.0, 9), isRight(1.1, 1.0, 9)))
        assertEquals(listOf(true, false), listOf(isRight(0.9, 0.46, 9), isRight(0.9, 0.44, 9)))
        assertTrue(isRight(0.9, 0.0, total = 2)) { "a halo that holds all others" }
    }

    @Test
    fun `the agreement waits for every brick once, and lets those that were wrong compute again`() {
        val sent = ArrayList<Pair<Int, BrickMessage>>()
        val margins = HaloMargins().also { it.diameter = 1.0 }
        val agreement = Agreement(3, margins) { to, message -> sent += to to message }
        val key = AttemptKey(1, 7, 0)
        agreement.begin(key, HaloWidths.none(3))
        fun answer(from: Int, isRight: Boolean, at: AttemptKey) =
            agreement.receive(Agreed(at, from, isRight, doubleArrayOf(0.5, 0.0, 0.0), BrickCounts(from + 1L, 2, 3)))
        answer(0, true, key)
        answer(2, false, key)
        answer(2, false, key)
        answer(1, true, AttemptKey(1, 6, 0))
        assertEquals(0, sent.size)
        answer(1, true, key)
        val redo = sent.map { it.second as Redo }
        assertEquals(listOf(0, 1, 2), sent.map { it.first })
        assertTrue(redo.all { it.key == key.next && it.again.asList() == listOf(false, false, true) })
        assertTrue(!agreement.isDone && agreement.redone == 1)
        sent.clear()
        for (brick in 0..2) answer(brick, true, key)
        assertEquals(0, sent.size)
        for (brick in 0..2) answer(brick, true, key.next)
        assertTrue(agreement.isDone && sent.all { it.second is Go } && sent.size == 3)
        assertEquals(BrickCounts(6, 6, 9), agreement.counts)
    }
}
