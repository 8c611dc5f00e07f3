package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import daphnis.core.format.Frame
import daphnis.core.format.H5md
import daphnis.core.run.RunDirectory
import daphnis.core.run.Summary
import daphnis.core.scenario.InputException
import daphnis.core.scenario.inputPath
import java.nio.file.Files

/** `daphnis compare`: exit code 0 when two runs are identical, 1 when they differ. */
class CompareCommand : CliktCommand(name = "compare") {
    private val first by argument("dir1", help = "run directory")
    private val second by argument("dir2", help = "run directory")

    override fun help(context: Context) = "Say whether two runs are identical, or the first step and particle that differ."

    override fun run() {
        val a = directory(first)
        val b = directory(second)
        val common = a.snapshotSteps().intersect(b.snapshotSteps().toSet()).sorted()
        for (step in common) {
            val difference = difference(H5md.read(a.snapshot(step)).first(), H5md.read(b.snapshot(step)).first()) ?: continue
            println("differ at step $step: $difference")
            throw ProgramResult(EXIT_FAILED)
        }
        val digestA = digest(a)
        val digestB = digest(b)
        if (digestA != null && digestB != null && digestA != digestB) {
            println("differ at the end: state digest $digestA against $digestB; ${common.size} common snapshots are identical")
            throw ProgramResult(EXIT_FAILED)
        }
        if (common.isEmpty() && (digestA == null || digestB == null)) throw InputException(first, null, "has no snapshot or summary in common with $second")
        val digest = if (digestA != null && digestA == digestB) ", state digest $digestA" else "; at least one has not ended, so the ends are not compared"
        println("identical: ${common.size} common snapshots$digest")
    }

    private fun directory(word: String): RunDirectory {
        val directory = RunDirectory(inputPath(word, ""))
        if (!Files.exists(directory.scenario)) throw InputException(word, null, "is no run directory")
        return directory
    }

    private fun digest(directory: RunDirectory): String? = if (Files.exists(directory.summary)) Summary.read(directory.summary).stateDigest else null

    private fun difference(a: Frame, b: Frame): String? {
        if (!a.id.contentEquals(b.id)) return "the particles are not the same (${a.size} and ${b.size})"
        for (k in 0 until a.size) {
            for (axis in 0..2) {
                val x = a.position[axis][k]
                val y = b.position[axis][k]
                if (x.toRawBits() != y.toRawBits()) return "particle ${a.id[k]}, ${"xyz"[axis]} = $x against $y"
                val v = a.velocity[axis][k]
                val w = b.velocity[axis][k]
                if (v.toRawBits() != w.toRawBits()) return "particle ${a.id[k]}, v${"xyz"[axis]} = $v against $w"
            }
        }
        return null
    }
}
