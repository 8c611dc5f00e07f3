package daphnis.core.cluster.bricks

import daphnis.core.Sphere
import daphnis.core.boundary.Open
import daphnis.core.engine.SerialEngine
import daphnis.core.initial.SeededRandom
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout

/** Nodes and agreement as state machines, on a net that delivers in any order, twice, and late. */
@Timeout(600)
class BrickNetTest {
    private fun net(seed: Long, trouble: NetTrouble): BrickNet {
        val case = LongBox(seed, long = 32)
        return BrickNet(case.population, case.boundary, LongBox.DT, case.slabs(4), SeededRandom(seed), trouble)
    }

    @Tag("thorough")
    @Test
    fun `messages in any order, some twice and some late, lead to the step of the serial engine`() {
        var late = 0
        var twice = 0
        var redone = 0
        for (seed in 1L..12L) {
            val net = net(seed, NetTrouble.ORDER_AND_COPIES)
            val serial = net.simulation(SerialEngine())
            for (step in 1..4) {
                serial.advance()
                net.advance()
                assertEquals(stateDigest(serial.population), stateDigest(net.population)) { "seed $seed, step $step" }
                assertEquals(serial.collisions!!.counters.collisions, net.counters.collisions) { "seed $seed" }
            }
            late += net.late
            twice += net.copies
            redone += net.redone
        }
        assertTrue(late > 100 && twice > 500 && redone > 20) { "$late late, $twice twice, $redone redone" }
    }

    @Test
    fun `a brick that was right computes again when its neighbour, which was wrong, has computed again`() {
        // A row of spheres at rest in three bricks, and one on the right that strikes it. The middle brick does not see
        // that one at first. The left one agrees with the middle one that nothing happens.
        val row = Array(14) { Sphere(x = 1.0001 * it, r = 0.5) }
        val start = populationOf(*row, Sphere(x = 14.9, vx = -1.0, r = 0.5))
        for (seed in 1L..5L) {
            val slabs = BrickDivision(3, 1, 1)
            val net = BrickNet(start, Open, dt = 1.0, slabs, SeededRandom(seed), NetTrouble.ORDER_AND_COPIES)
            val serial = net.simulation(SerialEngine())
            serial.advance()
            net.advance()
            assertTrue(serial.collisions!!.counters.collisions >= 14)
            assertEquals(stateDigest(serial.population), stateDigest(net.population))
            assertEquals(1, net.changedTheirMind)
        }
    }

    @Tag("thorough")
    @Test
    fun `a flipped bit of a sphere in sight is noticed, even if it meets nothing`() {
        var flipped = 0
        for (seed in 1L..15L) {
            val net = net(seed, NetTrouble.FLIPPED_BIT)
            val serial = net.simulation(SerialEngine())
            serial.advance()
            net.advance()
            flipped += net.flipped
            assertTrue(net.redone >= minOf(net.flipped, 1)) {
                "seed $seed: ${net.flipped} flipped, ${net.redone} redone"
            }
            assertEquals(stateDigest(serial.population), stateDigest(net.population)) { "seed $seed" }
        }
        assertTrue(flipped > 10) { "only $flipped bits flipped" }
    }
}
