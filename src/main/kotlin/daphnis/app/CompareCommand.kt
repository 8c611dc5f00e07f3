package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import daphnis.app.printing.printLine
import daphnis.core.input.InputException
import daphnis.core.run.RecordedRun
import daphnis.core.run.Run
import daphnis.core.run.RunRecord
import daphnis.core.run.Summary
import daphnis.core.run.Version

/** `daphnis compare`: exit code 0 when two runs are identical, 1 when they differ. */
class CompareCommand : CliktCommand(name = "compare") {
    private val first by argument("dir1", help = "run directory", completionCandidates = Candidates.files)
    private val second by argument("dir2", help = "run directory", completionCandidates = Candidates.files)

    override fun help(context: Context) =
        "Say whether two runs are identical, or the first step and particle that differ."

    override fun run() {
        val (runA, runB) = listOf(first, second).map { Run.open(pathOf(it, "dir")) }
        val (a, b) = listOf(runA, runB).map { it.directory }
        val (endA, endB) = listOf(runA, runB).map { it.summary() }
        val common = a.snapshotSteps().intersect(b.snapshotSteps().toSet()).sorted()
        for (step in common) {
            val difference = firstDifference(a.readSnapshot(step), b.readSnapshot(step)) ?: continue
            printLine("differ at step $step: $difference${sameEnd(endA, endB)}")
            throw ProgramResult(EXIT_FAILED)
        }
        val digestA = endA?.stateDigest
        val digestB = endB?.stateDigest
        val rest = "${common.size} common snapshots are identical"
        if (endA != null && endB != null && endA.steps != endB.steps) {
            val ends = "one ended after step ${endA.steps}, the other after step ${endB.steps}"
            printLine("differ: $ends; $rest${sameEnd(endA, endB)}")
            throw ProgramResult(EXIT_FAILED)
        }
        if (digestA != null && digestB != null && digestA != digestB) {
            printLine("differ at the end: state digest $digestA against $digestB; $rest")
            throw ProgramResult(EXIT_FAILED)
        }
        if (common.isEmpty() && (digestA == null || digestB == null)) {
            throw InputException(first, null, "has no snapshot or summary in common with $second")
        }
        val digest = if (digestA != null && digestA == digestB) {
            ", state digest $digestA"
        } else {
            "; the ends are not compared, since ${listOfNotNull(notEnded(runA), notEnded(runB)).joinToString(" and ")}"
        }
        printLine("identical: ${common.size} common snapshots$digest")
    }

    /** Why [run] has no end to compare; null when it has one. */
    private fun notEnded(run: RecordedRun): String? {
        if (run.summary() != null) return null
        val path = run.directory.path
        if (!RunRecord.of(run.directory).hasEnded) return "$path has not ended"
        return "${run.directory.summary} is missing, which ${Version.command} resume $path writes again"
    }

    /** A run that starts from a state of another counts its steps anew, and yet may come to the same end. */
    private fun sameEnd(a: Summary?, b: Summary?): String {
        if (a?.stateDigest == null || a.stateDigest != b?.stateDigest) return ""
        return "; both end in the same state, digest ${a.stateDigest}"
    }
}
