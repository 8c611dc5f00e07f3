package daphnis.core.run

import java.io.IOException
import java.net.InetAddress
import java.nio.file.FileAlreadyExistsException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE_NEW
import java.nio.file.StandardOpenOption.WRITE
import kotlin.jvm.optionals.getOrNull

/**
 * Says which process writes into a directory where the file system has no locks: the file [FILE] with host, number and
 * start of the process, whose creation is a single act on every file system. Unlike a lock it stays when the process is
 * killed. The next process of the same host takes such a mark away; on another host nobody can tell, so it is refused
 * and the file is named.
 */
internal class LockMark private constructor(private val file: Path) : AutoCloseable {
    override fun close() {
        Files.deleteIfExists(file)
    }

    /** Somebody else has marked the directory: [who], which may have ended if [isKnown] is false. */
    class Busy(val file: Path, val who: String, val isKnown: Boolean) : Exception()

    companion object {
        const val FILE = ".lock.owner"

        /** Held while a mark of a dead process is taken away: by one process at a time, and only that mark. */
        const val GUARD = ".lock.dead"
        private const val MOST_LETTERS = 200

        /**
         * Marks [directory] as that of this process until the mark is closed.
         *
         * @throws Busy when it has a mark of another one that may be alive
         */
        @Throws(IOException::class)
        fun make(directory: Path): LockMark {
            val file = directory.resolve(FILE)
            if (!created(file)) {
                takeAway(file, directory.resolve(GUARD))
                if (!created(file)) throw Busy(file, read(file).orEmpty(), isKnown = true)
            }
            return LockMark(file)
        }

        private fun created(file: Path): Boolean = try {
            Files.write(file, "$ME\n".toByteArray(), CREATE_NEW, WRITE)
            true
        } catch (e: FileAlreadyExistsException) {
            false
        }

        private fun takeAway(file: Path, guard: Path) {
            requireDead(file)
            try {
                Files.createDirectory(guard)
            } catch (e: FileAlreadyExistsException) {
                throw Busy(guard, "", isKnown = false)
            }
            try {
                // Another process may have done so just before, and stand there itself.
                requireDead(file)
                Files.deleteIfExists(file)
            } finally {
                Files.deleteIfExists(guard)
            }
        }

        private fun requireDead(file: Path) {
            // Whoever has made it is about to write into it, or was killed before.
            val owner = read(file) ?: return
            val words = owner.split(' ')
            val pid = words.getOrNull(1)?.toLongOrNull()
            if (words.size != 3 || pid == null || words[0] != HOST) throw Busy(file, owner, isKnown = false)
            if (started(pid) == words[2]) throw Busy(file, owner, isKnown = true)
        }

        private fun read(file: Path): String? = try {
            Files.readAllBytes(file).take(MOST_LETTERS).map {
                Char(it.toInt())
            }.filter { it in ' '..'~' }.joinToString("")
        } catch (e: NoSuchFileException) {
            null
        }

        /** When the process [pid] of this machine began, in milliseconds; null when there is none. */
        private fun started(pid: Long): String? = ProcessHandle.of(pid).getOrNull()?.let {
            it.info().startInstant().getOrNull()?.toEpochMilli() ?: 0
        }?.toString()

        private val HOST: String by lazy {
            val name = try {
                Files.readString(Path.of("/proc/sys/kernel/hostname")).trim()
            } catch (e: IOException) {
                InetAddress.getLocalHost().hostName
            }
            name.filter { it in '!'..'~' }.ifEmpty { "host" }
        }
        private val ME: String get() = ProcessHandle.current().pid().let { "$HOST $it ${started(it)}" }
    }
}
