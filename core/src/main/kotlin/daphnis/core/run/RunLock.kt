package daphnis.core.run

import daphnis.core.format.reasonOf
import daphnis.core.input.InputException
import daphnis.core.input.WayOut
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.channels.OverlappingFileLockException
import java.nio.file.LinkOption
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.util.concurrent.ConcurrentHashMap

/**
 * Keeps everything else from writing into a run directory: other processes by a system lock on the file `.lock`, which
 * ends with the process, however it ends, and other runs of this process by a list. On a file system without locks, such
 * as some network ones, a [LockMark] takes the place of the lock.
 *
 * The file stays when the lock is released. If it were deleted, one process could hold a lock on the deleted file and
 * another on the next file of that name. The list is checked first, because on POSIX systems a process gives up its
 * lock on a file when it closes *any* channel to it.
 */
public class RunLock private constructor(private val directory: Path, private val held: AutoCloseable) :
    AutoCloseable {
    /** What a user should know about it; null when there is a lock of the system. */
    public val notice: String? = if (held !is LockMark) {
        null
    } else {
        "$directory: its file system has no file locks; the file ${LockMark.FILE} keeps other processes out instead"
    }

    override fun close() {
        try {
            held.close()
        } finally {
            HELD.remove(directory)
        }
    }

    public companion object {
        /** Name of the file that is locked. */
        public const val FILE: String = ".lock"

        /** Names of all files that a lock may leave. */
        @JvmField
        public val FILES: Set<String> = setOf(FILE, LockMark.FILE, LockMark.GUARD)

        private val HELD: MutableSet<Path> = ConcurrentHashMap.newKeySet()

        /**
         * Locks [directory] until the lock is closed.
         *
         * @throws InputException when a run is in progress in [directory], it cannot be written, or it has [Links] to
         *   elsewhere
         */
        @JvmStatic
        public fun take(directory: Path): RunLock = try {
            Links.check(directory)
            val real = directory.toRealPath()
            if (!HELD.add(real)) throw busy(directory, ProcessHandle.current().pid().toString())
            try {
                RunLock(real, lockedChannel(directory) ?: marked(directory))
            } catch (e: Throwable) {
                HELD.remove(real)
                throw e
            }
        } catch (e: IOException) {
            throw InputException(directory.toString(), null, "cannot be written: ${reasonOf(e, directory)}")
        }

        private fun marked(directory: Path): LockMark = try {
            LockMark.make(directory)
        } catch (e: LockMark.Busy) {
            if (e.isKnown) throw busy(directory, e.who)
            val who = if (e.who.isEmpty()) "another process" else "another process (${e.who})"
            val why = "$who may be running in this directory, whose file system has no file locks"
            throw InputException(directory.toString(), null, "$why; if it is not, remove ${e.file}")
        }

        /** Null when the file system has no locks. */
        private fun lockedChannel(directory: Path): FileChannel? {
            val channel =
                FileChannel.open(
                    directory.resolve(FILE),
                    StandardOpenOption.CREATE,
                    StandardOpenOption.READ,
                    StandardOpenOption.WRITE,
                    LinkOption.NOFOLLOW_LINKS,
                )
            val isFree = try {
                channel.tryLock() != null
            } catch (e: OverlappingFileLockException) {
                false
            } catch (e: IOException) {
                channel.close()
                return null
            }
            val text = channel.text()
            if (!isFree) throw channel.use { busy(directory, text.filter { it in '0'..'9' }) }
            if (text.any { it > ' ' && it !in '0'..'9' } || text.length > LONGEST_NUMBER) {
                val why = "holds no number of a process and would be overwritten"
                throw channel.use { InputException("${directory.resolve(FILE)}", null, "$why; $WAY_OUT") }
            }
            try {
                channel.truncate(0)
                channel.write(ByteBuffer.wrap("${ProcessHandle.current().pid()}\n".toByteArray()))
            } catch (e: IOException) {
                channel.close()
                throw e
            }
            return channel
        }

        /** What the process that holds the lock wrote into its file; empty when it has not yet. */
        private fun FileChannel.text(): String = try {
            val bytes = ByteBuffer.allocate(LONGEST_NUMBER + 1)
            String(bytes.array(), 0, maxOf(0, read(bytes, 0)), Charsets.US_ASCII)
        } catch (e: IOException) {
            ""
        }

        private fun busy(directory: Path, process: String): InputException {
            val which = if (process.isEmpty()) "" else " ($process)"
            val problem = "another process$which is running in this directory"
            return InputException(directory.toString(), null, problem, WayOut.AWAIT_OTHER)
        }

        private const val LONGEST_NUMBER = 20
        private const val WAY_OUT = "remove it, or give another directory"
    }
}
