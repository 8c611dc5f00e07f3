package daphnis.core.cluster

import daphnis.core.Sphere
import daphnis.core.boundary.Open
import daphnis.core.cluster.bricks.BrickSpheres
import daphnis.core.cluster.bricks.IndexRuns
import daphnis.core.cluster.bricks.OwnPaths
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Test

/** Spins between nodes. */
class SpinMessagesTest {
    private val smooth = populationOf(Sphere(x = -2.0, vx = 1.0), Sphere(x = 2.0), Sphere(x = 9.0))
    private val spun = smooth.withSpin(DoubleArray(3) { 1.0 + it }, DoubleArray(3), DoubleArray(3))

    @Test
    fun `a node that gets no sphere at the start knows whether there are spins`() {
        for (p in listOf(smooth, spun)) {
            for (until in listOf(0, 2)) {
                val room = MailRoom(1)
                SpheresWire.send(room.mail(Mail.LEADER), 0, p, 0, until)
                val part = Population(SpheresWire.receive(room.mail(0), Mail.LEADER), emptyList())
                assertEquals(until, part.size)
                assertEquals(p.hasSpin, part.hasSpin)
                if (p.hasSpin && until > 0) assertEquals(2.0, part.wx[1])
                assertEquals(0, room.unread())
            }
        }
    }

    @Test
    fun `two computations of a path differ when they differ in a spin, at the start or after an impact`() {
        val step = CollisionStep(spun, Open, CollisionLaw(ConstantRestitution(1.0)), CollisionCounters())
        step.duration = 1.0
        val prepared = PreparedStep().also {
            it.measure(step)
            it.prepare()
        }
        val rows = prepared.rows
        fun hash(change: (Population) -> Unit = {}): Long {
            val spheres = BrickSpheres()
            spheres.begin(3)
            spheres.add(spun.copy().also(change), IndexRuns().also { runs -> for (k in 0..2) runs.add(k) }, true)
            spheres.settle()
            val paths = OwnPaths(prepared, spheres)
            paths.begin()
            paths.changed(rows, 0, 1, 0.5)
            return paths.whole(rows.origin[0])
        }
        val usual = hash()
        assertEquals(usual, hash())
        assertNotEquals(usual, hash { p -> p.wz[rows.origin[0]] = 1e-300 })
        for (spins in listOf(rows.wx, rows.wy, rows.wz)) {
            val before = spins[0]
            spins[0] = Math.nextUp(before)
            assertNotEquals(usual, hash())
            spins[0] = before
        }
        assertEquals(usual, hash())
    }
}
