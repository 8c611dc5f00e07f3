package daphnis.drills

import daphnis.app.allEngines
import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.population.PopulationSums
import daphnis.core.search.Overlap
import daphnis.core.surface.ConstantRestitution
import java.nio.file.Files
import java.nio.file.Path
import java.util.Locale
import java.util.Random
import kotlin.math.abs

/**
 * A dense elastic gas for as many collisions as asked for, on every engine in turn: nothing overlaps, energy stays,
 * memory does not grow.
 */
internal object SoakDrill : Drill {
    override val name = "soak"
    override val what =
        "an elastic gas at filling factor 0.3 for so many collisions on each engine: overlap, energy, memory"
    override val cases = 10_000_000

    override fun run(cases: Int, seed: Long, say: (String) -> Unit): Tally {
        val lost = ArrayList<String>()
        val notes = ArrayList<String>()
        for (engine in allEngines.names) {
            val soaked = soak(engine, cases, seed)
            lost += soaked.lost
            notes += soaked.notes
        }
        return Tally(cases * allEngines.names.size, lost, notes)
    }

    private fun soak(name: String, collisions: Int, seed: Long): Tally {
        val engine = allEngines.create(name, THREADS)!!
        val lost = ArrayList<String>()
        val live = ArrayList<Long>()
        val resident = ArrayList<Long>()
        var deepest = 0.0
        var drift = 0.0
        val forcing = CollisionForcing(ConstantRestitution(1.0), engine = engine)
        val side = EDGE * SPACING
        Simulation(gas(seed), Periodic(Box.centred(side, side, side)), forcing, FixedTimeStep(STEP)).use { simulation ->
            val sums = PopulationSums(simulation.boundary.meanFlow)
            val energy = sums.apply { take(simulation.population, InlineLoop) }.kineticEnergy
            var look = 0
            while (forcing.counters.collisions < collisions) {
                simulation.advance()
                if (forcing.counters.collisions < collisions.toLong() * look / LOOKS) continue
                look++
                deepest =
                    maxOf(deepest, Overlap.deepest(simulation.population, simulation.boundary, simulation.time).depth)
                sums.take(simulation.population, InlineLoop)
                drift = maxOf(drift, abs(sums.kineticEnergy / energy - 1))
                live += liveBytes()
                resident += residentBytes()
            }
        }
        if (deepest > MOST_OVERLAP) lost += "$name: spheres overlap by $deepest of their diameter"
        if (drift > MOST_DRIFT) lost += "$name: energy has changed by $drift of itself"
        val liveGrowth = Growth.of(live)
        val residentGrowth = Growth.of(resident)
        if (liveGrowth.steady > MOST_LIVE) lost += "$name: live memory grows, by ${liveGrowth.steady} bytes"
        if (liveGrowth.whole > MOST_STEPS) lost += "$name: live memory has grown by ${liveGrowth.whole} bytes"
        if (residentGrowth.whole > MOST_RESIDENT) {
            lost += "$name: resident memory has grown by ${residentGrowth.whole} bytes"
        }
        val text = "$name: %d collisions, overlap %.1e, energy %.1e, " +
            "live memory %+d kB, resident %+d kB after a sixth of the way"
        return Tally(
            collisions,
            lost,
            listOf(
                text.format(
                    Locale.ROOT,
                    forcing.counters.collisions,
                    deepest,
                    drift,
                    liveGrowth.whole / KB,
                    residentGrowth.whole / KB,
                ),
            ),
        )
    }

    private fun gas(seed: Long): Population {
        val random = Random(seed)
        val n = EDGE * EDGE * EDGE
        fun lattice(stride: Int) = DoubleArray(n) { (it / stride % EDGE + 0.5 - EDGE / 2.0) * SPACING }
        fun speeds() = DoubleArray(n) { random.nextGaussian() }
        return Population(
            lattice(1),
            lattice(EDGE),
            lattice(EDGE * EDGE),
            speeds(),
            speeds(),
            speeds(),
            DoubleArray(n) {
                0.5
            },
            DoubleArray(n) { 1.0 },
        )
    }

    private fun liveBytes(): Long {
        System.gc()
        return Runtime.getRuntime().let { it.totalMemory() - it.freeMemory() }
    }

    /** 0 where the system does not say. */
    private fun residentBytes(): Long {
        val status = Path.of("/proc/self/status")
        if (!Files.exists(status)) return 0
        return Files.readAllLines(status).first { it.startsWith("VmRSS:") }.filter { it.isDigit() }.toLong() * KB
    }

    private const val THREADS = 2
    private const val EDGE = 20

    /** π/6 / spacing³ = 0.3. */
    private const val SPACING = 1.204
    private const val STEP = 0.05
    private const val LOOKS = 60
    private const val KB = 1024L

    /** Of the sum of radii; round-off at contacts. */
    private const val MOST_OVERLAP = 1e-10
    private const val MOST_DRIFT = 1e-9

    /** Of growth that goes on and on. */
    private const val MOST_LIVE = 2_000_000L

    /** Of all growth: also of an array that is made larger once, or of what others in this JVM keep. */
    private const val MOST_STEPS = 20_000_000L
    private const val MOST_RESIDENT = 60_000_000L
}
