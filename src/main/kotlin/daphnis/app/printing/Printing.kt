/*
 * The only way of text out of the program, which holds nothing that a terminal obeys: names, descriptions and messages
 * come from files and processes of others. Only this file writes to the standard streams; a test holds it to that.
 */
package daphnis.app.printing

import daphnis.core.input.oneLine

/** Prints [text] in one line, whatever stands in it. */
internal fun printLine(text: String): Unit = println(oneLine(text))

/** Prints [text] in the lines that it has. What may hold line ends of others goes through [oneLine] before. */
internal fun printLines(text: String): Unit = println(text.split('\n').joinToString("\n", transform = ::oneLine))

/** Says [message] in one line on the error stream, whatever stands in it. */
internal fun warn(message: String): Unit = System.err.println("daphnis: ${oneLine(message)}")

/** Shows [e] with its stack trace on the error stream. */
internal fun showTrace(e: Throwable) {
    for (line in e.stackTraceToString().trimEnd().lines()) {
        val text = line.trimStart('\t')
        System.err.println("\t".repeat(line.length - text.length) + oneLine(text))
    }
}

/** A stream of which a terminal shows one line that is written over. */
internal enum class Overwritten {
    OUTPUT,
    ERRORS,
    ;

    /** Writes [text] over the line, of which [width] columns are taken, at most [columns] of them. */
    fun show(text: String, width: Int, columns: Int): Unit = write("\r" + oneLine(text).padEnd(minOf(width, columns)))

    /** Leaves an empty line to write on. */
    fun clear(width: Int, columns: Int): Unit = write("\r" + " ".repeat(minOf(width, columns)) + "\r")

    /** Ends the line, which stays. */
    fun end(): Unit = write("\n")

    private fun write(text: String) {
        val stream = if (this == OUTPUT) System.out else System.err
        stream.print(text)
        stream.flush()
    }
}

/** Writes out what was printed and waits in a buffer. */
internal fun flushPrinted(): Unit = System.out.flush()
