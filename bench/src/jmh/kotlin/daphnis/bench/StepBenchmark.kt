package daphnis.bench

import daphnis.core.Simulation
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
import org.openjdk.jmh.annotations.Warmup
import java.util.concurrent.TimeUnit

/**
 * One step of an elastic gas in equilibrium, repeated. The state stays in equilibrium, so this shows that a warm step
 * allocates nothing.
 *
 * `java -jar bench/target/bench-0.2.0.jar StepBenchmark -prof gc`
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 5)
@Measurement(iterations = 3, time = 5)
@Fork(1)
open class StepBenchmark {
    @Param("GAS_1E4", "DENSE")
    lateinit var workload: Workload

    @Param("SERIAL")
    lateinit var engine: EngineName

    @Param("1")
    var threads: Int = 1

    private lateinit var simulation: Simulation

    @Setup(Level.Trial)
    fun makeSimulation() {
        simulation = workload.Start().simulation(engine.create(threads))
    }

    @Benchmark
    open fun step(): Double {
        simulation.advance()
        return simulation.time
    }
}
