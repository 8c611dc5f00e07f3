package daphnis.core.format

import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.randomSpheres
import io.jhdf.HdfFile
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path

class H5mdChecksumTest {
    @TempDir
    lateinit var home: Path

    private val boundary = LeesEdwards(Box.centred(12.0, 11.0, 10.0), 0.5)
    private val frame = Snapshot.of(randomSpheres(40, boundary, 8, 1.0) { it.nextDouble(0.2, 0.6) }, boundary, 5, 1.25)

    private fun changed(
        step: Long = frame.step,
        time: Double = frame.time,
        lengths: DoubleArray = frame.lengths,
        periodic: BooleanArray = frame.periodic,
        offset: Double = frame.shearOffset,
        id: IntArray = frame.id,
        position: Array<DoubleArray> = frame.position,
        velocity: Array<DoubleArray> = frame.velocity,
        radius: DoubleArray = frame.radius,
        mass: DoubleArray = frame.mass,
        axes: IntArray = intArrayOf(frame.normalAxis, frame.slideAxis),
        image: Array<IntArray>? = frame.image,
    ): Snapshot {
        val (normal, slide) = axes
        return Snapshot(
            step, time, lengths, periodic, offset, id, position, velocity, radius, mass, normal, slide, image = image,
        )
    }

    private fun DoubleArray.next(k: Int) = copyOf().also { it[k] = Math.nextUp(it[k]) }

    private fun Array<DoubleArray>.next(axis: Int, k: Int) = Array(3) { if (it == axis) this[it].next(k) else this[it] }

    @Test
    fun `every property counts, to the last bit`() {
        val image = checkNotNull(frame.image)
        val others = listOf(
            changed(step = 6), changed(time = Math.nextUp(1.25)), changed(lengths = frame.lengths.next(2)),
            changed(periodic = booleanArrayOf(true, true, !frame.periodic[2])),
            changed(offset = Math.nextUp(frame.shearOffset)),
            changed(id = frame.id.copyOf().also { it[39] = 99 }), changed(position = frame.position.next(2, 39)),
            changed(velocity = frame.velocity.next(0, 0)),
            changed(radius = frame.radius.next(7)), changed(mass = frame.mass.next(39)),
            changed(axes = intArrayOf(2, 0)), changed(axes = intArrayOf(1, 2)), changed(image = null),
            changed(image = Array(3) { axis -> image[axis].copyOf().also { it[39] += axis / 2 } }),
            changed(lengths = DoubleArray(3) { Double.NaN }),
        )
        val sums =
            others.map { H5mdChecksum.of(listOf(it)) } + H5mdChecksum.of(listOf(frame)) +
                H5mdChecksum.of(listOf(frame, frame))
        assertEquals(sums.size, sums.toSet().size)
        assertNotEquals(
            H5mdChecksum.of(listOf(frame, changed(step = 6))),
            H5mdChecksum.of(listOf(changed(step = 6), frame)),
        )
    }

    @Test
    fun `a flipped bit of a radius, an id, a mass, an edge or the time is noticed`() {
        val file = home.resolve("a.h5")
        H5md.write(listOf(frame), file, "test")
        val good = Files.readAllBytes(file)
        val values = listOf(frame.radius[7], frame.mass[7], frame.time, frame.lengths[1], frame.shearOffset)
        for (value in values) {
            // The time is there once for each quantity, of which one is read.
            val part = ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN).putDouble(value).array()
            val places = placesOf(good, part)
            assertTrue(places.isNotEmpty())
            Files.write(file, good.copyOf().also { for (at in places) it[at] = (it[at].toInt() xor 1).toByte() })
            val e = assertThrows(FormatException::class.java, { H5md.read(file) }) { "$value" }
            assertTrue("a.h5: is damaged" in e.message.orEmpty()) { e.message }
        }
    }

    @Test
    fun `a file without a checksum is read as it is`() {
        val file = home.resolve("old.h5")
        fun rows(columns: Array<DoubleArray>) =
            Array(1) { Array(frame.size) { k -> DoubleArray(3) { columns[it][k] } } }
        HdfFile.write(file).use { h5 ->
            val all = h5.putGroup("particles").putGroup("all")
            all.putGroup("box").putAttribute("boundary", Array(3) { "none" })
            all.putGroup("velocity").putDataset("value", rows(frame.velocity))
            val position = all.putGroup("position")
            position.putDataset("step", longArrayOf(5))
            position.putDataset("time", doubleArrayOf(1.25))
            position.putDataset("value", rows(frame.position))
            all.putDataset("id", frame.id)
            all.putDataset("mass", frame.mass)
            all.putDataset("radius", frame.radius)
            h5.putGroup("parameters").putDataset("shear_offset", doubleArrayOf(0.0))
        }
        val read = H5md.read(file).single()
        assertArrayEquals(frame.radius, read.radius)
        assertArrayEquals(frame.velocity[2], read.velocity[2])
    }

    private fun placesOf(bytes: ByteArray, part: ByteArray): List<Int> = (0..bytes.size - part.size).filter { at ->
        part.indices.all { bytes[at + it] == part[it] }
    }
}
