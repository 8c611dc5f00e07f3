package daphnis.bench

import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.population.MeanFlow
import daphnis.core.population.Population
import daphnis.core.population.PopulationSums
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
 * The sums of one row of `series.csv` and `transport.csv`, of as many spheres as the paper's first system has, in
 * random order.
 *
 * `java -jar bench/target/bench-0.2.0.jar SeriesRowBenchmark -prof gc`
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
open class SeriesRowBenchmark {
    @Param("1", "2")
    var threads: Int = 1

    private lateinit var population: Population
    private lateinit var pool: FixedPool
    private lateinit var loop: ParallelLoop
    private val sums = PopulationSums(MeanFlow(normalAxis = 1, flowAxis = 0, rate = 0.05))

    @Setup(Level.Trial)
    fun make() {
        val random = SeededRandom(1)
        fun column() = DoubleArray(COUNT) { random.nextGaussian() }
        val id = IntArray(COUNT) { it }
        for (k in COUNT - 1 downTo 1) {
            val j = random.nextInt(k + 1)
            id[k] = id[j].also { id[j] = id[k] }
        }
        val one = DoubleArray(COUNT) { 1.0 }
        population = Population(column(), column(), column(), column(), column(), column(), one, one, id)
        pool = FixedPool(threads)
        loop = ParallelLoop(pool, LoopStrategy.DYNAMIC)
    }

    @TearDown(Level.Trial)
    fun close() {
        pool.close()
    }

    @Benchmark
    open fun row(): Double {
        sums.take(population, loop)
        return sums.granularTemperature
    }

    private companion object {
        const val COUNT = 70_736
    }
}
