package daphnis.core.run

import daphnis.core.format.reasonOf
import daphnis.core.scenario.InputException
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.channels.OverlappingFileLockException
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.util.concurrent.ConcurrentHashMap

/**
 * Keeps everything else from writing into a run directory: other processes by a system lock on the file `.lock`, which
 * ends with the process, however it ends, and other runs of this process by a list.
 *
 * The file stays when the lock is released. If it were deleted, one process could hold a lock on the deleted file and
 * another on the next file of that name. The list is checked first, because on POSIX systems a process gives up its
 * lock on a file when it closes *any* channel to it.
 */
public class RunLock private constructor(private val directory: Path, private val channel: FileChannel) :
    AutoCloseable {
    override fun close() {
        try {
            channel.close()
        } finally {
            HELD.remove(directory)
        }
    }

    public companion object {
        /** Name of the file that is locked. */
        public const val FILE: String = ".lock"

        private val HELD: MutableSet<Path> = ConcurrentHashMap.newKeySet()

        /**
         * Locks [directory] until the lock is closed.
         *
         * @throws InputException when a run is in progress in [directory], or it cannot be written
         */
        @JvmStatic
        public fun take(directory: Path): RunLock = try {
            val real = directory.toRealPath()
            if (!HELD.add(real)) throw busy(directory, ProcessHandle.current().pid().toString())
            try {
                RunLock(real, lockedChannel(directory))
            } catch (e: Throwable) {
                HELD.remove(real)
                throw e
            }
        } catch (e: IOException) {
            throw InputException(directory.toString(), null, "cannot be written: ${reasonOf(e, directory)}")
        }

        private fun lockedChannel(directory: Path): FileChannel {
            val channel =
                FileChannel.open(
                    directory.resolve(FILE),
                    StandardOpenOption.CREATE,
                    StandardOpenOption.READ,
                    StandardOpenOption.WRITE,
                )
            val isFree = try {
                channel.tryLock() != null
            } catch (e: OverlappingFileLockException) {
                false
            } catch (e: IOException) {
                // Some file systems have no locks; then no process is kept out.
                true
            }
            if (!isFree) throw channel.use { busy(directory, holder(it)) }
            try {
                channel.truncate(0)
                channel.write(ByteBuffer.wrap("${ProcessHandle.current().pid()}\n".toByteArray()))
            } catch (e: IOException) {
                channel.close()
                throw e
            }
            return channel
        }

        /** The process that wrote its number into the lock file; empty when it has not yet. */
        private fun holder(channel: FileChannel): String = try {
            val bytes = ByteBuffer.allocate(LONGEST_NUMBER)
            channel.read(bytes, 0)
            String(bytes.array(), Charsets.US_ASCII).filter { it.isDigit() }
        } catch (e: IOException) {
            ""
        }

        private fun busy(directory: Path, process: String): InputException {
            val which = if (process.isEmpty()) "" else " ($process)"
            return InputException(directory.toString(), null, "another process$which is running in this directory")
        }

        private const val LONGEST_NUMBER = 20
    }
}
