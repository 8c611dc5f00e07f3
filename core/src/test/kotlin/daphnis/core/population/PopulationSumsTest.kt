package daphnis.core.population

import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.permuted
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.lang.management.ManagementFactory
import kotlin.math.sqrt

class PopulationSumsTest {
    private val flow = MeanFlow(normalAxis = 0, flowAxis = 1, rate = -1.5)

    private fun gas(count: Int, id: (Int) -> Int = { it }): Population {
        val random = SeededRandom(4)
        fun column() = DoubleArray(count) { random.nextGaussian() + 0.3 }
        val mass = DoubleArray(count) { 0.1 + random.nextDouble() }
        return Population(
            column(), column(), column(), column(), column(), column(),
            DoubleArray(count) {
                0.1
            },
            mass, IntArray(count, id),
        )
    }

    private fun row(
        p: Population,
        loop: RangeLoop = InlineLoop,
        sums: PopulationSums = PopulationSums(flow, OrbitalFrequencies(1.0), firstBody = 3 * p.size - 30),
    ): List<Double> {
        sums.take(p, loop)
        return listOf(sums.mass, sums.kineticEnergy, sums.particleMass, sums.centreZ, sums.scaleHeight, sums.guidingX) +
            List(3) { sums.momentum(it) } + sums.moments.asList() + sums.kinetic.asList() + sums.mean.asList()
    }

    @Tag("thorough")
    @Test
    fun `every last digit is the same on 1 to 8 threads, in any order of the arrays, and with a reused object`() {
        for (id in listOf<(Int) -> Int>({ it }, { 2 * it }, { 3 * it + 1_000 })) {
            val p = gas(20_000, id)
            val expected = row(p)
            assertTrue(expected.all { it.isFinite() })
            val used = PopulationSums(flow, OrbitalFrequencies(1.0), firstBody = 3 * p.size - 30)
            for (threads in 1..8) {
                FixedPool(threads).use { pool ->
                    for (strategy in LoopStrategy.entries) {
                        val loop = ParallelLoop(pool, strategy)
                        assertEquals(expected, row(p, loop, used)) { "$threads threads, $strategy" }
                        assertEquals(expected, row(p.permuted(threads.toLong()), loop, used)) {
                            "$threads threads, $strategy, permuted"
                        }
                    }
                }
            }
        }
    }

    @Test
    fun `parts of a population merge to the same bits, however many they are and in any order`() {
        val bodies = 5990
        val p = gas(6000)
        val means = Means()
        for (axis in 0..2) {
            means.position[axis] = 0.3
            means.velocity[axis] = 0.1
        }
        means.setSlabs(6000, p.x.min(), p.x.max())
        val expected = merged(p, intArrayOf(0, 6000), means, bodies)
        val random = SeededRandom(8)
        for (count in listOf(2, 3, 10, 500)) {
            val cuts = IntArray(count - 1) { random.nextInt(6001) }.sorted()
            val ends = (listOf(0) + cuts + 6000).toIntArray()
            assertEquals(expected, merged(p.permuted(count.toLong()), ends, means, bodies)) { "$count parts" }
        }
    }

    /** All sums of the parts of [p] between two of [ends] each, merged from the last one on. */
    private fun merged(p: Population, ends: IntArray, means: Means, bodies: Int): List<Double> {
        val first = FirstMoments(0, bodies)
        val central = CentralMoments(flow, bodies).apply { clear(means) }
        for (part in ends.size - 2 downTo 0) {
            first.merge(FirstMoments(0, bodies).apply { add(p, ends[part], ends[part + 1]) })
            val partial = CentralMoments(flow, bodies)
            partial.clear(means)
            partial.add(p, ends[part], ends[part + 1])
            central.merge(partial)
        }
        val fit = FlowFit(flow.flowAxis)
        central.fill(fit)
        val vectors = (0..2).flatMap { listOf(first.momentum(it), first.particleMomentum(it), first.position(it)) }
        return vectors +
            listOf(first.count.toDouble(), first.mass, first.particleMass, first.kineticEnergy) +
            listOf(first.least, first.greatest) + List(6) { central.square(it) } + central.squareOfHeight +
            fit.across + fit.slopes.asList() + fit.slabs.asList()
    }

