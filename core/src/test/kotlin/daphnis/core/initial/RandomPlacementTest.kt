package daphnis.core.initial

import daphnis.core.boundary.Box
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.pow

class RandomPlacementTest {
    private class Case(seed: Long) {
        val random = SeededRandom(seed)
        val box = Box.centred(length(), length(), if (random.nextInt(3) == 0) 2.5 else length())
        val walled = BooleanArray(3) { random.nextInt(2) == 0 }
        val obstacles =
            List(random.nextInt(3)) { Obstacle(within(0), within(1), within(2), random.nextDouble(0.1, 1.5)) }
        val filling = random.nextDouble(0.01, 0.3)
        val sizes =
            listOf(
                EqualSizes(0.3),
                PowerLawSizes(0.1, 1.0, 3.0),
                ListedSizes(doubleArrayOf(0.5, 0.2, 0.2, 0.5000000001)),
                PowerLawSizes(0.3, 0.31, 0.0),
            )
        val radii = fill(sizes[random.nextInt(sizes.size)])

        private fun length() = random.nextDouble(3.0, 14.0)

        private fun within(axis: Int) = random.nextDouble(box.lower(axis), box.upper(axis))

        private fun fill(sizes: SizeDistribution): DoubleArray {
            val radii = ArrayList<Double>()
            var left = filling * box.volume
            while (radii.isEmpty() || left > 0 && radii.size < 3000) {
                radii += sizes.draw(random)
                left -= 4.0 / 3.0 * Math.PI * radii.last().pow(3)
            }
            return radii.toDoubleArray()
        }

        override fun toString() =
            "${radii.size} spheres, filling $filling, walls ${walled.toList()}, ${obstacles.size} obstacles, " +
                "radii ${radii.min()} to ${radii.max()}"
    }

    /** Positions, or the message of the refusal; and the next number of the stream. */
    private fun outcome(placement: Placement, case: Case): Pair<Any, Long> {
        val random = SeededRandom(case.radii.size.toLong())
        return try {
            val p = placement.place(case.radii, case.box, case.walled, random)
            listOf(p.x.toList(), p.y.toList(), p.z.toList()) to random.nextLong()
        } catch (e: PlacementException) {
            // Its second half is advice.
            e.message.orEmpty().substringBefore(";") to 0L
        }
    }

    @Tag("thorough")
    @Test
    fun `blocks on any number of threads come to the state of one try after the other`() {
        var refused = 0
        for (seed in 1L..150L) {
            val case = Case(seed)
            val expected = outcome(SequentialPlacement(TRIES, case.obstacles), case)
            if (expected.first is String) refused++
            for ((threads, block) in listOf(1 to 1, 1 to 7, 2 to 1000, 4 to 300, 3 to 1000)) {
                val found = outcome(RandomPlacement(TRIES, case.obstacles, threads, block, 0), case)
                assertEquals(expected, found) { "seed $seed: $case, $threads threads, blocks of $block" }
            }
            assertEquals(expected, outcome(RandomPlacement(TRIES, case.obstacles), case)) {
                "seed $seed: $case, as users call it"
            }
        }
        assertTrue(refused in 1..75) { "$refused of 150 cases were refused: too many or too few to test both outcomes" }
    }

    @Test
    fun `a placement that is large enough for threads comes to the state of one try after the other`() {
        val box = Box.centred(40.0, 40.0, 12.0)
        for (walled in listOf(booleanArrayOf(false, false, false), booleanArrayOf(false, false, true))) {
            val radii = PowerLawSizes(0.1, 1.0, 3.0).radii(25_000, SeededRandom(9))
            val expected = SequentialPlacement().place(radii, box, walled, SeededRandom(5))
            val found = RandomPlacement(threads = 4).place(radii, box, walled, SeededRandom(5))
            assertArrayEquals(expected.x, found.x)
            assertArrayEquals(expected.y, found.y)
            assertArrayEquals(expected.z, found.z)
        }
    }

    @Tag("thorough")
    @Test
    fun `one to eight threads come to the same bits, and to the same refusal, where hardly a place is free`() {
        val box = Box.centred(10.0, 10.0, 10.0)
        val crowd = Crowd(DoubleArray((0.34 / ONE * box.volume).toInt()) { 0.25 }, box)
        val placed = crowd.outcome(1, 200_000, 1000L)
        val inVain = crowd.outcome(1, 200_000, 1L)
        val tooFewTries = crowd.outcome(1, 100, 1000L)
        assertTrue(placed.first is List<*>) { placed.first.toString() }
        assertTrue("spheres found a place in 10000 tries and more" in "${inVain.first}") { "${inVain.first}" }
        assertTrue("no free place found for a sphere of radius 0.25 in 100 tries" in "${tooFewTries.first}")
        for (threads in 2..8) {
            assertEquals(placed, crowd.outcome(threads, 200_000, 1000L)) { "$threads threads" }
            assertEquals(inVain, crowd.outcome(threads, 200_000, 1L)) { "$threads threads" }
            assertEquals(tooFewTries, crowd.outcome(threads, 100, 1000L)) { "$threads threads" }
        }
    }

