package daphnis.core.population

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.permuted
import daphnis.core.randomSpheres
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.ByteBuffer
import java.security.MessageDigest
import java.util.HexFormat

/** Columns that a population has or has not. */
class SpinColumnsTest {
    private val smooth = randomSpheres(20, Periodic(Box.centred(9.0, 9.0, 9.0)), 3, 1.0) { 0.4 }

    private fun spun(p: Population = smooth): Population {
        fun column(by: Double) = DoubleArray(p.size) { by * p.id[it] - 1 }
        return p.withSpin(column(0.1), column(0.2), column(0.3))
    }

    @Test
    fun `smooth spheres have no columns of spin, and none are made when they are copied, joined or moved`() {
        val p = smooth.copy()
        p.add(randomSpheres(0, Periodic(Box.centred(9.0, 9.0, 9.0)), 3, 1.0) { 0.4 })
        p.retain { it > 4 }
        p.drift(0.5)
        assertFalse(p.hasSpin)
        for (column in listOf(p.wx, p.wy, p.wz)) assertSame(SphereQuantity.NONE, column)
    }

    @Test
    fun `spins go with their spheres`() {
        val p = spun()
        p.retain { p.id[it] % 3 != 0 }
        p.drift(0.5)
        val copy = p.copy()
        p.wx[0] = 7.0
        for (k in 0 until copy.size) {
            assertEquals(0.1 * copy.id[k] - 1, copy.wx[k])
            assertEquals(0.3 * copy.id[k] - 1, copy.wz[k])
        }
    }

    @Test
    fun `the digest takes in spins after all it takes in without, in the order of ids`() {
        val p = spun()
        val bytes = ByteBuffer.allocate(9 * 8 * p.size)
        for (places in listOf(0..5, 8..10)) {
            for (k in p.indicesById()) for (place in places) bytes.putDouble(p.column(place)[k])
        }
        val sha = MessageDigest.getInstance("SHA-256").digest(bytes.array())
        assertEquals(HexFormat.of().formatHex(sha), stateDigest(p))
        assertEquals(stateDigest(p), stateDigest(spun(smooth.permuted(5))))
        assertNotEquals(stateDigest(smooth), stateDigest(p))
        val before = stateDigest(p)
        p.wz[3] = Math.nextUp(p.wz[3])
        assertNotEquals(before, stateDigest(p))
    }

    @Test
    fun `spheres that are added to spinning ones rest, and spinning ones are not added to smooth ones`() {
        fun others() = smooth.copy().also { p -> for (k in 0 until p.size) p.id[k] += 100 }.let {
            Population(it.x, it.y, it.z, it.vx, it.vy, it.vz, it.radius, it.mass, it.id)
        }
        val p = spun()
        p.add(others())
        assertEquals(40, p.size)
        assertEquals(0.0, p.wy[p.indexOf(107)])
        assertEquals(0.2 * 7 - 1, p.wy[p.indexOf(7)])
        assertThrows(IllegalArgumentException::class.java) { smooth.copy().add(spun(others())) }
    }

    @Test
    fun `a spin that is not finite is named, and so is a column of another length`() {
        val p = spun()
        p.wy[2] = Double.NaN
        assertEquals("omegay of particle ${p.id[2]} is NaN", p.firstNotFinite())
        val none = DoubleArray(20)
        val e = assertThrows(IllegalArgumentException::class.java) { smooth.withSpin(none, none, p.wy) }
        assertTrue("omegaz of particle ${p.id[2]} is NaN" in e.message!!) { e.message }
        assertThrows(IllegalArgumentException::class.java) { smooth.withSpin(none, none, DoubleArray(19)) }
    }

    @Test
    fun `a builder takes copies of spins`() {
        val w = doubleArrayOf(1.0, 2.0)
        val zero = DoubleArray(2)
        val p = Population.builder().positions(doubleArrayOf(0.0, 3.0), zero, zero).radius(1.0).mass(1.0)
            .spins(w, zero, zero).build()
        w[0] = 9.0
        assertArrayEquals(doubleArrayOf(1.0, 2.0), p.wx)
    }
}
