package daphnis.bench

import daphnis.analysis.order.RadialKey
import daphnis.analysis.order.RadialOrder
import daphnis.analysis.streamline.Streamlines
import daphnis.core.boundary.Box
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
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
import daphnis.analysis.insitu.State as Patch

/**
 * Radial order and streamlines of a large ring patch on one thread: a sort of unordered particles, a sort of particles
 * nearly in order, and streamlines, which include the latter.
 *
 * `java -Xmx6g -jar bench/target/bench-0.2.0.jar AnalysisBenchmark -p count=1000000,10000000`
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 2)
@Measurement(iterations = 3)
@Fork(1)
open class AnalysisBenchmark {
    @Param("1000000", "10000000")
    var count: Int = 0

    private lateinit var state: Patch
    private lateinit var sorted: RadialOrder

    @Setup(Level.Trial)
    fun make() {
        val random = SeededRandom(1)
        fun uniform(half: Double) = DoubleArray(count) { random.nextDouble(-half, half) }
        val x = uniform(1000.0)
        val population = Population(
            x,
            uniform(5000.0),
            uniform(5.0),
            uniform(2.0),
            DoubleArray(count) { -1.5 * x[it] + random.nextDouble(-1.0, 1.0) },
            uniform(2.0),
            DoubleArray(count) { 0.5 },
            DoubleArray(count) { 1.0 },
        )
        state = Patch(population, HillSheet(Box.centred(2000.0, 10000.0, 10.0), 1.0), 0.0, 1.0)
        sorted = RadialOrder().sort(state, RadialKey.X)
    }

    @Benchmark
    open fun sort(): Int = RadialOrder().sort(state, RadialKey.X).order[0]

    @Benchmark
    open fun sortAgain(): Int = sorted.sort(state, RadialKey.X).order[0]

    @Benchmark
    open fun streamlines(): Double = Streamlines.of(state, 360, 40, RadialKey.X, sorted).meanE[0]
}
