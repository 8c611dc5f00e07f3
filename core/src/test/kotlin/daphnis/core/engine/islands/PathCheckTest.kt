package daphnis.core.engine.islands

import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.contactTime
import daphnis.core.initial.SeededRandom
import daphnis.core.populationOf
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Spheres 0 and 1, with radius 1, on paths of straight pieces in a window [0, 1]; 0 is the suspect. */
class PathCheckTest {
    /** A piece of path that begins at [time] at ([x], [y]) and goes on with velocity ([vx], [vy]). */
    private class Piece(val time: Double, val x: Double, val y: Double, val vx: Double, val vy: Double) {
        val row = DoubleArray(STRIDE).also {
            it[0] = x
            it[1] = y
            it[VX] = vx
            it[VX + 1] = vy
            it[TIME] = time
            it[RADIUS] = 1.0
        }
    }

    private val images = Images()
    private var image = 0

    /** Whether the check finds that the islands of the two paths touch; [other] may belong to no island. */
    private fun touch(
        own: List<Piece>,
        other: List<Piece>,
        isOtherFree: Boolean,
        boundary: BoundaryConditions,
    ): Boolean {
        val field = fieldOf(populationOf(*Array(2) { Sphere(x = 5.0 * it) }), boundary)
        images.prepare(boundary, 0.0)
        val slots = IntArray(2) { id -> (0..1).first { field.rows.id[it] == id } }
        val stores = List(2) { WorkerStores().apply { prepare(1.0, field.limits) } }
        for ((worker, path) in listOf(own, other).withIndex()) {
            val slot = slots[worker]
            path[0].row.copyInto(field.rows.state, slot * STRIDE)
            if (worker == 1 && isOtherFree) continue
            field.board.claim(slot, slot)
            val members = stores[worker].members
            val index = stores[worker].attempts.begin(0, 0, CollisionCounters())
            val k = members.take(field.rows, slot)
            field.board.take(slot, slot, field.board.attemptNumber(worker, index), k)
            for (piece in path.drop(1)) {
                members.leaveBehind(k)
                piece.row.copyInto(members.rows.state, k * STRIDE)
            }
        }
        stores[0].suspects.add(slots[0], slots[1], image, 0)
        val check = PathCheck(field, stores[0]) { stores[it].members }
        // Twice, since what the first leaves behind must not be seen by the second.
        repeat(2) { check.run() }
        assertTrue(check.count <= 1)
        if (check.count == 1) {
            assertEquals(slots[0], check.island(0))
            assertEquals(if (isOtherFree) -1 else slots[1], check.other(0))
        }
        return check.count == 1
    }

    /** The same in its plainest form: every new piece of the one with every piece of the other. */
    private fun touchPlainly(own: List<Piece>, other: List<Piece>): Boolean = (1 until own.size).any { i ->
        other.indices.any { j ->
            val end = minOf(own.getOrNull(i + 1)?.time ?: 1.0, other.getOrNull(j + 1)?.time ?: 1.0)
            contactTime(own[i].row, 0, other[j].row, 0, image, images) <= end
        }
    }

    private fun drawPath(random: SeededRandom): List<Piece> {
        fun speed() = (random.nextDouble() - 0.5) * 20
        fun time() = if (random.nextInt(3) == 0) random.nextInt(5) * 0.25 else random.nextDouble()
        val times = List(random.nextInt(6)) { time() }
        val path = arrayListOf(Piece(0.0, random.nextDouble() * 7, random.nextDouble() * 7, speed(), speed()))
        for (time in times.sorted()) {
            val last = path.last()
            val elapsed = time - last.time
            path += Piece(time, last.x + last.vx * elapsed, last.y + last.vy * elapsed, speed(), speed())
        }
        return path
    }

    @Test
    fun `paths drawn at random touch when pieces that are flown at the same time do`() {
        var touching = 0
        for (seed in 1L..3000L) {
            val random = SeededRandom(seed)
            val boundary = if (seed % 2 == 0L) Open else Periodic(Box.centred(40.0, 40.0, 40.0))
            image = if (seed % 4 == 1L) Images.code(-1, 0, 0) else 0
            val own = drawPath(random).map { Piece(it.time, it.x + if (image == 0) 0.0 else -40.0, it.y, it.vx, it.vy) }
            val isOtherFree = random.nextInt(4) == 0
            val other = drawPath(random).let { if (isOtherFree) it.take(1) else it }
            val isTouching = touch(own, other, isOtherFree, boundary)
            assertEquals(touchPlainly(own, other), isTouching) { "seed $seed" }
            if (isTouching) touching++
        }
        assertTrue(touching in 500..2500) { "$touching of 3000 touch: the draw is one-sided" }
    }

    private val still = listOf(Piece(0.0, 0.0, 0.0, 0.0, 0.0))

    private fun turnedAt(time: Double, vx: Double) =
        listOf(Piece(0.0, 5.0, 0.0, 0.0, 0.0), Piece(time, 5.0, 0.0, vx, 0.0))

    @Test
    fun `a sphere that turns toward one of no island touches it, or just misses`() {
        assertTrue(touch(turnedAt(0.5, -6.0), still, true, Open))
        assertEquals(false, touch(turnedAt(0.5, -5.999), still, true, Open))
    }

    @Test
    fun `a piece is compared only with those flown at the same time`() {
        // 0 comes to where 1 stood, after 1 has left; and to where 1 will stand.
        val left = listOf(Piece(0.0, 0.0, 0.0, 0.0, 0.0), Piece(0.4, 0.0, 0.0, 0.0, 100.0))
        assertEquals(false, touch(turnedAt(0.5, -10.0), left, false, Open))
        val comes = listOf(Piece(0.0, 0.0, 80.0, 0.0, -100.0), Piece(0.8, 0.0, 0.0, 0.0, 0.0))
        assertTrue(touch(turnedAt(0.5, -6.0), comes, false, Open))
    }

    @Test
    fun `an attempt that was dropped has no suspects any more`() {
        val field = fieldOf(populationOf(Sphere(), Sphere(x = 5.0)))
        val stores = WorkerStores().apply { prepare(1.0, field.limits) }
        stores.attempts.begin(0, 0, CollisionCounters())
        stores.suspects.add(0, 1, 0, 0)
        stores.attempts.drop(0)
        val check = PathCheck(field, stores) { stores.members }
        check.run()
        assertEquals(0, check.count)
    }
}
