package daphnis.app.sweep

import daphnis.core.Engines
import daphnis.core.format.FormatException
import daphnis.core.input.InputException
import daphnis.core.run.Summary
import daphnis.core.scenario.BuiltIn
import kotlinx.serialization.json.JsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.Callable
import java.util.concurrent.CountDownLatch
import java.util.concurrent.Executors

class SweepWorkTest {
    @TempDir
    lateinit var folder: Path

    private val plan = SweepPlan.of(listOf("restitution.coefficient=0.5,0.9", "until=3", "particles.count=100"), "1,2")

    private class Told : SweepTeller {
        val parts = ArrayList<Double>()

        override fun at(name: String, fraction: Double) {
            parts += fraction
        }

        override fun busy(name: String) = Unit

        override fun notice(name: String, line: String) = Unit
    }

    private fun work(out: String, teller: SweepTeller = Told(), cancelled: () -> Boolean = { false }) = SweepWork(
        SweepDirectory(folder.resolve(out)),
        SharedCores(Engines, 1),
        { BuiltIn.scenario("cooling-gas", it.settings + "seed=${it.seed}") },
        "cooling-gas",
        null,
        teller,
        { it.message.orEmpty() },
        { _, _, _, _ -> },
        cancelled,
    )

    private fun digest(out: String, run: PlannedRun) =
        Summary.read(folder.resolve("$out/runs/${run.name}/summary.json")).stateDigest

    @Test
    fun `a run that was cut short goes on where it was, to the same bits, and one that is finished is left alone`() {
        val run = plan.runs.last()
        val whole = work("whole").carryOut(run)!!
        var steps = 0
        assertNull(work("cut") { ++steps > 12 }.carryOut(run))
        val told = Told()
        val rest = work("cut", told).carryOut(run)!!
        assertTrue(told.parts.first() in 0.3..0.5 && told.parts.last() == 1.0) { "${told.parts}" }
        assertEquals(digest("whole", run), digest("cut", run))
        assertEquals(whole.numbers.map { it.value }, rest.numbers.map { it.value })
        val again = Told()
        val before = Files.getLastModifiedTime(folder.resolve("cut/runs/${run.name}/checkpoint"))
        assertEquals(rest.numbers.map { it.value }, work("cut", again).carryOut(run)!!.numbers.map { it.value })
        assertEquals(listOf(1.0), again.parts)
        assertEquals(before, Files.getLastModifiedTime(folder.resolve("cut/runs/${run.name}/checkpoint")))
    }

    @Test
    fun `what another process noted of a run while this one was at it is gone when it is finished`() {
        val run = plan.runs[0]
        val directory = SweepDirectory(folder.resolve("busy"))
        val result = work("busy") { false.also { directory.noteFailure(run.name, "another process is at it") } }
        assertNull(result.carryOut(run)!!.failure)
        assertNull(directory.failure(run.name))
    }

    @Test
    fun `nothing is begun after it was cancelled`() {
        assertNull(work("none") { true }.carryOut(plan.runs[0]))
        assertTrue(!Files.exists(folder.resolve("none")))
    }

    @Test
    fun `a finished run whose summary was edited has failed, and the reason names the file`() {
        val run = plan.runs[0]
        work("a").carryOut(run)
        val summary = folder.resolve("a/runs/${run.name}/summary.json")
        Files.writeString(summary, Files.readString(summary).replace("\"particles\": 100", "\"particles\": 101"))
        val result = work("a").carryOut(run)!!
        assertTrue("summary.json" in result.failure!!) { result.failure!! }
        assertTrue(result.numbers.isEmpty())
    }

    private fun record(scenario: String, keys: List<SweptKey>, seeds: List<Long>?) =
        SweepRecord(JsonPrimitive(scenario), keys, seeds, "name")

    @Test
    fun `of processes that begin together one writes the record, and the others compare theirs`() {
        for (draw in 1..20) {
            val directory = SweepDirectory(folder.resolve("shared-$draw"))
            val start = CountDownLatch(1)
            val pool = Executors.newFixedThreadPool(6)
            val outcomes = (0 until 6).map { k ->
                pool.submit(
                    Callable {
                        start.await()
                        // A third of them are of another sweep.
                        runCatching {
                            directory.join(
                                record(
                                    "scenario",
                                    plan.keys,
                                    if (k % 3 ==
                                        2
                                    ) {
                                        null
                                    } else {
                                        plan.seeds
                                    },
                                ),
                            )
                        }
                    },
                )
            }
            start.countDown()
            val refused = outcomes.map { it.get() }.map { it.exceptionOrNull() }
            pool.shutdown()
            val isOther = directory.known().difference(record("scenario", plan.keys, null)) == null
            for ((k, e) in refused.withIndex()) {
                assertEquals((k % 3 == 2) == isOther, e == null) { "$draw: $k: $e" }
                assertTrue(e == null || e is InputException && "--seeds was" in e.message!!) { "$e" }
            }
            assertEquals(listOf("sweep.json"), directory.path.toFile().list()!!.toList())
        }
    }

    @Test
    fun `a directory holds one sweep at a time, and says where another differs`() {
        val a = SweepDirectory(folder.resolve("a"))
        val record = record("scenario", plan.keys, plan.seeds)
        a.claim(record).use {
            val e = assertThrows(InputException::class.java) { a.claim(record) }
            assertTrue("another process" in e.message!!)
        }
        a.claim(record).close()
        for ((other, why) in listOf(
            record("scenario", plan.keys.take(2), plan.seeds) to
                "--set particles.count was 100 and is not given",
            record("scenario", plan.keys.reversed(), plan.seeds) to "in the order",
            record("scenario", plan.keys, null) to "--seeds was 1,2 and is not given",
            record("scenario", plan.keys, (1L..4).toList()) to "--seeds was 1,2 and is 1..4",
            record("another", plan.keys, plan.seeds) to "was \"scenario\" and is \"another\"",
            record("another", plan.keys.take(2), null) to
                "\"another\", --set particles.count was 100 and is not given, " +
                "--seeds was 1,2 and is not given; repeat",
        )) {
            val e = assertThrows(InputException::class.java) { a.claim(other) }
            assertTrue(why in e.message!!) { e.message!! }
        }
        Files.writeString(folder.resolve("a/sweep.json"), "{}")
        assertThrows(FormatException::class.java) { a.claim(record) }
    }
}
