package daphnis.core.population

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.force.BodyGravity
import daphnis.core.force.SelfGravity
import daphnis.core.format.CartAndRad
import daphnis.core.format.ExtendedXyz
import daphnis.core.format.H5md
import daphnis.core.format.ParticleCsv
import daphnis.core.format.Snapshot
import daphnis.core.format.Vtp
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.permuted
import daphnis.core.randomSpheres
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** Ids with wide gaps, up to the largest there is, mean what 0, 1, 2, … in the same order mean. */
class OddIdsTest {
    private val boundary = Periodic(Box.centred(8.0, 8.0, 8.0))
    private val dense = randomSpheres(60, boundary, 3, 1.0) { 0.4 }

    /** Ascending, as many as [dense] has spheres: the least and the largest id, and others between. */
    private val odd = SeededRandom(9).let { random ->
        val drawn = sortedSetOf(0, 1, Int.MAX_VALUE)
        while (drawn.size < dense.size) drawn += random.nextInt(Int.MAX_VALUE)
        drawn.toIntArray()
    }

    private fun withOddIds(p: Population) = with(p) {
        Population(
            x.copyOf(), y.copyOf(), z.copyOf(), vx.copyOf(), vy.copyOf(), vz.copyOf(), radius.copyOf(), mass.copyOf(),
            IntArray(size) { odd[id[it]] },
        )
    }

    private fun simulation(p: Population, bodies: IntArray, islands: Boolean = false): Simulation {
        val engine = if (islands) IslandsEngine(FixedPool(2), fewest = 0) else SerialEngine()
        val forces = listOf(BodyGravity(bodies, boundary, 0.01), SelfGravity(boundary, 0.01))
        val collisions = CollisionForcing(ConstantRestitution(0.9), engine = engine)
        return Simulation(p, boundary, collisions, FixedTimeStep(0.5), forces)
    }

    @Test
    fun `the same spheres with odd ids have the same history, digest, sums and boxes crossed`() {
        val a = simulation(dense.copy(), intArrayOf(7, 59))
        val b = simulation(withOddIds(dense), intArrayOf(odd[7], odd[59]))
        val c = simulation(withOddIds(dense).permuted(4), intArrayOf(odd[7], odd[59]), islands = true)
        for (s in listOf(a, b, c)) s.use { repeat(20) { _ -> it.advance() } }
        assertTrue(a.collisions!!.counters.collisions > 30)
        for (s in listOf(b, c)) {
            val p = s.population
            assertEquals(stateDigest(a.population), stateDigest(p))
            val copy = p.copy()
            for (id in odd.indices) {
                val k = p.indexOf(odd[id])
                assertEquals(odd[id], p.id[k])
                for (axis in 0..2) assertEquals(a.population.boxesCrossed(id, axis), p.boxesCrossed(odd[id], axis))
                for (axis in 0..2) assertEquals(a.population.boxesCrossed(id, axis), copy.boxesCrossed(odd[id], axis))
            }
            assertTrue(odd.any { copy.boxesCrossed(it, 0) != 0 })
            assertEquals(granularTemperature(a.population, null), granularTemperature(p, null))
            assertArrayEquals(odd, p.indicesById().map { p.id[it] }.toIntArray())
        }
        fun stress(s: Simulation) = SelfGravity(boundary, 0.01).stressXY(s.population, 0.0)
        assertEquals(stress(a), stress(b))
    }

    @Test
    fun `the digest sees every sphere whatever its id`() {
        for (k in 0 until dense.size) {
            val p = withOddIds(dense)
            val before = stateDigest(p)
            p.x[k] = Math.nextUp(p.x[k])
            assertNotEquals(before, stateDigest(p)) { "id ${p.id[k]}" }
        }
    }

    @Test
    fun `an id that no sphere has, or has any more, is not found`() {
        val p = withOddIds(dense)
        for (id in listOf(-1, 2, 1_000_000_000, Int.MAX_VALUE - 1)) {
            assertEquals(-1, p.indexOf(id))
            assertEquals(0, p.boxesCrossed(id, 1))
        }
        for (k in 0 until p.size) p.addCrossing(k, 1, k)
        p.retain { p.id[it] != Int.MAX_VALUE && p.id[it] != 0 }
        for (id in listOf(0, Int.MAX_VALUE)) assertEquals(-1, p.indexOf(id))
        assertEquals(58, p.indicesById().size)
        val copy = p.copy()
        for (k in 0 until p.size) {
            assertEquals(k, p.indexOf(p.id[k]))
            assertEquals(p.boxesCrossed(p.id[k], 1), copy.boxesCrossed(p.id[k], 1))
        }
        assertEquals(stateDigest(p), stateDigest(copy))
        for (q in listOf(p, copy)) q.retain { false }
        assertEquals(stateDigest(p), stateDigest(copy))
    }

    @Test
    fun `files keep odd ids`(@TempDir home: Path) {
        val p = withOddIds(dense).permuted(6)
        val frame = Snapshot.of(p, boundary, 0, 0.0)
        assertArrayEquals(odd, frame.id)
        H5md.write(listOf(frame), home.resolve("a.h5"), "test")
        Files.newBufferedWriter(home.resolve("a.xyz")).use { ExtendedXyz.write(frame, it) }
        for (q in listOf(H5md.read(home.resolve("a.h5")).single(), ExtendedXyz.read(home.resolve("a.xyz")).single())) {
            assertArrayEquals(odd, q.id)
            assertEquals(stateDigest(p), stateDigest(q.population()))
        }
        Vtp.write(frame, home.resolve("a.vtp"))
        CartAndRad.write(p, home.resolve("a.bin"))
        assertEquals(stateDigest(p), stateDigest(CartAndRad.population(home.resolve("a.bin"))))
        val csv = Files.writeString(home.resolve("a.csv"), "id,x,y,z,radius\n2147483647,1,2,3,0.5\n0,4,5,6,0.5\n")
        assertArrayEquals(intArrayOf(0, Int.MAX_VALUE), ParticleCsv.population(csv, 1.0).id)
    }
}
