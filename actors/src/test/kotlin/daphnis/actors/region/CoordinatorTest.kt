package daphnis.actors.region

import daphnis.actors.gas
import daphnis.core.collision.ConstantRestitution
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.horizon.HorizonSteps
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeBody
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.stateDigest
import daphnis.core.simulationOf
import daphnis.core.step.CollisionStep
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.util.concurrent.CancellationException

/** The coordinator without any framework: one thread that delivers shares in random orders. */
class CoordinatorTest {
    /** Regions on the test's own thread, which says which of them works next. */
    private class Desk(val count: Int) : RegionHost {
        private val regions = List(count) { Region(it) }
        private val answers = Answers(count)
        val coordinator = Coordinator(regions, answers, this, patience = Long.MAX_VALUE)
        val mailboxes = arrayOfNulls<Share>(count)
        override val name = "the desk"
        override val hasEnded = false

        /** The region whose mailbox takes nothing. */
        var broken = -1

        override fun send(region: Int, share: Share) {
            check(region != broken) { "broken" }
            assertNull(mailboxes[region]) { "region $region gets a second share" }
            mailboxes[region] = share
        }

        override fun stop() = Unit

        val waiting: List<Int> get() = mailboxes.indices.filter { mailboxes[it] != null }

        /** Lets [region] do its share, if it has one. */
        fun serve(region: Int) {
            if (region == 0) coordinator.serveOwn()
            val share = mailboxes[region] ?: return
            mailboxes[region] = null
            regions[region].serve(share, answers)
        }

        fun serveAll() {
            for (region in 0 until count) serve(region)
        }
    }

    /** Every interleaving of deliveries may come up. */
    private class AnyOrder(private val desk: Desk, private val random: SeededRandom) : RangeLoop {
        var count = 0
        override val workers: Int get() = desk.count

        override fun run(size: Int, grain: Int, body: RangeBody) {
            if (size <= 0) return
            desk.coordinator.share(size, SharedLoop(body))
            count += desk.count
            while (!desk.coordinator.turn()) desk.serve(random.nextInt(desk.count))
            desk.coordinator.throwFailure()
            assertEquals(emptyList<Int>(), desk.waiting)
        }
    }

    private class InEpochs(desk: Desk, random: SeededRandom) : CollisionEngine {
        val shares = AnyOrder(desk, random)
        private val horizon = HorizonSteps(shares, fewest = 0, HorizonTuning(steps = 2, deviation = 0.0))
        override val name = "in epochs"
        override val threads = 1
        override val loop: RangeLoop get() = InlineLoop

        override fun advance(step: CollisionStep) {
            assertTrue(horizon.take(step))
        }
    }

    @Test
    fun `any order of deliveries gives the serial engine's bits, with one share per mailbox`() {
        var shares = 0
        for (seed in 1L..40L) {
            val random = SeededRandom(seed)
            val (p, boundary) = gas(800, seed)
            val desk = Desk(1 + random.nextInt(12))
            val engine = InEpochs(desk, random)
            val (serial, shared) = listOf(SerialEngine(), engine).map {
                simulationOf(p.copy(), boundary, 0.1, ConstantRestitution(1.0), engine = it)
            }
            repeat(4) {
                serial.advance()
                shared.advance()
            }
            assertEquals(stateDigest(serial.population), stateDigest(shared.population)) {
                "seed $seed, ${desk.count} regions"
            }
            shares += engine.shares.count
        }
        assertTrue(shares > 5000) { "only $shares shares" }
    }

    @Test
    fun `a loop that is cancelled ends when all have answered, and the regions take the next`() {
        val desk = Desk(4)
        val coordinator = desk.coordinator
        for (served in 0..4) {
            coordinator.begin()
            coordinator.share(8, SharedLoop { _, _, _ -> })
            for (region in 0 until served) desk.serve(region)
            coordinator.cancel("enough")
            assertEquals(served == 4, coordinator.turn())
            desk.serveAll()
            assertTrue(coordinator.turn())
            assertEquals(
                "enough",
                assertThrows(CancellationException::class.java) {
                    coordinator.throwFailure()
                }.message,
            )
            assertTrue(coordinator.isReusable)
            val seen = IntArray(10)
            coordinator.begin()
            coordinator.share(seen.size, SharedLoop { _, from, to -> for (k in from until to) seen[k]++ })
            desk.serveAll()
            assertTrue(coordinator.turn())
            coordinator.throwFailure()
            assertEquals(List(10) { 1 }, seen.toList())
        }
    }

    @Test
    fun `a region that cannot be told ends the loop, and what was told is abandoned`() {
        val desk = Desk(4)
        val coordinator = desk.coordinator
        desk.broken = 2
        var done = 0
        val loop = SharedLoop { _, _, _ -> done++ }
        coordinator.begin()
        coordinator.share(8, loop)
        assertTrue(coordinator.turn())
        assertEquals("broken", assertThrows(IllegalStateException::class.java) { coordinator.throwFailure() }.message)
        assertFalse(coordinator.isReusable)
        coordinator.abandon(loop)
        desk.serveAll()
        assertEquals(0, done)
    }

    @Test
    fun `what a region throws ends the loop when all have answered, and no step follows`() {
        val desk = Desk(3)
        val coordinator = desk.coordinator
        val thrown = IllegalStateException("on purpose")
        coordinator.begin()
        coordinator.share(3, SharedLoop { worker, _, _ -> if (worker == 1) throw thrown })
        desk.serve(1)
        assertFalse(coordinator.turn())
        desk.serveAll()
        assertTrue(coordinator.turn())
        assertSame(thrown, assertThrows(IllegalStateException::class.java) { coordinator.throwFailure() })
        assertThrows(IllegalStateException::class.java) { coordinator.begin() }
    }

    @Test
    fun `a loop is shared in order and without gaps, however long it is and however many regions there are`() {
        for (size in listOf(1, 5, 1000, 4_000_000, Int.MAX_VALUE)) {
            for (count in listOf(1, 2, 7, 1000, RegionCount.MOST)) {
                val desk = Desk(count)
                var next = 0
                desk.coordinator.share(
                    size,
                    SharedLoop { _, from, to ->
                        assertEquals(next, from) { "$size among $count" }
                        assertTrue(to.toLong() - from <= size / count + 1L) { "$size among $count" }
                        next = to
                    },
                )
                desk.serveAll()
                assertTrue(desk.coordinator.turn())
                desk.coordinator.throwFailure()
                assertEquals(size, next) { "$size among $count" }
            }
        }
    }
}
