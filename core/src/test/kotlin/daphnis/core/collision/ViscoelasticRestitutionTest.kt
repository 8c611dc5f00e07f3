package daphnis.core.collision

import daphnis.core.Sphere
import daphnis.core.boundary.Open
import daphnis.core.boundary.prepare
import daphnis.core.populationOf
import daphnis.core.space.Images
import daphnis.core.surface.SurfaceContact
import daphnis.core.surface.ViscoelasticRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.pow
import kotlin.math.sqrt

class ViscoelasticRestitutionTest {
    /** The contact of viscoelastic spheres, integrated until their force vanishes. */
    private class Contact(stiffness: Double, private val viscosity: Double, r: Double, private val m: Double) {
        private val rho = stiffness * sqrt(r)

        private fun acceleration(x: Double, v: Double) =
            if (x <= 0) 0.0 else -rho / m * (x * sqrt(x) + 1.5 * viscosity * sqrt(x) * v)

        fun restitution(speed: Double): Double {
            val dissipation = 1.5 * viscosity * (rho / m).pow(0.4) * speed.pow(0.2)
            // An elastic contact lasts 3.2 of this.
            val h = (m / rho).pow(0.4) * speed.pow(-0.2) * (1 + dissipation) / STEPS
            var x = 0.0
            var v = speed
            while (true) {
                val a1 = acceleration(x, v)
                val v2 = v + h / 2 * a1
                val a2 = acceleration(x + h / 2 * v, v2)
                val v3 = v + h / 2 * a2
                val a3 = acceleration(x + h / 2 * v2, v3)
                val v4 = v + h * a3
                val a4 = acceleration(x + h * v3, v4)
                x += h / 6 * (v + 2 * v2 + 2 * v3 + v4)
                v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
                if (v < 0 && acceleration(x, v) >= 0) return -v / speed
            }
        }
    }

    private fun ViscoelasticRestitution.of(v: Double, r: Double = 1.0, m: Double = 1.0) =
        restitution(SurfaceContact.headOn(v, r, m))

    @Test
    fun `the coefficient is that of the contact's equation as closely as is said, at all speeds`() {
        val contact = Contact(3.0, 0.004, r = 0.5, m = 0.5)
        val law = ViscoelasticRestitution(contact.restitution(1.0), 1.0, 1.0, 1.0)
        assertTrue(law.coefficient in 0.98..0.999) { "${law.coefficient}" }
        var least = 1.0
        var most = 0.0
        for (power in -8..56) {
            val v = 10.0.pow(power / 4.0)
            val e = contact.restitution(v)
            val error = law.of(v) - e
            val bound = if (e >= 0.8) {
                3e-4
            } else if (e >= 0.5) {
                0.0032
            } else {
                0.009
            }
            assertTrue(error > -2e-6 && error < bound) { "at $v: $e, error $error" }
            least = minOf(least, e)
            most = maxOf(most, error)
        }
        assertTrue(least < 0.1 && most > 0.008) { "$least, $most" }
    }

    @Test
    fun `spheres of other sizes and masses have the coefficient of their own contact`() {
        val (stiffness, viscosity) = 7.0 to 0.02
        fun contact(r1: Double, m1: Double, r2: Double, m2: Double) =
            Contact(stiffness, viscosity, r1 * r2 / (r1 + r2), m1 * m2 / (m1 + m2))
        val (r, m) = 2.0 to 5.0
        val law = ViscoelasticRestitution(contact(r, m, r, m).restitution(0.3), 0.6, r, m, cmPerSecond = 2.0)
        val images = Images().apply { prepare(Open, 0.0) }
        val outcome = CollisionOutcome()
        val seen = ArrayList<Double>()
        for ((r1, m1) in listOf(2.0 to 5.0, 0.3 to 5.0, 2.0 to 0.7, 0.01 to 1e-2)) {
            for ((r2, m2) in listOf(2.0 to 5.0, 9.0 to 40.0)) {
                val p = populationOf(Sphere(vx = 0.5, r = r1, m = m1), Sphere(x = r1 + r2, r = r2, m = m2))
                val rows = StepRows().apply { load(p, intArrayOf(0, 1), 1.0, false) }
                assertTrue(CollisionLaw(law).collide(rows, 0, 1, 0, images, 0.0, outcome))
                val e = contact(r1, m1, r2, m2).restitution(0.5)
                assertEquals(e, outcome.coefficient, if (e >= 0.8) 3e-4 else 0.0035) { "$r1, $m1 and $r2, $m2" }
                seen += e
            }
        }
        assertTrue(seen.max() - seen.min() > 0.1) { "$seen" }
    }

    @Test
    fun `the given coefficient is that of two such spheres, and large ones of one density are more elastic`() {
        for (coefficient in listOf(1e-3, 0.2, 0.9, 1.0 - 1e-9, 1.0)) {
            val law = ViscoelasticRestitution(coefficient, 30.0, 0.7, 1.3, cmPerSecond = 10.0)
            assertEquals(coefficient, law.of(3.0, 0.7, 1.3), 1e-14)
        }
        val law = ViscoelasticRestitution(0.9, 1.0, 1.0, 1.0)
        // s goes with v^(1/5) and 1/R: a sphere twice as large at 32 times the speed is the same.
        assertEquals(0.9, law.of(32.0, 2.0, 8.0), 1e-14)
        assertEquals(1.0, law.of(0.0))
        assertTrue(abs(law.of(1e-30) - 1) < 1e-6)
        assertEquals(0.0, ViscoelasticRestitution(0.9, 1e-300, 1.0, 1e200).of(1e300, 1.0, 1e-100), 1e-60)
    }

    @Test
    fun `what makes no law is refused with its number`() {
        val infinity = Double.POSITIVE_INFINITY
        val wrong = listOf<Pair<String, () -> Any>>(
            "coefficient of restitution is 0.0; it must be in (0, 1]" to {
                ViscoelasticRestitution(0.0, 1.0, 1.0, 1.0)
            },
            "coefficient of restitution is 1.5" to { ViscoelasticRestitution(1.5, 1.0, 1.0, 1.0) },
            "its speed is 0.0 cm/s; it must be > 0" to { ViscoelasticRestitution(0.5, 0.0, 1.0, 1.0) },
            "its speed is Infinity" to { ViscoelasticRestitution(0.5, infinity, 1.0, 1.0) },
            "its radius is -1.0; it must be > 0" to { ViscoelasticRestitution(0.5, 1.0, -1.0, 1.0) },
            "its radius is Infinity" to { ViscoelasticRestitution(0.5, 1.0, infinity, 1.0) },
            "its mass is NaN; it must be > 0" to { ViscoelasticRestitution(0.5, 1.0, 1.0, Double.NaN) },
            "its mass is Infinity" to { ViscoelasticRestitution(0.5, 1.0, 1.0, infinity) },
            "one unit of speed is 0.0 cm/s" to { ViscoelasticRestitution(0.5, 1.0, 1.0, 1.0, 0.0) },
        )
        for ((says, make) in wrong) {
            val e = assertThrows(IllegalArgumentException::class.java, { make() }, says)
            assertTrue(e.message!!.startsWith(says)) { "${e.message} is not: $says" }
        }
    }

    private companion object {
        const val STEPS = 2000
    }
}
