package daphnis.core.population

import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.force.EnergySums
import daphnis.core.force.Force
import daphnis.core.force.Kick
import daphnis.core.force.UniformAcceleration
import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillFrame
import daphnis.core.hill.Satellite
import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource
import java.nio.ByteBuffer

/** Sums of a population that is held in parts, each of which answers with bytes. */
class SumPartsTest {
    private val flow = MeanFlow(normalAxis = 0, flowAxis = 1, rate = -1.5)

    private class Divided(val parts: List<Population>, val flow: MeanFlow?, val firstBody: Int) : SumParts {
        val folds = parts.map { PopulationFold(flow, firstBody) }
        var firsts = 0

        override fun first(sums: FirstMoments) {
            firsts++
            sums.clear()
            val mine = FirstMoments(0, firstBody)
            for ((k, part) in parts.withIndex()) {
                folds[k].over(part, InlineLoop) { folds[k].first(mine) }
                val bytes = ByteBuffer.allocate(FirstMoments.MOST_BYTES).also(mine::write).flip()
                sums.merge(FirstMoments(0, firstBody).apply { read(bytes) })
            }
        }

        override fun central(means: Means, sums: CentralMoments) {
            sums.clear(means)
            val mine = CentralMoments(flow, firstBody)
            val sent = ByteBuffer.allocate(Means.BYTES).also(means::write).flip()
            val received = Means().apply { read(sent) }
            for ((k, part) in parts.withIndex()) {
                folds[k].over(part, InlineLoop) { folds[k].central(received, mine) }
                val bytes = ByteBuffer.allocate(CentralMoments.MOST_BYTES).also(mine::write).flip()
                sums.merge(CentralMoments(flow, firstBody).apply { read(means, bytes) })
            }
        }
    }

    /** The spheres of [p] on 1 to 8 machines, some of which may have none, in any order. */
    private fun divided(p: Population, random: SeededRandom): List<Population> {
        val parts = 1 + random.nextInt(8)
        val holder = IntArray(p.size) { random.nextInt(parts) }
        val order = LongArray(p.size) { random.nextLong() }
        return List(parts) { part ->
            val mine = holder.indices.filter { holder[it] == part }.sortedBy { order[it] }
            fun pick(a: DoubleArray) = DoubleArray(mine.size) { a[mine[it]] }
            Population(
                pick(p.x), pick(p.y), pick(p.z), pick(p.vx), pick(p.vy), pick(p.vz), pick(p.radius), pick(p.mass),
                IntArray(mine.size) { p.id[mine[it]] },
            )
        }
    }

    private fun numbers(s: PopulationSums): List<Double> =
        listOf(s.count.toDouble(), s.mass, s.kineticEnergy, s.particleMass, s.centreZ, s.scaleHeight, s.guidingX) +
            List(3) { s.momentum(it) } + s.moments.asList() + s.kinetic.asList() + s.mean.asList() +
            s.granularTemperature

    @ParameterizedTest
    @EnumSource
    fun `sums of parts in any division have the bits of the whole`(kind: SumCases.Numbers) {
        for (seed in 1L..200L) {
            val random = SeededRandom(seed)
            val size = if (seed % 20 == 0L) random.nextInt(4) else random.nextInt(700)
            val p = SumCases.population(size, random, kind.draw)
            val flow = if (seed % 4 == 0L) null else flow
            val firstBody = if (seed % 3 == 0L) Int.MAX_VALUE else size - random.nextInt(4)
            val whole = PopulationSums(flow, OrbitalFrequencies(0.7), firstBody).apply { take(p) }
            val inParts = PopulationSums(flow, OrbitalFrequencies(0.7), firstBody)
            repeat(2) {
                inParts.take(Divided(divided(p, random), flow, firstBody))
                assertEquals(numbers(whole), numbers(inParts)) { "$kind, seed $seed, $size spheres" }
            }
        }
    }

    @Test
    fun `a part that is lost between the rounds leaves nothing behind`() {
        val p = SumCases.gas(900, 7)
        val random = SeededRandom(7)
        val sums = PopulationSums(flow).apply { take(SumCases.gas(50, 8)) }
        val whole = Divided(divided(p, random), flow, Int.MAX_VALUE)
        val lost = object : SumParts by whole {
            override fun central(means: Means, sums: CentralMoments) {
                whole.central(means, sums)
                error("lost")
            }
        }
        assertThrows(IllegalStateException::class.java) { sums.take(lost) }
        sums.take(whole)
        assertEquals(numbers(PopulationSums(flow).apply { take(p) }), numbers(sums))
        assertEquals(2, whole.firsts)
    }

    @Test
    fun `conserved sums of parts are those of the whole`() {
        val p = SumCases.gas(900, 9)
        val whole = Conserved.of(p)
        val parts = Conserved.of(Divided(divided(p, SeededRandom(2)), flow, 880))
        assertEquals(
            listOf(900.0, whole.mass, whole.kineticEnergy, whole.momentumX, whole.momentumY, whole.momentumZ),
            listOf(
                parts.count.toDouble(),
                parts.mass,
                parts.kineticEnergy,
                parts.momentumX,
                parts.momentumY,
                parts.momentumZ,
            ),
        )
    }

    @ParameterizedTest
    @EnumSource
    fun `potential energies of parts have the bits of the whole, on any number of threads`(kind: SumCases.Numbers) {
        val pull = UniformAcceleration(0.3, -0.1, 2.0)
        val moon = Satellite(2.0, Epicycle(3.0, -8.0, 0.5, 0.2), 0.9, 0.1)
        val forces = listOf<Force>(HillFrame(0.9, 1.3), pull, Kick { _, _, _ -> }, moon)
        FixedPool(3).use { pool ->
            val loop = ParallelLoop(pool, LoopStrategy.DYNAMIC)
            for (seed in 1L..40L) {
                val random = SeededRandom(seed)
                val p = SumCases.population(random.nextInt(9000), random, kind.draw)
                val sums = EnergySums(forces, Open)
                val part = EnergySums(forces, Open)
                for (one in divided(p, random)) {
                    part.take(one, 1.5, loop)
                    val bytes = ByteBuffer.allocate(part.mostBytes).also(part::write).flip()
                    sums.merge(EnergySums(forces, Open).apply { read(bytes) })
                }
                for (force in forces.filter { sums.have(it) }) {
                    val expected = force.potentialEnergy(p, Open, 1.5)
                    assertEquals(expected.toRawBits(), sums.of(force).toRawBits()) { "$kind, seed $seed, $force" }
                }
            }
        }
    }

    @Test
    fun `a force without an energy has NaN, also without spheres, and one that does not say is not among them`() {
        val box = Periodic(Box.centred(4.0, 4.0, 4.0))
        val pull = UniformAcceleration(0.0, 0.0, 2.0)
        val own = Kick { _, _, _ -> }
        val sums = EnergySums(listOf(pull, own), box)
        val none = SumCases.gas(0, 1)
        sums.take(none, 0.0, InlineLoop)
        assertTrue(sums.have(pull))
        assertTrue(sums.of(pull).isNaN())
        assertTrue(pull.potentialEnergy(none, box, 0.0).isNaN())
        assertFalse(sums.have(own))
        assertEquals(0, sums.mostBytes)
        assertEquals(0.0, pull.potentialEnergy(none, Open, 0.0))
        val other = EnergySums(listOf(pull), Open)
        assertThrows(IllegalStateException::class.java) { other.merge(sums) }
        assertThrows(IllegalArgumentException::class.java) { other.read(ByteBuffer.allocate(3)) }
    }
}
