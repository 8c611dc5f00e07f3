package daphnis.drills

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.format.CartAndRad
import daphnis.core.format.ExtendedXyz
import daphnis.core.format.H5md
import daphnis.core.format.LammpsDump
import daphnis.core.format.Snapshot
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import java.io.StringWriter
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.pow

/**
 * Files of particles as they should not be: sound ones damaged by the bit and by the word, and others written whole
 * with hostile numbers.
 */
internal class ForeignMutation(private val random: SeededRandom, private val home: Path) {
    /** Writes a file whose name begins with [stem] and ends as its format does. */
    fun file(stem: String): Path = when (random.nextInt(7)) {
        0 -> Files.write(home.resolve("$stem.xyz"), text(xyz()))
        1 -> Files.write(home.resolve("$stem.csv"), text(csv()))
        2 -> Files.write(home.resolve("$stem.bin"), numbers(cartAndRad()))
        3 -> Files.write(home.resolve("$stem.h5"), bits(h5md(hostile = false)))
        4 -> Files.write(home.resolve("$stem.lammpstrj"), text(lammpsDump()))
        5 -> Files.write(home.resolve("$stem.data"), text(lammpsData()))
        else -> Files.write(home.resolve("$stem.h5"), h5md(hostile = true))
    }

    private fun <T> pick(from: List<T>): T = from[random.nextInt(from.size)]

    private fun frame(k: Int, hostile: Boolean = false): Snapshot {
        fun column(low: Double, high: Double) = DoubleArray(COUNT) { random.nextDouble(low, high) }
        val frame = Snapshot(
            10L * k, k.toDouble(), doubleArrayOf(10.0, 9.0, 8.0), BooleanArray(3) { true }, 0.0, IntArray(COUNT) { it },
            Array(3) { column(-4.0, 4.0) }, Array(3) { column(-1.0, 1.0) }, column(0.1, 0.3), column(0.5, 2.0),
        )
        if (!hostile) return frame
        val array = pick(listOf(frame.lengths, frame.radius, frame.mass) + frame.position + frame.velocity)
        if (random.nextInt(2) == 0) array.fill(number()) else array[random.nextInt(array.size)] = number()
        if (random.nextInt(4) == 0) {
            frame.id[random.nextInt(COUNT)] = pick(listOf(-1, 0, 1, 999_999_999, Int.MAX_VALUE, Int.MIN_VALUE))
        }
        val time = if (random.nextInt(4) == 0) number() else frame.time
        val step = pick(listOf(frame.step, frame.step, -1L, Long.MAX_VALUE))
        val offset = if (random.nextInt(4) == 0) number() else 0.0
        return Snapshot(
            step, time, frame.lengths, BooleanArray(3) { random.nextInt(3) > 0 }, offset,
            frame.id, frame.position, frame.velocity, frame.radius, frame.mass,
            normalAxis = random.nextInt(4),
            slideAxis = random.nextInt(2),
        )
    }

    private fun number(): Double {
        if (random.nextInt(3) > 0) return pick(NUMBERS).toDouble()
        val sign = if (random.nextInt(2) == 0) 1 else -1
        return sign * 10.0.pow(random.nextDouble(-320.0, 308.0))
    }

    private fun h5md(hostile: Boolean): ByteArray {
        val path = home.resolve("written.h5")
        val frames = List(1 + random.nextInt(2)) { frame(it, hostile) }
        val same = frames.map {
            Snapshot(
                it.step, it.time, it.lengths, it.periodic, it.shearOffset, frames[0].id,
                it.position, it.velocity, it.radius, it.mass, it.normalAxis, it.slideAxis,
            )
        }
        H5md.write(same, path, "fuzz")
        return Files.readAllBytes(path).also { Files.delete(path) }
    }

    private fun xyz(): String = StringWriter().also { out ->
        for (k in 0..random.nextInt(2)) ExtendedXyz.write(frame(k), out)
    }.toString()

    private fun csv(): String {
        val frame = frame(0)
        val rows = (0 until COUNT).joinToString("\n") { k ->
            "${frame.position[0][k]},${frame.position[1][k]},${frame.position[2][k]},${frame.radius[k]},1,$k"
        }
        return "x,y,z,radius,mass,id\n$rows\n"
    }

