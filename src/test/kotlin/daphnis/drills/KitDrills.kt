package daphnis.drills

import daphnis.app.allEngines
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.FailingCase
import daphnis.core.engine.FailingSteps
import daphnis.core.engine.FixedThreads
import daphnis.core.engine.TestedEngines
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.deleteRecursively

/** Every file of a run directory damaged at drawn places, and what each command makes of it. */
internal object DamageDrill : Drill {
    override val name = "damage"
    override val what = "one file of a run directory damaged, then resume, compare, export or analyze"
    override val cases = 600

    override fun run(cases: Int, seed: Long, say: (String) -> Unit): Tally = inDirectory(name) { home ->
        val judged = Damage(home, seed).run(cases)
        for (case in judged) say("$case")
        val counts = Verdict.entries.map { verdict -> "$verdict ${judged.count { it.verdict == verdict }}" }
        Tally(cases, judged.filterNot { it.verdict.isGood }.map { "$it" }, listOf(counts.joinToString()))
    }
}

/** Scenarios with hostile values at drawn places, through reading, describing and two steps. */
internal object ScenarioFuzzDrill : Drill {
    override val name = "scenario"
    override val what = "scenarios mutated at drawn places: each works, or is refused in one line"
    override val cases = 3000

    override fun run(cases: Int, seed: Long, say: (String) -> Unit): Tally = inDirectory(name) {
        tally(cases, scenarioFuzz(cases, seed, it))
    }
}

/** Files of other programs with hostile values, bytes and shapes, through every door that reads them. */
internal object ForeignFuzzDrill : Drill {
    override val name = "foreign"
    override val what = "HDF5, XYZ, CSV, CartAndRad and LAMMPS files mutated: each works, or is refused in one line"
    override val cases = 1500

    override fun run(cases: Int, seed: Long, say: (String) -> Unit): Tally = inDirectory(name) {
        tally(cases, foreignFuzz(cases, seed, it))
    }
}

/** Throws at every call of every function of a user in a step, in every engine, three boundaries, so many seeds. */
internal object ThrowDrill : Drill {
    override val name = "throw"
    override val what = "every call of a user's function in a step throws once, in every engine; cases are seeds"
    override val cases = 20

    override fun run(cases: Int, seed: Long, say: (String) -> Unit): Tally {
        val lost = ArrayList<String>()
        var tried = 0
        for (drawn in seed until seed + cases) {
            for (case in FailingCase.entries) {
                for ((engine, make) in engines) {
                    try {
                        tried += thrown(case, drawn, make)
                    } catch (e: Throwable) {
                        lost += "$case, $engine, seed $drawn: $e"
                    }
                }
            }
            say("seed $drawn: $tried calls have thrown")
        }
        return Tally(tried, lost)
    }

    private fun thrown(case: FailingCase, seed: Long, engine: () -> CollisionEngine): Int =
        FailingSteps(case, seed, engine).use { steps ->
            steps.throwAtEachCall()
            steps.throwAtEachCall(every = 3) { OutOfMemoryError("on purpose, $it") }
            steps.finish()
            steps.thrown
        }

    private val tested = TestedEngines(allEngines)

    private val engines: Map<String, () -> CollisionEngine> =
        allEngines.names.associateWith { name -> { tested.make(name, FixedThreads(3)) } }
}

private fun tally(cases: Int, counts: FuzzCounts) = Tally(
    cases,
    counts.faults,
    listOf("${counts.worked} worked, ${counts.refused} refused in a line, ${counts.failed} failed in a line"),
)

@OptIn(ExperimentalPathApi::class)
internal fun inDirectory(name: String, work: (Path) -> Tally): Tally {
    val home = Files.createTempDirectory("daphnis-$name")
    try {
        return work(home)
    } finally {
        home.deleteRecursively()
    }
}