    /** Spheres that are hard to place in a periodic box. */
    private class Crowd(private val radii: DoubleArray, private val box: Box) {
        /** Positions, or the message of the refusal; and the next number of the stream. */
        fun outcome(threads: Int, tries: Int, vain: Long): Pair<Any, Long> {
            val random = SeededRandom(11)
            val placement = RandomPlacement(tries, emptyList(), threads, null, 0, vain)
            val outcome = try {
                placement.place(radii, box, BooleanArray(3), random).let {
                    listOf(it.x, it.y, it.z).map { a -> a.toList() }
                }
            } catch (e: PlacementException) {
                e.message.orEmpty()
            }
            return outcome to random.nextLong()
        }
    }

    @Tag("thorough")
    @Test
    fun `most places of a block are judged before their turn, between walls and with sizes too`() {
        val box = Box.centred(60.0, 60.0, 8.0)
        val radii = PowerLawSizes(0.1, 1.0, 3.0).radii(100_000, SeededRandom(9))
        val walled = booleanArrayOf(false, false, true)
        val space = OccupiedSpace(radii, largestFirst(radii), box, walled, emptyList())
        val block = CandidateBlock(space, box, walled, COUNT)
        val placed = RandomPlacement().place(radii, box, walled, SeededRandom(1))
        val order = largestFirst(radii)
        val first = 50_000
        for (rank in 0 until first) space.add(rank, placed.x[order[rank]], placed.y[order[rank]], placed.z[order[rank]])
        block.draw(COUNT, SeededRandom(2))
        block.judge(first, COUNT, daphnis.core.parallel.InlineLoop)
        val open = (0 until COUNT).count { block.verdict(it) == Verdict.OPEN }
        assertTrue(open < COUNT / 10) { "$open of $COUNT are open" }
        assertTrue((0 until COUNT).any { block.verdict(it) == Verdict.TAKEN })
    }

    @Test
    fun `the threads of a placement end`() {
        RandomPlacement(threads = 3).place(
            DoubleArray(30_000) {
                0.1
            },
            Box.centred(20.0, 20.0, 20.0),
            BooleanArray(3),
            SeededRandom(1),
        )
        val deadline = System.nanoTime() + 10_000_000_000
        while (workers().isNotEmpty() && System.nanoTime() < deadline) Thread.sleep(10)
        assertEquals(emptyList<Thread>(), workers())
    }

    private fun workers() = Thread.getAllStackTraces().filter { (thread, stack) ->
        thread.name.startsWith("daphnis-pool") && stack.none { it.className.contains("Engine") }
    }.keys.toList()

    @Test
    fun `the largest come first, and equal ones in their own order`() {
        val random = SeededRandom(8)
        for (n in listOf(0, 1, 2, 1000)) {
            val radii = DoubleArray(n) { if (it % 3 == 0) 1.0 else random.nextDouble(1e-3, 1e3) }
            assertEquals(radii.indices.sortedByDescending { radii[it] }, largestFirst(radii).toList())
        }
        assertEquals(listOf(0, 1, 2), largestFirst(DoubleArray(3) { 0.5 }).toList())
        assertEquals(
            listOf(2, 1, 0),
            largestFirst(doubleArrayOf(1.0, Math.nextUp(1.0), 1.0 + 2 * Math.ulp(1.0))).toList(),
        )
    }

    @Test
    fun `no more numbers are drawn than tries are made`() {
        val random = SeededRandom(3)
        RandomPlacement().place(DoubleArray(500) { 0.01 }, Box.centred(50.0, 50.0, 50.0), BooleanArray(3), random)
        val same = SeededRandom(3)
        repeat(3 * 500) { same.nextLong() }
        assertEquals(same.nextLong(), random.nextLong())
    }

    @Test
    fun `a sphere wider than the walls are apart is named`() {
        val e = assertThrows(PlacementException::class.java) {
            RandomPlacement().place(
                doubleArrayOf(0.1, 2.0),
                Box.centred(9.0, 9.0, 4.0),
                booleanArrayOf(false, false, true),
                SeededRandom(1),
            )
        }
        assertEquals("a sphere of radius 2.0 does not fit between the walls along z", e.message)
    }

    private companion object {
        const val TRIES = 300

        /** Volume of a sphere of radius 0.25. */
        const val ONE = 4.0 / 3.0 * Math.PI / 64
        const val COUNT = 2000
    }
}
