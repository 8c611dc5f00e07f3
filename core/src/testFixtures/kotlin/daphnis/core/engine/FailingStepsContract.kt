package daphnis.core.engine

import org.junit.jupiter.api.Assertions.assertTimeoutPreemptively
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.TestFactory
import java.time.Duration
import java.util.concurrent.CancellationException

/** A step is done whole or not at all, in every engine, whatever throws wherever. */
abstract class FailingStepsContract(private val tested: TestedEngines) {
    /** What makes an engine, or none, by the name of the test. */
    protected open val engines: Map<String, () -> CollisionEngine?>
        get() = tested.registry.names.associateWith { name -> { tested.make(name, FixedThreads(3)) } }

    private val kinds: List<(Int) -> Throwable> = listOf(
        { OutOfMemoryError("on purpose, $it") },
        { StackOverflowError("on purpose, $it") },
        { AssertionError("on purpose, $it") },
        { CancellationException("on purpose, $it") },
        { InterruptedException("on purpose, $it") },
    )

    private fun each(check: (FailingCase, String, FailingSteps) -> Unit) = FailingCase.entries.flatMap { case ->
        engines.map { (name, engine) ->
            dynamicTest("$case, $name") {
                assertTimeoutPreemptively(Duration.ofMinutes(2)) {
                    for (seed in SEEDS) {
                        FailingSteps(case, seed, engine).use {
                            check(case, name, it)
                            it.finish()
                        }
                    }
                }
            }
        }
    }

    @TestFactory
    fun `an exception at any call leaves all as it was, and the step can be done again`() = each { case, name, steps ->
        steps.throwAtEachCall()
        val expected = buildSet {
            add("time step")
            add("output")
            if (name != NO_ENGINE) addAll(listOf("restitution", "guard"))
            if (case != FailingCase.GAS) add("in a loop of a force")
        }
        assertTrue(steps.places.containsAll(expected)) { "thrown at ${steps.places} only" }
    }

    @Tag("thorough")
    @TestFactory
    fun `so does whatever else can be thrown`() = each { _, _, steps ->
        for ((k, kind) in kinds.withIndex()) {
            val every = 1 + k
            steps.throwAtEachCall(every, kind)
        }
        assertTrue(steps.failed > 0)
    }

    companion object {
        /** Steps without collisions. */
        const val NO_ENGINE = "no engine"
        private val SEEDS = 11L..<11L + Draws.share(usual = 2, long = 30)
    }
}
