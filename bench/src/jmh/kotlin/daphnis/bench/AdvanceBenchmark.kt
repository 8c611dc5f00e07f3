package daphnis.bench

import daphnis.core.Simulation
import org.openjdk.jmh.annotations.AuxCounters
import org.openjdk.jmh.annotations.Benchmark
import org.openjdk.jmh.annotations.BenchmarkMode
import org.openjdk.jmh.annotations.Fork
import org.openjdk.jmh.annotations.Level
import org.openjdk.jmh.annotations.Measurement
import org.openjdk.jmh.annotations.Mode
import org.openjdk.jmh.annotations.OutputTimeUnit
import org.openjdk.jmh.annotations.Param
import org.openjdk.jmh.annotations.Scope
import org.openjdk.jmh.annotations.Setup
import org.openjdk.jmh.annotations.State
import org.openjdk.jmh.annotations.TearDown
import org.openjdk.jmh.annotations.Warmup
import java.util.concurrent.TimeUnit

/**
 * `advance()` over a whole workload: one operation is all its steps, from the same state each time. The counters give
 * collisions and particle-steps of all measured operations together, so nanoseconds per collision are score · 1e6 · Cnt
 * / collisions.
 *
 * `java -jar bench/target/bench-0.2.0.jar AdvanceBenchmark -p engine=ISLANDS,THREAD_POOL -p threads=1,2 -rf json -rff
 * results.json`
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 2)
@Measurement(iterations = 5)
@Fork(1)
open class AdvanceBenchmark {
    @Param
    lateinit var workload: Workload

    @Param("SERIAL", "HORIZON", "ISLANDS", "THREAD_POOL", "ACTORS", "PEKKO")
    lateinit var engine: EngineName

    @Param("1", "2")
    var threads: Int = 1

    private lateinit var start: Workload.Start
    private lateinit var simulation: Simulation

    /** What one operation did. */
    @State(Scope.Thread)
    @AuxCounters(AuxCounters.Type.EVENTS)
    open class Work {
        @JvmField
        var collisions: Long = 0

        @JvmField
        var particleSteps: Long = 0
    }

    @Setup(Level.Trial)
    fun makeStart() {
        start = workload.Start()
    }

    @Setup(Level.Iteration)
    fun makeSimulation() {
        simulation = start.simulation(engine.create(threads))
        // The arrays get their size in the first step, which is not measured.
        simulation.advance()
    }

    @TearDown(Level.Iteration)
    fun close() {
        simulation.close()
    }

    @Benchmark
    open fun advance(work: Work): Double {
        val before = simulation.collisions!!.counters.collisions
        repeat(workload.steps) { simulation.advance() }
        work.collisions = simulation.collisions!!.counters.collisions - before
        work.particleSteps = workload.steps.toLong() * simulation.population.size
        return simulation.time
    }
}
