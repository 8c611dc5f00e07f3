package daphnis.app

import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.Images
import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.StepRows
import daphnis.core.collision.WallContact
import daphnis.core.collision.contactTime
import daphnis.core.engine.CollisionEngine
import daphnis.core.population.Population
import daphnis.core.queue.BucketEventQueue
import daphnis.core.step.CollisionStep
import kotlin.math.abs
import kotlin.math.ceil

/**
 * Asks every pair and every image after every collision: no grid, no bound, nothing that could miss a contact. The
 * oracle of core's own tests does the same; this one is for drawn cases, and says which it is for.
 */
class EveryPairEngine : CollisionEngine {
    override val name get() = "every-pair"
    override val threads get() = 1

    private val rows = StepRows()
    private val images = Images()
    private val walls = WallContact()
    private val queue = BucketEventQueue()
    private var codes = IntArray(0)
    private val outcome = CollisionOutcome()

    /** Whether [population] moves over few enough images of [case] to ask them all. */
    fun canDo(case: Case, population: Population, dt: Double): Boolean =
        population.size <= MOST_SPHERES && (0..2).all { boxes(case, population, dt, it) <= MOST_BOXES }

    private fun boxes(case: Case, p: Population, dt: Double, axis: Int): Int {
        if (case.boundary.contactFaces(axis) != ContactFaces.PERIODIC) return 0
        val fastest = (0 until p.size).maxOf { maxOf(abs(p.vx[it]), abs(p.vy[it]), abs(p.vz[it])) }
        val length = case.boundary.box.length(axis)
        val slide =
            case.boundary.shear?.let { if (it.slideAxis == axis) 2 + abs(it.velocity) * dt * 4 / length else 0.0 }
                ?: 0.0
        // Twice as far as the fastest could come.
        return 1 + ceil((2 * p.radius.max() + 4 * fastest * dt) / length + slide).toInt()
    }

    /** For steps of [dt] from [population] as it stands. */
    fun prepare(case: Case, population: Population, dt: Double) {
        val far = IntArray(3) { boxes(case, population, dt, it) }
        codes = buildList {
            for (x in -far[0]..far[0]) for (y in -far[1]..far[1]) for (z in -far[2]..far[2]) add(Images.code(x, y, z))
        }.toIntArray()
    }

    override fun advance(step: CollisionStep) {
        val n = step.population.size
        step.record?.clear()
        rows.load(step.population, IntArray(n) { it }, step.duration, step.law.guard.needsLastCollision)
        images.prepare(step.boundary, step.start)
        walls.prepare(step.boundary)
        queue.reset(step.duration, rows.id, n)
        for (a in 0 until n) search(step, a) { it > a }
        while (queue.pop()) collide(step, queue.first, queue.second, queue.time)
        rows.store(step.population, step.duration)
        step.record?.sort()
    }

    private fun collide(step: CollisionStep, a: Int, b: Int, time: Double) {
        queue.removeAllOf(a)
        if (b < 0) {
            walls.reflect(rows, a, WallContact.face(b), time)
            step.counters.wallCollisions++
        } else {
            queue.removeAllOf(b)
            if (step.law.collide(rows, a, b, queue.image, images, time, outcome)) {
                step.counters.collisions++
                if (outcome.guarded) step.counters.guardActivations++
                step.record?.add(time, rows.id[a], rows.id[b], outcome)
            }
            search(step, b) { it != a && it != b }
        }
        search(step, a) { it != a }
    }

    private inline fun search(step: CollisionStep, a: Int, isAsked: (Int) -> Boolean) {
        for (c in 0 until rows.size) {
            if (!isAsked(c)) continue
            for (code in codes) {
                val t = contactTime(rows, a, c, code, images)
                if (t <= step.duration) queue.add(t, a, c, code)
            }
        }
        for (face in 0 until WallContact.FACES) {
            val t = walls.time(rows, a, face)
            if (t <= step.duration) queue.add(t, a, WallContact.partner(face), 0)
        }
    }

    private companion object {
        const val MOST_SPHERES = 40
        const val MOST_BOXES = 20
    }
}
