package daphnis.core.engine

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.prepare
import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.StepRows
import daphnis.core.population.Population
import daphnis.core.queue.ReferenceEventQueue
import daphnis.core.space.Images
import daphnis.core.step.CollisionStep
import daphnis.core.wall.WallContact
import kotlin.math.abs
import kotlin.math.ceil

/**
 * The slow oracle: the serial engine without grid, bound or fast queue. Every pair and every image that could possibly
 * matter is asked after every collision, so nothing can be missed.
 *
 * An [isQuick] case takes milliseconds.
 */
class BruteForceEngine : CollisionEngine {
    override val name get() = "brute-force"
    override val threads get() = 1

    private val rows = StepRows()
    private val images = Images()
    private val walls = WallContact()
    private val queue = ReferenceEventQueue()
    private var codes = IntArray(0)
    private val outcome = CollisionOutcome()

    override fun advance(step: CollisionStep) {
        val n = step.population.size
        step.record?.clear()
        rows.load(step.population, IntArray(n) { it }, step.duration, step.law.guard.needsLastCollision)
        images.prepare(step.boundary, step.start)
        walls.prepare(step.boundary.walls, step.law, step.start, step.duration)
        codes = imageCodes(step.population, step.boundary, step.duration)
        queue.reset(step.duration, rows.id, n)
        for (a in 0 until n) {
            for (b in a + 1 until n) codes.forEach { queue(step, a, b, it) }
            queueWalls(step, a)
        }
        while (queue.pop()) {
            val time = queue.time
            val a = queue.first
            val b = queue.second
            queue.removeAllOf(a)
            if (b < 0) {
                walls.reflect(rows, a, WallContact.number(b), time, outcome)
                step.counters.wallCollisions++
                if (walls.areDriven) step.record?.add(time, b, rows.id[a], outcome)
            } else {
                queue.removeAllOf(b)
                if (step.law.collide(rows, a, b, queue.image, images, time, outcome)) {
                    if (outcome.isEdge) step.counters.edgeEvents++ else step.counters.collisions++
                    if (outcome.isMerger) step.counters.mergers++
                    if (outcome.guarded) step.counters.guardActivations++
                    step.record?.add(time, rows, a, b, outcome)
                }
                for (c in 0 until n) if (c != a && c != b) codes.forEach { queue(step, b, c, it) }
                queueWalls(step, b)
            }
            for (c in 0 until n) if (c != a) codes.forEach { queue(step, a, c, it) }
            queueWalls(step, a)
        }
        rows.store(step.population, step.duration)
        step.record?.sort()
    }

    private fun queue(step: CollisionStep, a: Int, b: Int, code: Int) {
        val t = step.law.meetingTime(rows, a, b, code, images)
        if (t <= step.duration) queue.add(t, a, b, code)
    }

    private fun queueWalls(step: CollisionStep, a: Int) {
        for (face in 0 until WallContact.FACES + step.boundary.walls.surfaces.size) {
            val t = walls.time(rows, a, face)
            if (t <= step.duration) queue.add(t, a, WallContact.partner(face), 0)
        }
    }

    private fun imageCodes(p: Population, boundary: BoundaryConditions, dt: Double): IntArray {
        val far = IntArray(3) { boxes(p, boundary, dt, it) }
        return buildList {
            for (x in -far[0]..far[0]) for (y in -far[1]..far[1]) for (z in -far[2]..far[2]) add(Images.code(x, y, z))
        }.toIntArray()
    }

    companion object {
        private const val MOST_SPHERES = 40
        private const val MOST_BOXES = 20

        /** Whether [p] has few enough spheres and images within a step of [dt] to ask them all. */
        fun isQuick(p: Population, boundary: BoundaryConditions, dt: Double): Boolean =
            p.size <= MOST_SPHERES && (0..2).all { boxes(p, boundary, dt, it) <= MOST_BOXES }

        /** How many boxes away on each side of [axis]: twice as far as the fastest could come. */
        private fun boxes(p: Population, boundary: BoundaryConditions, dt: Double, axis: Int): Int {
            if (boundary.contactFaces(axis) != ContactFaces.PERIODIC) return 0
            var fastest = 0.0
            var largest = 0.0
            for (k in 0 until p.size) {
                fastest = maxOf(fastest, abs(p.vx[k]), maxOf(abs(p.vy[k]), abs(p.vz[k])))
                largest = maxOf(largest, p.radius[k])
            }
            val across = boundary.shear?.takeIf { it.normalAxis == axis }?.velocityAcross ?: 0.0
            val nearer = minOf(0.9, abs(across) * dt / boundary.box.length(axis))
            val range = (2 * largest + 4 * fastest * dt) / (1 - nearer)
            val length = boundary.box.length(axis)
            val shear = boundary.shear
            val slides = shear != null && shear.slideAxis == axis
            val slide = if (slides) 2 + abs(shear.velocity) * dt * 4 / length else 0.0
            return 1 + ceil(range / length + slide).toInt()
        }
    }
}
