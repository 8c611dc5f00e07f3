package daphnis.core.format

import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.randomSpheres
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.IOException
import java.lang.ref.WeakReference
import java.nio.channels.ClosedByInterruptException
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.CRC32C
import kotlin.io.path.listDirectoryEntries

/** A trajectory in one file, written state by state. */
class H5mdStreamTest {
    @TempDir
    lateinit var home: Path

    private val boundary = LeesEdwards(Box.centred(12.0, 11.0, 10.0), 0.5)
    private val population = randomSpheres(40, boundary, 8, 1.0) { it.nextDouble(0.2, 0.6) }

    /** The spheres after [t] steps, at other places each time. */
    private fun state(t: Int): Snapshot {
        val start = Snapshot.of(population, boundary, 10L * t, 0.125 * t)
        val moved = Array(3) { axis -> DoubleArray(start.size) { start.position[axis][it] + 1e-3 * t * axis } }
        val image = Array(3) { axis -> IntArray(start.size) { t * axis - it } }
        return Snapshot(
            start.step, start.time, start.lengths, start.periodic, start.shearOffset, start.id,
            moved, start.velocity, start.radius, start.mass, image = image,
        )
    }

    private fun export(states: Sequence<Snapshot>): Path = H5md.export(states, home, ExportOptions("test")).path

    @Test
    fun `states come back to the bit, at every number of them`() {
        for (count in listOf(1, 819, 820, 2049)) {
            val read = H5md.read(export(generateSequence(0) { it + 1 }.map(::state).take(count)))
            assertEquals(count, read.size)
            for (t in setOf(0, 1, 818, 819, 1023, 1024, count - 1).filter { it < count }) {
                val expected = state(t)
                val seen = read[t]
                assertEquals(expected.step to expected.time, seen.step to seen.time)
                assertEquals(expected.shearOffset, seen.shearOffset)
                assertArrayEquals(expected.lengths, seen.lengths)
                for (axis in 0..2) {
                    assertArrayEquals(expected.position[axis], seen.position[axis]) { "$axis of $t of $count" }
                    assertArrayEquals(expected.velocity[axis], seen.velocity[axis])
                    assertArrayEquals(expected.image!![axis], seen.image!![axis])
                }
            }
        }
    }

    @Test
    fun `a state is let go before the next but one is taken`() {
        val given = ArrayList<WeakReference<Snapshot>>()
        var most = 0
        val states = generateSequence(0) { it + 1 }.take(60).map { t ->
            if (t % 20 == 19) {
                System.gc()
                most = maxOf(most, given.count { it.get() != null })
            }
            state(t).also { given += WeakReference(it) }
        }
        export(states)
        assertTrue(most in 1..2) { "$most states at once" }
    }

    @Test
    fun `images are there when all states know them, and do not cost the others their checksum`() {
        val some = List(4) { if (it == 2) state(it).unknownImages() else state(it) }
        for (order in listOf(some, some.reversed(), some.sortedBy { it.image != null })) {
            assertTrue(H5md.read(export(order.asSequence())).all { it.image == null })
        }
        assertTrue(H5md.read(export(some.asSequence().filter { it.image != null })).all { it.image != null })
    }

    @Test
    fun `edges are vectors from the first frame on when images slide later`() {
        val read = H5md.read(export(sequenceOf(state(0), state(1))))
        assertEquals(listOf(0.0, state(1).shearOffset), read.map { it.shearOffset })
        assertTrue(state(1).shearOffset > 0)
        io.jhdf.HdfFile(home.resolve("trajectory.h5")).use {
            val rows = it.getDatasetByPath("/particles/all/box/edges/value").data as Array<*>
            for (t in 0..1) assertArrayEquals(state(t).edges(), rows[t] as Array<*>)
        }
    }

    @Test
    fun `spheres that differ, a cancel and a folder that is no more leave nothing`() {
        val fewer = Snapshot.of(population.copy().also { it.retain { k -> k > 0 } }, boundary, 99, 1.0)
        val e = assertThrows(IllegalArgumentException::class.java) { export(sequenceOf(state(0), state(1), fewer)) }
        assertTrue("spheres differ between steps 0 and 99" in e.message.orEmpty()) { e.message }
        assertTrue(home.listDirectoryEntries().isEmpty())
        assertThrows(ClosedByInterruptException::class.java) {
            export(generateSequence(0) { it + 1 }.map { state(it).also { Thread.currentThread().interrupt() } })
        }
        assertTrue(Thread.interrupted())
        assertTrue(home.listDirectoryEntries().isEmpty())
        assertThrows(IllegalArgumentException::class.java) { export(emptySequence()) }
        assertTrue(home.listDirectoryEntries().isEmpty())
        val folder = Files.createDirectory(home.resolve("gone"))
        val states = sequence {
            yield(state(0))
            folder.listDirectoryEntries().forEach(Files::delete)
            Files.delete(folder)
            yield(state(1))
        }
        assertThrows(IOException::class.java) { H5md.export(states, folder, ExportOptions("test")) }
        assertFalse(Files.exists(folder))
    }

    @Test
    fun `the same states give the same bytes`() {
        val states = generateSequence(0) { it + 1 }.map(::state).take(30)
        val first = Files.readAllBytes(export(states))
        assertArrayEquals(first, Files.readAllBytes(export(states)))
    }

    @Test
    fun `the sum of two parts is that of the whole`() {
        val bytes = ByteArray(5000) { (it * it + 3 * it).toByte() }
        fun sum(from: Int, until: Int) = CRC32C().apply { update(bytes, from, until - from) }.value
        for (at in listOf(0, 1, 72, 2500, 4999, 5000)) {
            assertEquals(sum(0, 5000), Crc32cJoin.of(sum(0, at), sum(at, 5000), 5000L - at)) { "$at" }
        }
    }
}
