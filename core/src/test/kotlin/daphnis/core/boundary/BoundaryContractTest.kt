package daphnis.core.boundary

import daphnis.core.collision.StepRows
import daphnis.core.collision.contactTime
import daphnis.core.format.Snapshot
import daphnis.core.initial.SeededRandom
import daphnis.core.permuted
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource
import kotlin.math.abs

/** What every boundary owes to those who ask it: the search, the engines, the files, the analysis. */
class BoundaryContractTest {
    @ParameterizedTest
    @MethodSource("every")
    fun `a sphere that is put back is where its image was, with the velocity of the image`(case: Contracted) {
        for (time in TIMES) {
            val before = spheres(case, boxesAway = 3)
            val after = before.copy()
            case.conditions.endStep(after, time)
            val images = Images().apply { prepare(case.conditions, time) }
            for (k in 0 until before.size) {
                val code = imagePutInto(case, after, k, time)
                for (axis in 0..2) {
                    val place = before.position(axis)[k] + shift(case, images, code, axis)
                    assertEquals(place, after.position(axis)[k], rounding(case, axis)) {
                        "position of $k along ${"xyz"[axis]} at $time"
                    }
                    val speed = before.velocity(axis)[k] + slide(case, code, axis)
                    assertEquals(speed, after.velocity(axis)[k], 1e-12 * (abs(speed) + speedOfImages(case))) {
                        "velocity of $k along ${"xyz"[axis]} at $time"
                    }
                }
            }
        }
    }

    /** Boxes up from which the image comes that a sphere has become: against the way it went. */
    private fun imagePutInto(case: Contracted, after: Population, k: Int, time: Double): IntArray {
        val code = IntArray(3) { -after.boxesCrossed(after.id[k], it) }
        // Boxes along the slide count from where images stood at first: so many lengths have they slid since.
        val shear = case.conditions.shear ?: return code
        code[shear.slideAxis] += (code[shear.normalAxis] * shear.turns(time)).toInt()
        return code
    }

    /** The search's displacement where there are images to hit, else whole boxes. */
    private fun shift(case: Contracted, images: Images, code: IntArray, axis: Int): Double =
        if (case.conditions.hasImages(axis)) {
            images.shift(Images.code(code[0], code[1], code[2]), axis)
        } else if (code[axis] == 0) {
            0.0
        } else {
            code[axis] * case.conditions.box.length(axis)
        }

    private fun slide(case: Contracted, code: IntArray, axis: Int): Double {
        val flow = case.conditions.meanFlow
        if (flow == null || flow.flowAxis != axis || !case.conditions.repeats(flow.normalAxis)) return 0.0
        return code[flow.normalAxis] * flow.rate * case.conditions.box.length(flow.normalAxis)
    }