    @Test
    fun `sums agree with plain ones, bodies and sparse ids or not`() {
        for (id in listOf<(Int) -> Int>({ it }, { 2 * it }, { 40_000 * it })) {
            val p = gas(9000, id)
            val bodies = p.id[8990]
            val sums = PopulationSums(flow, OrbitalFrequencies(1.0), bodies).apply { take(p) }
            val all = 0 until 9000
            val particles = 0 until 8990
            val mass = particles.sumOf { p.mass[it] }
            assertEquals(all.sumOf { p.mass[it] }, sums.mass, 1e-9)
            assertEquals(
                all.sumOf {
                    p.mass[it] * (p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it]) / 2
                },
                sums.kineticEnergy,
                1e-8,
            )
            assertEquals(all.sumOf { p.mass[it] * p.vz[it] }, sums.momentum(2), 1e-9)
            assertEquals(mass, sums.particleMass, 1e-9)
            val w = DoubleArray(9000) { p.vy[it] + 1.5 * p.x[it] }
            val mean = particles.sumOf { p.mass[it] * w[it] } / mass
            val meanX = particles.sumOf { p.mass[it] * p.vx[it] } / mass
            assertEquals(mean, sums.mean[1], 1e-12)
            assertEquals(
                particles.sumOf {
                    p.mass[it] * (w[it] - mean) * (w[it] - mean)
                } / mass,
                sums.kinetic[VelocityMoments.YY],
                1e-11,
            )
            assertEquals(
                particles.sumOf {
                    p.mass[it] * (w[it] - mean) * (p.vx[it] - meanX)
                } / mass,
                sums.kinetic[VelocityMoments.XY],
                1e-11,
            )
            val height = particles.sumOf { p.mass[it] * p.z[it] } / mass
            assertEquals(height, sums.centreZ, 1e-12)
            assertEquals(
                sqrt(
                    particles.sumOf {
                        p.mass[it] * (p.z[it] - height) * (p.z[it] - height)
                    } / mass,
                ),
                sums.scaleHeight,
                1e-12,
            )
            assertEquals(particles.sumOf { p.mass[it] * (4 * p.x[it] + 2 * p.vy[it]) } / mass, sums.guidingX, 1e-12)
        }
    }

    @Test
    fun `the fit agrees with a plain one, line first and slab means of the rest then`() {
        val p = gas(1700)
        val found = VelocityMoments.of(p, flow).moments
        val mass = p.mass.sum()
        fun centred(a: DoubleArray): DoubleArray = (a.indices.sumOf { p.mass[it] * a[it] } / mass).let { mean ->
            DoubleArray(a.size) {
                a[it] -
                    mean
            }
        }
        val x = centred(p.x)
        val u = centred(p.vy)
        val slope = x.indices.sumOf { p.mass[it] * x[it] * u[it] } / x.indices.sumOf { p.mass[it] * x[it] * x[it] }
        for (k in u.indices) u[k] -= slope * x[k]
        val low = x.min()
        val slabs = x.indices.groupBy { ((x[it] - low) / (x.max() - low) * 17).toInt().coerceAtMost(16) }
        val c = u.copyOf()
        for (slab in slabs.values) {
            val mean = slab.sumOf { p.mass[it] * u[it] } / slab.sumOf { p.mass[it] }
            for (k in slab) c[k] -= mean
        }
        val between =
            slabs.values.sumOf { s -> s.sumOf { p.mass[it] * x[it] }.let { it * it } / s.sumOf { p.mass[it] } } /
                x.indices.sumOf { p.mass[it] * x[it] * x[it] }
        val left = 1700 - (1 + slabs.size - between)
        val vx = centred(p.vx)
        assertEquals(
            c.indices.sumOf {
                p.mass[it] * c[it] * c[it]
            } / mass * 1700 / left,
            found[VelocityMoments.YY],
            1e-12,
        )
        assertEquals(
            c.indices.sumOf {
                p.mass[it] * c[it] * vx[it]
            } / mass * 1700 / left,
            found[VelocityMoments.XY],
            1e-12,
        )
        assertEquals(
            vx.indices.sumOf {
                p.mass[it] * vx[it] * vx[it]
            } / mass * 1700 / 1699,
            found[VelocityMoments.XX],
            1e-12,
        )
    }

    @Test
    fun `a row allocates nothing once warm, and ids far apart take no memory by the largest`() {
        val bean = ManagementFactory.getThreadMXBean() as com.sun.management.ThreadMXBean
        val thread = Thread.currentThread().id
        fun allocated(p: Population): Long {
            val sums = PopulationSums(flow, OrbitalFrequencies(1.0))
            sums.take(p)
            val before = bean.getThreadAllocatedBytes(thread)
            repeat(50) { sums.take(p) }
            return bean.getThreadAllocatedBytes(thread) - before
        }
        assertTrue(allocated(gas(10_000)) < 10_000) { "a few bytes of the bean itself at most" }
        val before = bean.getThreadAllocatedBytes(thread)
        PopulationSums(flow).take(gas(3) { it * 1_000_000_000 })
        assertTrue(bean.getThreadAllocatedBytes(thread) - before < 1_000_000)
    }
}
