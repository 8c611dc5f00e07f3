package daphnis.app

import java.io.BufferedOutputStream
import java.io.FileDescriptor
import java.io.FileOutputStream
import java.io.IOException
import java.io.OutputStream
import java.io.PrintStream
import java.nio.charset.Charset

/**
 * Standard output that remembers its first failure, which `System.out` swallows. A reader that has gone (`| head -1`)
 * is no failure: what is not read is dropped and the work goes on to its end, because files are what most commands are
 * for. A full device is one, and is said when the command has done its work.
 */
internal class StandardOutput(private val target: OutputStream) : OutputStream() {
    private var failure: IOException? = null

    override fun write(byte: Int) = attempt { target.write(byte) }

    override fun write(bytes: ByteArray, from: Int, length: Int) = attempt { target.write(bytes, from, length) }

    override fun flush() = attempt { target.flush() }

    /** What went wrong, in words; null when everything was written or no reader wanted it. */
    val problem: String? get() = failure?.message?.takeUnless { "pipe" in it.lowercase() }

    private fun attempt(write: () -> Unit) {
        if (failure != null) return
        try {
            write()
        } catch (e: IOException) {
            failure = e
        }
    }

    companion object {
        /** Puts one in the place of `System.out`. */
        fun install(): StandardOutput {
            val output = StandardOutput(BufferedOutputStream(FileOutputStream(FileDescriptor.out), BUFFER))
            System.setOut(PrintStream(output, true, charset()))
            return output
        }

        /** What `System.out` has. */
        private fun charset(): Charset {
            val name = listOf("stdout.encoding", "sun.stdout.encoding", "native.encoding").firstNotNullOfOrNull {
                System.getProperty(it)
            }
            return if (name != null && Charset.isSupported(name)) Charset.forName(name) else Charset.defaultCharset()
        }

        private const val BUFFER = 8192
    }
}
