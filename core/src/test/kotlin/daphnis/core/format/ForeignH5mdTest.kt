package daphnis.core.format

import io.jhdf.HdfFile
import io.jhdf.api.WritableGroup
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

/** H5MD as other programs write it, which have no radii and no offset of sliding images. */
class ForeignH5mdTest {
    @TempDir
    lateinit var home: Path

    private val places = arrayOf(
        arrayOf(doubleArrayOf(1.0, 2.0, -1.0), doubleArrayOf(9.0, 3.0, 1.0)),
        arrayOf(doubleArrayOf(8.0, 2.5, 1.0), doubleArrayOf(1.5, 2.0, -1.0)),
    )

    /** Two particles in two frames, in a group [name]; [more] adds to it. */
    private fun write(
        name: String = "atoms",
        steps: Any = longArrayOf(10, 20),
        more: (WritableGroup) -> Unit = {},
    ): Path {
        val path = home.resolve("foreign.h5")
        HdfFile.write(path).use { file ->
            val group = file.putGroup("particles").putGroup(name)
            val box = group.putGroup("box")
            box.putAttribute("dimension", 3)
            box.putAttribute("boundary", arrayOf("periodic", "periodic", "none"))
            box.putDataset("edges", doubleArrayOf(10.0, 8.0, 6.0))
            val position = group.putGroup("position")
            val step = position.putDataset("step", steps)
            if (steps !is LongArray) {
                step.putAttribute("offset", 5L)
                position.putDataset("time", 0.25).putAttribute("offset", 1.5)
            }
            position.putDataset("value", places)
            more(group)
        }
        return path
    }

    private fun steps() = longArrayOf(10, 20)

    private fun refused(path: Path, vararg words: String) {
        val e = assertThrows(FormatException::class.java) { H5md.read(path) }
        for (word in words) assertTrue(word in e.message.orEmpty()) { "'$word' is not in ${e.message}" }
    }

    @Test
    fun `the only group is read, with a box that is the same for all frames and begins at the origin`() {
        val (first, second) = H5md.read(write())
        assertEquals(listOf(10L to 10.0, 20L to 20.0), listOf(first, second).map { it.step to it.time })
        assertEquals(listOf(10.0, 8.0, 6.0), first.lengths.asList())
        assertEquals(listOf(true, true, false), first.periodic.asList())
        assertEquals(listOf(-4.0, 4.0), first.position[0].asList())
        // Along y all are in the lower half, and along z one is below 0: the box may be centred already.
        assertEquals(listOf(2.0, 3.0), first.position[1].asList())
        assertEquals(listOf(-1.0, 1.0), first.position[2].asList())
        assertEquals(listOf(0, 1), first.id.asList())
        assertEquals(listOf(0.0, 0.0), second.velocity[0].asList())
        assertFalse(first.hasMass || first.hasRadius)
    }

    @Test
    fun `ids and masses by frame, particles in the order of ids`() {
        val path = write { group ->
            group.putGroup("id").putDataset("value", arrayOf(intArrayOf(5, 2), intArrayOf(2, 5)))
            group.putGroup("mass").putDataset("value", arrayOf(doubleArrayOf(1.5, 3.0), doubleArrayOf(3.0, 1.5)))
            group.putDataset("radius", doubleArrayOf(0.25, 0.75))
        }
        val (first, second) = H5md.read(path)
        assertEquals(listOf(2, 5), first.id.asList())
        assertEquals(listOf(4.0, -4.0), first.position[0].asList())
        assertEquals(listOf(3.0, -3.5), second.position[0].asList())
        assertEquals(listOf(3.0, 1.5), first.mass.asList())
        assertEquals(listOf(3.0, 1.5), second.mass.asList())
        assertEquals(listOf(0.75, 0.25), first.radius.asList())
        assertTrue(first.hasMass && first.hasRadius)
    }

    /** A frame for each [x], where one of 40 particles is, in a cubic box of edge 10 with [edges]. */
    private fun box(x: DoubleArray, face: String = "periodic", edges: (WritableGroup) -> Unit): Path {
        val path = home.resolve("box.h5")
        HdfFile.write(path).use { file ->
            val group = file.putGroup("particles").putGroup("atoms")
            val box = group.putGroup("box")
            box.putAttribute("boundary", arrayOf(face, "periodic", face))
            edges(box)
            val position = group.putGroup("position")
            position.putDataset("step", LongArray(x.size) { 10L * it })
            val rows = Array(x.size) { t -> Array(40) { k -> DoubleArray(3) { if (k == 0) x[t] else 0.25 * k } } }
            position.putDataset("value", rows)
            group.putDataset("charge", DoubleArray(40))
        }
        return path
    }

