package daphnis.actors.region

import daphnis.actors.gas
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Open
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.engine.SerialEngine
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.step.CollisionStep
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

/**
 * The protocol without any framework: one thread that delivers messages in random orders, so every interleaving of
 * deliveries may come up.
 */
class StepCoordinatorTest {
    private fun step(p: Population, boundary: BoundaryConditions, duration: Double) =
        CollisionStep(p, boundary, CollisionLaw(ConstantRestitution(1.0)), CollisionCounters()).also {
            it.duration =
                duration
        }

    @Tag("thorough")
    @Test
    fun `any order of deliveries gives the serial engine's bits, with one message per mailbox and disjoint locks`() {
        var grants = 0
        var together = 0
        for (seed in 1L..60L) {
            val random = SeededRandom(seed)
            val (p, boundary) = gas(800, seed)
            // A long step, and one so short that regions at a distance cannot see one another.
            val duration = if (seed % 2 == 0L) 0.05 else 0.3
            val expected = p.copy().also { SerialEngine().advance(step(it, boundary, duration)) }
            val layout = if (seed % 2 == 0L) {
                RegionLayout.Stretches(1 + random.nextInt(12))
            } else {
                RegionLayout.Blocks(1 + random.nextInt(3), 1 + random.nextInt(3), 1 + random.nextInt(3))
            }
            val coordinator = StepCoordinator(RegionMap(layout))
            val mailboxes = arrayOfNulls<RegionCommand>(layout.count)
            val working = arrayOfNulls<RegionCommand>(layout.count)
            coordinator.begin(step(p, boundary, duration))
            while (!coordinator.isFinished) {
                while (true) {
                    val command = coordinator.poll() ?: break
                    assertTrue(mailboxes[command.region] == null && working[command.region] == null) {
                        "seed $seed: region ${command.region} gets a second message"
                    }
                    mailboxes[command.region] = command
                }
                val ready = mailboxes.indices.filter { mailboxes[it] != null }
                assertFalse(ready.isEmpty()) { "seed $seed: nobody has anything to do, and the step is not over" }
                val granted = ready.mapNotNull { mailboxes[it] }.filter { it.phase == Phase.GRANT }
                grants += granted.size
                if (granted.size > 1) together++
                for (a in granted) {
                    for (b in granted) {
                        if (a !== b) {
                            assertFalse(
                                a.locked.indices.any {
                                    a.locked[it] && b.locked[it]
                                },
                            ) { "seed $seed: two grants share a region" }
                        }
                    }
                }
                val region = ready[random.nextInt(ready.size)]
                working[region] = mailboxes[region]
                mailboxes[region] = null
                val reply = coordinator.regions[region].handle(working[region]!!)
                working[region] = null
                coordinator.accept(reply)
            }
            assertEquals(stateDigest(expected), stateDigest(p)) { "seed $seed, $layout" }
        }
        assertTrue(grants > 100) { "only $grants grants: borders were not tested" }
        assertTrue(together > 0) { "never two grants at the same time" }
    }

    @Test
    fun `a step that is cancelled ends when all have answered, and leaves the population alone`() {
        val (p, boundary) = gas(300, 1)
        val before = stateDigest(p)
        val coordinator = StepCoordinator(RegionMap(RegionLayout.Stretches(4)))
        coordinator.begin(step(p, boundary, 0.3))
        val commands = generateSequence { coordinator.poll() }.toList()
        coordinator.cancel()
        for (command in commands) coordinator.accept(coordinator.regions[command.region].handle(command))
        assertTrue(coordinator.isFinished && coordinator.isCancelled)
        assertEquals(before, stateDigest(p))
    }

    @Test
    fun `whatever a step by islands was doing when it was cancelled, a loop is shared after it`() {
        // A heavy one hits a light one, which goes beyond the bound, so that the step is redone before it ends.
        fun zeros() = DoubleArray(3)
        val p = Population(
            doubleArrayOf(0.0, 2.0, 30.0),
            zeros(),
            zeros(),
            doubleArrayOf(1.0, 0.0, 0.0),
            zeros(),
            zeros(),
            DoubleArray(3) { 0.5 },
            doubleArrayOf(1000.0, 0.001, 1.0),
        )
        val coordinator = StepCoordinator(RegionMap(RegionLayout.Stretches(2)))
        fun serve() = coordinator.poll()?.also { coordinator.accept(coordinator.regions[it.region].handle(it)) }
        val whole = step(p.copy(), Open, 20.0)
        var commands = 0
        coordinator.begin(whole)
        while (serve() != null) commands++
        assertTrue(whole.counters.redoneSteps > 0)
        for (last in 1..commands) {
            coordinator.begin(step(p.copy(), Open, 20.0))
            repeat(last) { serve() }
            coordinator.cancel()
            do {
                val told = serve()
            } while (told != null)
            assertTrue(coordinator.isFinished)
            val seen = IntArray(10)
            coordinator.renew()
            coordinator.share(seen.size, SharedLoop { _, from, to -> for (k in from until to) seen[k]++ })
            repeat(2) { serve() }
            assertTrue(coordinator.isFinished && !coordinator.isCancelled) { "cancelled after $last commands" }
            assertEquals(List(10) { 1 }, seen.toList()) { "cancelled after $last commands" }
        }
    }

    @Test
    fun `a loop is shared in order and without gaps, however long it is and however many regions there are`() {
        for (size in listOf(1, 5, 1000, Int.MAX_VALUE)) {
            for (count in listOf(1, 2, 7, RegionLayout.MOST)) {
                val coordinator = StepCoordinator(RegionMap(RegionLayout.Stretches(count)))
                val next = intArrayOf(0)
                coordinator.renew()
                coordinator.share(
                    size,
                    SharedLoop { _, from, to ->
                        assertEquals(next[0], from) { "$size among $count" }
                        assertTrue(to.toLong() - from <= size / count + 1L) { "$size among $count" }
                        next[0] = to
                    },
                )
                while (true) {
                    val command = coordinator.poll() ?: break
                    coordinator.accept(coordinator.regions[command.region].handle(command))
                }
                assertEquals(size, next[0]) { "$size among $count" }
                assertTrue(coordinator.isFinished)
            }
        }
    }
}