    private fun lammpsDump(): String = StringWriter().also { out ->
        for (k in 0..random.nextInt(2)) LammpsDump.write(frame(k), out)
    }.toString()

    private fun lammpsData(): String {
        val frame = frame(0)
        val atoms = (0 until COUNT).joinToString("\n") { k ->
            "$k 1 ${2 * frame.radius[k]} 1 ${frame.position[0][k]} ${frame.position[1][k]} ${frame.position[2][k]}"
        }
        val velocities = (0 until COUNT).joinToString("\n") { k -> "$k ${frame.velocity[0][k]} 0 0 0 0 0" }
        return "fuzz\n\n$COUNT atoms\n-5 5 xlo xhi\n-4.5 4.5 ylo yhi\n-4 4 zlo zhi\n\n" +
            "Atoms # sphere\n\n$atoms\n\nVelocities\n\n$velocities\n"
    }

    private fun cartAndRad(): ByteArray {
        val path = home.resolve("written.bin")
        val frame = frame(0)
        val population = Population(
            frame.position[0],
            frame.position[1],
            frame.position[2],
            frame.velocity[0],
            frame.velocity[1],
            frame.velocity[2],
            frame.radius,
            frame.mass,
        )
        CartAndRad.write(Snapshot.of(population, Periodic(Box.centred(10.0, 9.0, 8.0)), 0, 0.0).population(), path)
        return Files.readAllBytes(path).also { Files.delete(path) }
    }

    /** Words for others, lines gone or twice, or bits turned. */
    private fun text(text: String): ByteArray {
        if (random.nextInt(5) == 0) return bits(text.toByteArray())
        var changed = text
        repeat(1 + random.nextInt(3)) {
            val words = Regex("""[^\s,="]+""").findAll(changed).toList()
            val lines = changed.lines()
            changed = when (random.nextInt(6)) {
                0 -> lines.filterIndexed { k, _ -> k != random.nextInt(lines.size) }.joinToString("\n")
                1 -> random.nextInt(lines.size).let { k -> (lines.take(k + 1) + lines.drop(k)).joinToString("\n") }
                else -> if (words.isEmpty()) changed else changed.replaceRange(word(words), pick(NUMBERS + WORDS))
            }
        }
        return changed.toByteArray()
    }

    /** Where one of [words] is; those at the beginning come up more often. */
    private fun word(words: List<MatchResult>): IntRange = pick(words.take(HEAD) + pick(words)).range

    private fun numbers(bytes: ByteArray): ByteArray {
        if (random.nextInt(3) == 0) return bits(bytes)
        val buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
        repeat(1 + random.nextInt(2)) { buffer.putDouble(4 + 8 * random.nextInt((bytes.size - 4) / 8), number()) }
        return bytes
    }

    private fun bits(bytes: ByteArray): ByteArray {
        if (random.nextInt(5) == 0) return bytes.copyOf(random.nextInt(bytes.size))
        repeat(1 + random.nextInt(4)) {
            val at = random.nextInt(bytes.size)
            val turned = bytes[at].toInt() xor (1 shl random.nextInt(8))
            bytes[at] = (if (random.nextInt(2) == 0) turned else random.nextInt(256)).toByte()
        }
        return bytes
    }

    private companion object {
        const val COUNT = 12

        /** Words at the beginning of a text that are changed as often as all the others. */
        const val HEAD = 30
        val NUMBERS = (
            "0 -0.0 1 -1 2 -5 0.5 1e-300 1e300 -1e300 1e-15 1e15 2147483647 2147483648 9223372036854775807 4.9e-324 " +
                "1.7976931348623157e308 1e-40 1e40 1e9 1e100 1e-100 1e155 NaN Infinity -Infinity 1000000"
            ).split(" ")
        val WORDS = listOf(
            "", "x", "pos", "pos:R:3", "species:S:2147483647", "1 2 3", "T T", "\"", "=", "\u0000", "ü", "1,2",
            "radius", "pp", "ITEM:", "xlo", "xy", "Atoms", "sphere", "a".repeat(2000), "0x10", "1d", "--5",
        )
    }
}