    private fun upright(box: WritableGroup) {
        box.putDataset("edges", doubleArrayOf(10.0, 10.0, 10.0))
    }

    @Test
    fun `a box from 0 is known with a particle a hair outside, and with places that go on beyond it`() {
        for (x in listOf(doubleArrayOf(10.01, 10.01), doubleArrayOf(5.0, 27.0), doubleArrayOf(-0.01, -33.0))) {
            val states = H5md.read(box(x, edges = ::upright))
            assertEquals(x.map { it - 5 }, states.map { it.position[0][0] })
            assertEquals(listOf(5.0, 5.0, 5.0), states[1].shift.asList())
            assertFalse(states[0].hasTime)
        }
    }

    @Test
    fun `a box from 0 is known along axes that do not repeat, too`() {
        val states = H5md.read(box(doubleArrayOf(5.0, 9.0), "none", ::upright))
        assertEquals(listOf(false, true, false), states[1].periodic.asList())
        assertEquals(listOf(0.0, 4.0), states.map { it.position[0][0] })
        assertTrue((0..2).all { axis -> states[0].position[axis].all { it in -5.0..5.0 } })
        assertEquals(listOf(5.0, 5.0, 5.0), states[1].shift.asList())
    }

    @Test
    fun `edges are those of each frame, lengths or vectors, and may be stored at steps of their own`() {
        val vectors = Array(2) { t -> Array(3) { a -> DoubleArray(3) { if (a == it) 10.0 + t else 0.0 } } }
        vectors[1][1][0] = 2.5
        fun edges(steps: LongArray, value: Any) = box(doubleArrayOf(5.0, 5.0)) { group ->
            val own = group.putGroup("edges")
            own.putDataset("step", steps)
            own.putDataset("value", value)
        }
        val (first, second) = H5md.read(edges(longArrayOf(0, 10), vectors))
        assertEquals(10.0 to 0.0, first.lengths[0] to first.shearOffset)
        assertEquals(11.0 to 2.5, second.lengths[0] to second.shearOffset)
        assertEquals(1 to 0, second.normalAxis to second.slideAxis)
        val lengths = Array(3) { t -> DoubleArray(3) { 10.0 + t } }
        val others = H5md.read(edges(longArrayOf(10, 5, 0), lengths))
        assertEquals(listOf(12.0, 10.0), others.map { it.lengths[2] })
        refused(edges(longArrayOf(0, 5, 20), lengths), "no edges for step 10", "frame 1")
        vectors[1][2][0] = 1.0
        refused(edges(longArrayOf(0, 10), vectors), "frame 1", "leans")
        val notices = ArrayList<String>()
        H5md.read(box(doubleArrayOf(5.0), edges = ::upright), notices)
        assertTrue(notices.single().endsWith("atoms/charge is not used")) { "$notices" }
    }

    @Test
    fun `steps and times in fixed intervals`() {
        val (first, second) = H5md.read(write(steps = 10L))
        assertEquals(listOf(5L to 1.5, 15L to 1.75), listOf(first, second).map { it.step to it.time })
    }

    @Test
    fun `what is missing or of another shape is refused by its name`() {
        refused(write(steps = longArrayOf(1, 2, 3)), "atoms/position/value", "[2, 2, 3]")
        refused(write { it.putDataset("mass", doubleArrayOf(1.0)) }, "atoms/mass", "[1]", "[2]")
        refused(write { it.putDataset("id", intArrayOf(3, 3)) }, "id 3 occurs twice")
        refused(write { it.putDataset("id", intArrayOf(-1, 3)) }, "atoms/id", "-1")
        refused(write { it.putDataset("mass", doubleArrayOf(-1.0, 1.0)) }, "mass of particle 0")
        refused(write { it.putGroup("velocity").putDataset("step", steps()) }, "atoms/velocity/value is missing")
    }

    @Test
    fun `of several groups one must be the usual one`() {
        val path = home.resolve("two.h5")
        HdfFile.write(path).use { file ->
            val particles = file.putGroup("particles")
            particles.putGroup("grains")
            particles.putGroup("dust")
        }
        refused(path, "dust, grains", "all")
    }
}
