package daphnis.core.format

import daphnis.core.Repository
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.format.Kept.Presence
import daphnis.core.input.SiUnits
import daphnis.core.randomSpheres
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/** What every format of the list promises, asked of each. */
class SnapshotFormatsTest {
    @TempDir
    lateinit var home: Path

    private val boundary = Periodic(Box.centred(12.0, 11.0, 10.0))
    private val population = randomSpheres(30, boundary, 8, 1.0) { it.nextDouble(0.2, 0.6) }
    private val states = List(2) { k ->
        val (id, first) = IntArray(30) { 100 + 3 * it } to Snapshot.of(population, boundary, 10L * k, 0.5 * k)
        Snapshot(
            first.step, first.time, first.lengths, first.periodic, 0.0, id,
            first.position, first.velocity, first.radius, DoubleArray(30) { 2.0 + it },
        )
    }

    private fun export(format: WritableFormat, options: ExportOptions = ExportOptions("test")): Exported {
        val directory = Files.createDirectories(home.resolve(format.word))
        return format.export(states.asSequence(), directory, options)
    }

    @Test
    fun `an export that ends before its last state leaves the files as they were`() {
        for (format in SnapshotFormats.writable) {
            export(format)
            val directory = home.resolve(format.word)
            fun files() = directory.listDirectoryEntries().associate { it.name to Files.readAllBytes(it).asList() }
            val before = files()
            // The same state once more, and then a second one that cannot be read.
            val broken = sequence {
                yield(states[0])
                throw FormatException("damaged")
            }
            assertThrows(FormatException::class.java) { format.export(broken, directory, ExportOptions("test")) }
            assertEquals(before, files(), format.word)
        }
    }

    @Test
    fun `a format keeps what it says, no more and no less`() {
        val both = SnapshotFormats.writable.filter { it is ReadableFormat }
        assertTrue(both.size >= 3) { "${both.size} formats are written and read" }
        for (format in both) {
            export(format, ExportOptions("test", scale = 2.0.takeIf { format.takesScale }))
            val files = home.resolve(format.word).listDirectoryEntries().sortedBy { it.name.length }
            val read = files.map { SnapshotFormats.read(it) }
            val word = format.word
            assertEquals(if (format.keeps.severalStates) listOf(2) else listOf(1, 1), read.map { it.size }, word)
            for ((state, back) in states.zip(read.flatten())) {
                assertEquals(format.keeps.masses != Presence.NEVER, back.hasMass, word)
                if (back.hasMass) assertArrayEquals(state.mass, back.mass, word)
                assertEquals(format.keeps.ids != Presence.NEVER, state.id.contentEquals(back.id), word)
                assertEquals(format.keeps.velocities != Presence.NEVER, back.velocity[1].any { it != 0.0 }, word)
                for (axis in 0..2) assertArrayEquals(state.position[axis], back.position[axis], 1e-14, word)
                assertArrayEquals(state.radius, back.radius, 1e-14, word)
            }
        }
    }

    @Test
    fun `a format whose particles may change writes states of different ones, the other refuses them`() {
        val fewer = Snapshot.of(population.copy().also { p -> p.retain { it > 3 } }, boundary, 30, 3.0)
        for (format in SnapshotFormats.writable) {
            val directory = Files.createDirectories(home.resolve("changing-${format.word}"))
            val write = { format.export(sequenceOf(states[0], fewer), directory, ExportOptions("test")) }
            if (format.keeps.changingParticles) {
                write()
            } else {
                assertThrows(IllegalArgumentException::class.java) { write() }
            }
        }
    }

    @Test
    fun `what was written is named, and the factor that was taken is said`() {
        for (format in SnapshotFormats.writable) {
            assertTrue(Files.exists(export(format).path)) { format.word }
            assertEquals(1.0, export(format).scale, format.word)
        }
        assertEquals(3.0, export(ExtendedXyz, ExportOptions("test", scale = 3.0)).scale)
        assertEquals("trajectory-si.h5", export(H5md, ExportOptions("test", units = SiUnits(2.0, 1.0, 1.0))).path.name)
        val radius = SnapshotFormats.read(home.resolve("h5md/trajectory-si.h5"))[0].radius[7]
        assertEquals(2 * states[0].radius[7], radius)
    }

    @Test
    fun `a format is known by the end of the name`() {
        fun of(name: String) = SnapshotFormats.of(Path.of("d.csv", name))
        for (format in SnapshotFormats.readable) {
            for (ending in format.extensions) {
                assertSame(format, of("a.$ending"))
                assertSame(format, of("A.${ending.uppercase()}"))
            }
        }
        assertSame(H5md, of("0000000010.h5"))
        for (name in listOf("CartAndRad.200.bin", "CartAndRad.200", "CartAndRad.200.dat", "a.CartAndRad")) {
            assertSame(CartAndRad, of(name)) { name }
        }
        assertSame(ParticleCsv, of("CartAndRad.csv"))
        val e = assertThrows(FormatException::class.java) { of("a.vtp") }
        assertTrue("a.vtp" in e.message!! && ".xyz .extxyz (extended XYZ)" in e.message!!) { e.message }
    }

    @Test
    fun `no two formats have a word, a title or an ending in common, and the guides name them all`() {
        fun once(words: List<String>) = assertEquals(words.distinct(), words)
        once(SnapshotFormats.all.map { it.title })
        once(SnapshotFormats.writable.map { it.word })
        once(SnapshotFormats.readable.flatMap { it.extensions })
        val scenarios = Repository.read("docs/scenario.md").lines()
        val masses = mapOf(Presence.ALWAYS to "kept", Presence.IF_THERE to "kept if present", Presence.NEVER to "none")
        for (format in SnapshotFormats.readable) {
            val row = scenarios.single { it.startsWith("| `.${format.extensions.first()}`") }
            for (ending in format.extensions) assertTrue("`.$ending`" in row) { row }
            assertTrue(row.endsWith("| ${masses[format.keeps.masses]} |")) { row }
        }
        val guide = Repository.read("docs/runs.md")
        for (format in SnapshotFormats.writable) assertTrue("--format ${format.word} " in guide) { format.word }
    }
}