    @ParameterizedTest
    @MethodSource("every")
    fun `whatever is put back is inside, from anywhere and off any face, and counts`(case: Contracted) {
        for (time in TIMES) {
            val p = faces(case)
            case.conditions.endStep(p, time)
            for (axis in case.wrapped) {
                val box = case.conditions.box
                for (k in 0 until p.size) {
                    val v = p.position(axis)[k]
                    assertTrue(v >= box.lower(axis) && v < box.upper(axis)) { "$k at ${"xyz"[axis]} = $v at $time" }
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("every")
    fun `what is inside stays as it is, to the bit`(case: Contracted) {
        val box = case.conditions.box
        for (time in TIMES) {
            val p = faces(case)
            for (axis in 0..2) {
                for (k in 0 until p.size) {
                    if (p.position(axis)[k] in box.lower(axis)..<box.upper(axis)) continue
                    p.position(axis)[k] = if (k % 2 == 0) box.lower(axis) else Math.nextDown(box.upper(axis))
                }
            }
            val digest = stateDigest(p)
            case.conditions.endStep(p, time)
            assertEquals(digest, stateDigest(p))
            assertTrue(crossings(p).all { it == 0 }) { "crossings at $time" }
        }
    }

    @ParameterizedTest
    @MethodSource("every")
    fun `putting back twice is putting back once`(case: Contracted) {
        for (time in TIMES) {
            val p = faces(case)
            case.conditions.endStep(p, time)
            val digest = stateDigest(p)
            val crossed = crossings(p)
            case.conditions.endStep(p, time)
            assertEquals(digest, stateDigest(p))
            assertEquals(crossed, crossings(p))
        }
    }

    @ParameterizedTest
    @MethodSource("every")
    fun `axes that do not repeat are left alone`(case: Contracted) {
        val p = spheres(case, boxesAway = 5)
        val before = p.copy()
        case.conditions.endStep(p, 1.5)
        for (axis in (0..2) - case.wrapped.toSet()) {
            assertEquals(before.position(axis).toList(), p.position(axis).toList())
            assertEquals(before.velocity(axis).toList(), p.velocity(axis).toList())
        }
    }

    @ParameterizedTest
    @MethodSource("every")
    fun `position and boxes crossed add up over many steps`(case: Contracted) {
        val p = spheres(case, boxesAway = 0)
        val start = p.copy()
        val steps = 60
        val dt = 0.25
        for (step in 1..steps) {
            for (axis in 0..2) for (k in 0 until p.size) p.position(axis)[k] += p.velocity(axis)[k] * dt
            case.conditions.endStep(p, step * dt)
        }
        // Where images neither slide nor stand to be hit, the velocity jumps without a way along.
        if (case.conditions.meanFlow != null && case.wrapped.any { !case.conditions.hasImages(it) }) return
        val frame = Snapshot.of(p, case.conditions, steps.toLong(), steps * dt)
        val edges = frame.edges()
        for (k in 0 until p.size) {
            for (axis in 0..2) {
                val whole = frame.position[axis][k] +
                    (0..2).sumOf { row -> frame.image!![row][k].let { if (it == 0) 0.0 else it * edges[row][axis] } }
                val straight = start.position(axis)[k] + start.velocity(axis)[k] * steps * dt
                assertEquals(straight, whole, 100 * steps * rounding(case, axis)) { "$k along ${"xyz"[axis]}" }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("every")
    fun `the end of a step is the same for every order of the arrays and every division into parts`(case: Contracted) {
        for (time in TIMES) {
            val whole = spheres(case, boxesAway = 40)
            val permuted = whole.permuted(7)
            val parts = whole.copy()
            case.conditions.endStep(whole, time)
            case.conditions.endStep(permuted, time)
            assertEquals(stateDigest(whole), stateDigest(permuted))
            assertEquals(crossings(whole), crossings(permuted))
            val boundary = case.conditions as? PerSphereBoundary ?: continue
            val cuts = listOf(0, 1, 1, 5, parts.size / 2, parts.size)
            for ((from, to) in cuts.zipWithNext().reversed()) boundary.endStep(parts, time, from, to)
            assertEquals(stateDigest(whole), stateDigest(parts))
            assertEquals(crossings(whole), crossings(parts))
        }
    }

    @ParameterizedTest
    @MethodSource("every")
    fun `a contact through a face has the same bits from both sides`(case: Contracted) {
        val rows = StepRows()
        val images = Images()
        val reach = IntArray(3) { if (case.conditions.hasImages(it)) 2 else 0 }
        val along = reach.map { (-it..it).toList() }
        val codes = along[0].flatMap { x -> along[1].flatMap { y -> along[2].map { z -> Images.code(x, y, z) } } }
        for (time in TIMES) {
            val p = spheres(case, boxesAway = 0)
            rows.load(p, IntArray(p.size) { it }, 1.0, false)
            images.prepare(case.conditions, time)
            var contacts = 0
            for (code in codes) {
                for (a in 0 until PAIRED) {
                    for (b in 0 until PAIRED) {
                        val t = contactTime(rows, a, b, code, images)
                        val other = contactTime(rows, b, a, Images.negated(code), images)
                        assertEquals(t.toRawBits(), other.toRawBits()) { "$a and $b, image $code: $t, $other" }
                        if (t.isFinite()) contacts++
                    }
                }
            }
            assertTrue(contacts > 0) { "no contact at all" }
        }
    }

    @ParameterizedTest
    @MethodSource("every")
    fun `what goes with the mean flow goes with it after it was put back`(case: Contracted) {
        val flow = case.conditions.meanFlow ?: return
        for (time in TIMES) {
            val p = spheres(case, boxesAway = 4)
            for (k in 0 until p.size) p.velocity(flow.flowAxis)[k] = flow.rate * p.position(flow.normalAxis)[k]
            case.conditions.endStep(p, time)
            val rounding = abs(flow.rate) * rounding(case, flow.normalAxis)
            for (k in 0 until p.size) {
                val there = flow.rate * p.position(flow.normalAxis)[k]
                assertEquals(there, p.velocity(flow.flowAxis)[k], rounding) { "$k" }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("every")
    fun `what a boundary says of itself fits together`(case: Contracted) {
        val boundary = case.conditions
        for (axis in 0..2) {
            val faces = boundary.contactFaces(axis)
            assertEquals(faces == ContactFaces.PERIODIC, boundary.hasImages(axis))
            assertEquals(faces == ContactFaces.PERIODIC || faces == ContactFaces.WRAPPING, boundary.repeats(axis))
            assertTrue(faces == ContactFaces.OPEN || boundary.box.length(axis).isFinite())
        }
        assertTrue(boundary.walls.restitution in 0.0..1.0)
        val shear = boundary.shear ?: return
        val flow = boundary.meanFlow!!
        assertTrue(boundary.hasImages(shear.normalAxis) && boundary.hasImages(shear.slideAxis))
        assertEquals(listOf(flow.normalAxis, flow.flowAxis), listOf(shear.normalAxis, shear.slideAxis))
        assertEquals(flow.rate * boundary.box.length(flow.normalAxis), shear.velocity)
        for (time in TIMES) {
            val length = boundary.box.length(shear.slideAxis)
            assertTrue(shear.offset(time) >= 0 && shear.offset(time) < length) { "offset at $time" }
            val slid = shear.turns(time) * length + shear.offset(time)
            assertEquals(shear.velocity * time, slid, 1e-12 * (length + abs(slid)))
        }
    }

    @ParameterizedTest
    @MethodSource("every")
    fun `the nearest image is an image, and no further than half a box along any axis`(case: Contracted) {
        val boundary = case.conditions
        val random = SeededRandom(3)
        for (time in TIMES) {
            val images = Images().apply { prepare(boundary, time) }
            repeat(200) {
                val from = DoubleArray(3) { extent(case, it) * 3 * (random.nextDouble() - 0.5) }
                val d = from.copyOf()
                images.toNearest(d)
                val normal = images.normalAxis
                val rows = if (normal < 0) 0 else Math.rint((d[normal] - from[normal]) / images.period(normal)).toInt()
                for (axis in 0..2) {
                    val period = images.period(axis)
                    if (period == 0.0) {
                        assertEquals(from[axis], d[axis])
                        continue
                    }
                    assertTrue(abs(d[axis]) <= period / 2 * (1 + 1e-12)) { "${d[axis]} along ${"xyz"[axis]}" }
                    val leaning = if (axis == images.slideAxis) rows * images.shearOffset else 0.0
                    val boxes = (d[axis] - from[axis] - leaning) / period
                    assertEquals(Math.rint(boxes), boxes, 1e-11)
                }
            }
        }
    }

    private fun crossings(p: Population) = p.id.sorted().flatMap { id -> (0..2).map { p.boxesCrossed(id, it) } }

    companion object {
        private const val PAIRED = 24
        private val TIMES = listOf(0.0, 0.83, 3.0, 1234.5)

        @JvmStatic
        fun every(): List<Contracted> = everyBoundary()
    }
}
