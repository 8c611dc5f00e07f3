package daphnis.drills

import java.nio.file.Files
import java.nio.file.Path
import java.util.Random

/** A way in which a file is damaged. */
internal enum class Blow {
    CUT {
        override fun change(bytes: ByteArray, at: Int, random: Random) = bytes.copyOf(at)
    },
    BIT {
        override fun change(bytes: ByteArray, at: Int, random: Random) = bytes.also {
            it[at] =
                (it[at].toInt() xor (1 shl random.nextInt(8))).toByte()
        }
    },
    BYTE {
        override fun change(bytes: ByteArray, at: Int, random: Random) = bytes.also {
            it[at] =
                (it[at] + 1 + random.nextInt(255)).toByte()
        }
    },

    /** A digit becomes another, so that text stays well-formed; a bit where there is none. */
    DIGIT {
        override fun change(bytes: ByteArray, at: Int, random: Random): ByteArray {
            val place =
                (at until bytes.size).firstOrNull { bytes[it] in '0'.code..'9'.code }
                    ?: return BIT.change(bytes, at, random)
            bytes[place] = ('0'.code + (bytes[place] - '0'.code + 1 + random.nextInt(9)) % 10).toByte()
            return bytes
        }
    },
    ZEROS {
        override fun change(bytes: ByteArray, at: Int, random: Random) = bytes.also {
            it.fill(
                0,
                at,
                minOf(
                    it.size,
                    at + (1 shl random.nextInt(12)),
                ),
            )
        }
    },
    GARBAGE {
        override fun change(bytes: ByteArray, at: Int, random: Random) = bytes.also {
            for (k in at until minOf(it.size, at + (1 shl random.nextInt(9)))) {
                it[k] =
                    random.nextInt().toByte()
            }
        }
    },
    TAIL {
        override fun change(bytes: ByteArray, at: Int, random: Random) =
            bytes + ByteArray(1 + random.nextInt(3000)).also { random.nextBytes(it) }
    },
    EMPTY {
        override fun change(bytes: ByteArray, at: Int, random: Random) = ByteArray(0)
    },
    DIRECTORY {
        override fun change(bytes: ByteArray, at: Int, random: Random) = bytes
    },
    GONE {
        override fun change(bytes: ByteArray, at: Int, random: Random) = bytes
    }, ;

    /** [bytes], which may be changed, as they are after the blow at [at]. */
    protected abstract fun change(bytes: ByteArray, at: Int, random: Random): ByteArray

    /** Damages [file] at a drawn place. @return what was done, in words */
    fun strike(file: Path, random: Random): String {
        val bytes = Files.readAllBytes(file)
        val at = if (bytes.isEmpty()) 0 else random.nextInt(bytes.size)
        Files.delete(file)
        when (this) {
            GONE -> return "gone"
            DIRECTORY -> Files.createDirectory(file)
            else -> Files.write(file, if (bytes.isEmpty()) byteArrayOf(1) else change(bytes, at, random))
        }
        return "$this at $at of ${bytes.size}"
    }

    companion object {
        fun draw(random: Random, isSnapshot: Boolean): Blow =
            entries[random.nextInt(entries.size)].takeUnless { isSnapshot && it == GONE } ?: BIT
    }
}
