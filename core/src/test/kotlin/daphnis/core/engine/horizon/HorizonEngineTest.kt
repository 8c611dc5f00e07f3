package daphnis.core.engine.horizon

import daphnis.core.Engines
import daphnis.core.FixedTimeStep
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.CoreEngines
import daphnis.core.engine.Draws
import daphnis.core.engine.FixedThreads
import daphnis.core.engine.QuickerWay
import daphnis.core.engine.QuickerWay.Companion.MEASURED
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.assertSameStep
import daphnis.core.engine.failure
import daphnis.core.engine.horizon.HorizonSteps.Companion.SHARED
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.engine.lists.ListTuning
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.simulationOf
import daphnis.core.step.CollisionStep
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.util.concurrent.atomic.AtomicInteger
import java.util.function.LongSupplier

class HorizonEngineTest {
    @Test
    fun `every layout of epochs gives the serial engine's bits after every step, whatever is done between steps`() {
        var inEpochs = 0L
        var strays = 0L
        var collisions = 0L
        var shared = 0L
        var reopened = 0L
        var rounds = 0L
        var bounces = 0L
        var inWalls = 0L
        val settings = FixedThreads(1)
        for (seed in 1..DRAWS) {
            val draw = LongDraw(seed)
            val made = CoreEngines.make("horizon", settings) as HorizonEngine
            // Filters take turns, and so do numbers of threads.
            val filter = if (seed % 2 == 0L) ScalarFilter else LineFilter.BEST
            val pool = FixedPool(THREADS[(seed % THREADS.size).toInt()])
            val engine = HorizonEngine(pool, 0, made.tuning, filter, ListTuning.NEVER, trial(seed), islands(pool))
            val serial = draw.simulation(SerialEngine())
            val horizon = draw.simulation(engine)
            for (step in 1..STEPS) {
                val story = "$draw, step $step"
                assertEquals(failure(serial), failure(horizon)) { story }
                assertSameStep(serial, horizon, story)
                assertSameLastCollisions(serial, horizon, story)
                if (draw.isMeddled) draw.meddle(step, listOf(serial, horizon))
            }
            engine.close()
            inEpochs += engine.epochSteps - engine.epochs
            strays += engine.strays
            shared += engine.shared.steps
            reopened += engine.shared.reopened
            rounds += engine.shared.rounds
            collisions += serial.collisions!!.counters.collisions
            bounces += serial.collisions!!.counters.wallCollisions
            if (draw.boundary is Walls) inWalls += engine.epochSteps - engine.epochs
        }
        println("$collisions collisions, $inEpochs steps without a search for all, $strays spheres off their lines")
        println("$bounces at walls, $inWalls steps there without a search for all")
        println("$shared steps shared among groups, $reopened collisions anew in $rounds rounds")
        // A margin that is too small by a radius loses one collision in some thousand.
        assertTrue(collisions > 100 * DRAWS) { "$collisions collisions" }
        assertTrue(bounces > 10 * DRAWS && inWalls > DRAWS / 2) { "$bounces at walls, in $inWalls steps" }
        assertTrue(inEpochs > STEPS * DRAWS / 5) { "$inEpochs steps" }
        // They are in few of the draws.
        if (DRAWS >= 75) assertTrue(strays > DRAWS) { "$strays strays" }
        assertTrue(shared > STEPS * DRAWS / 3) { "$shared steps" }
        assertTrue(reopened > DRAWS && rounds > DRAWS) { "$reopened spheres in $rounds rounds" }
    }

    @Test
    fun `long steps in windows give the serial engine's bits after every step, whatever is done between steps`() {
        var collisions = 0L
        var bounces = 0L
        var steps = 0L
        var windows = 0L
        var crossings = 0L
        var shared = 0L
        var reopened = 0L
        val settings = FixedThreads(1)
        for (seed in 1..DRAWS / 2) {
            val draw = LongDraw(seed, longer = 1.0 + seed % 6)
            val made = CoreEngines.make("horizon", settings) as HorizonEngine
            val tuning = made.tuning!!.inWindows(2 + (seed % 7).toInt())
            val filter = if (seed % 2 == 0L) ScalarFilter else LineFilter.BEST
            val pool = FixedPool(THREADS[(seed % THREADS.size).toInt()])
            val engine = HorizonEngine(pool, 0, tuning, filter, ListTuning.NEVER, trial(seed), islands(pool))
            val serial = draw.simulation(SerialEngine())
            val horizon = draw.simulation(engine)
            for (step in 1..STEPS / 2) {
                val story = "$draw, ${seed % 6} longer, step $step"
                assertEquals(failure(serial), failure(horizon)) { story }
                assertSameStep(serial, horizon, story)
                assertSameLastCollisions(serial, horizon, story)
                if (draw.isMeddled) draw.meddle(step, listOf(serial, horizon))
            }
            engine.close()
            collisions += serial.collisions!!.counters.collisions
            bounces += serial.collisions!!.counters.wallCollisions
            steps += engine.epochSteps
            windows += engine.windows
            shared += engine.shared.steps
            reopened += engine.shared.reopened
            val p = serial.population
            if (draw.boundary is HillSheet) crossings += p.id.count { p.boxesCrossed(it, 0) != 0 }
        }
        println(
            "$collisions collisions, $bounces at walls, in $steps steps of $windows more windows; $shared shared, $reopened reopened",
        )
        assertTrue(collisions > 100 * DRAWS) { "$collisions collisions" }
        assertTrue(bounces > 10 * DRAWS) { "$bounces at walls" }
        assertTrue(steps > STEPS * DRAWS / 6 && windows > 3 * steps) { "$steps steps, $windows windows" }
        assertTrue(shared > steps / 4 && reopened > 3 * DRAWS) { "$shared steps shared, $reopened spheres reopened" }
        assertTrue(crossings > DRAWS) { "$crossings through sliding faces" }
    }

    @Tag("thorough")
    @Test
    fun `a margin too small by a third of the way is noticed, where all that fly are as fast as members may be`() {
        for (seed in 1L..6L) {
            for (tuning in listOf(TIGHT, TIGHT.inWindows(3))) {
                val dt = 60.0 / tuning.steps
                val serial = simulationOf(beams(seed), Periodic(LONG_BOX), dt)
                val engine = HorizonEngine(FixedPool(1), 0, tuning)
                val horizon = simulationOf(beams(seed), Periodic(LONG_BOX), dt, engine = engine)
                for (step in 1..tuning.steps) {
                    serial.advance()
                    horizon.advance()
                    assertSameStep(serial, horizon, "seed $seed, step $step of ${tuning.steps}")
                }
                assertEquals(1L, engine.epochs)
                assertTrue(serial.collisions!!.counters.collisions > 500)
            }
        }
    }

    /** Half of the spheres are at rest; the others fly along x, as fast one as the other. */
    private fun beams(seed: Long): Population {
        val random = SeededRandom(seed)
        val n = 16 * 64
        fun near(place: Double) = place + random.nextDouble(-0.4, 0.4)
        val still = DoubleArray(n)
        return Population(
            DoubleArray(n) { near(5.0 * (it / 16) - 157.5) },
            DoubleArray(n) { near(5.0 * (it % 4) - 7.5) },
            DoubleArray(n) { near(5.0 * (it / 4 % 4) - 7.5) },
            DoubleArray(n) { if (random.nextInt(2) == 0) 0.0 else 1.0 - 2 * random.nextInt(2) },
            still,
            still.copyOf(),
            DoubleArray(n) { 1.0 },
            DoubleArray(n) { 1.0 },
        )
    }

    @Test
    fun `in free flight all are searched once an epoch, and a sphere that comes back through a face keeps its line`() {
        val engine = HorizonEngine(FixedPool(1), 0, HorizonTuning(4))
        val simulation = gas(engine)
        repeat(20) { simulation.advance() }
        val p = simulation.population
        assertTrue(p.id.count { p.boxesCrossed(it, 0) != 0 } > 10) { "hardly any crossed a face" }
        assertTrue(simulation.collisions!!.counters.collisions > 50)
        assertEquals(20L, engine.epochSteps)
        assertEquals(5L, engine.epochs)
        assertEquals(0L, engine.strays)
    }

    @Tag("thorough")
    @Test
    fun `a small system gets the quick filter after so many steps, however long its epochs are`() {
        var asked = 0
        val quick = object : LineFilter by ScalarFilter {
            override fun near(state: FloatArray, query: LineQuery, first: Int, end: Int, into: KeptLines) {
                asked++
                ScalarFilter.near(state, query, first, end, into)
            }
        }
        val engine = HorizonEngine(FixedPool(1), 1, HorizonTuning(16), quick, ListTuning.NEVER, null, null)
        val simulation = gas(engine)
        val spheres = simulation.population.size
        while (simulation.step * spheres < 1_900_000) simulation.advance()
        assertEquals(0, asked)
        while (simulation.step * spheres < 2_100_000) simulation.advance()
        assertTrue(asked > spheres) { "$asked searches" }
    }

    @Tag("thorough")
    @Test
    fun `a short run is the serial engine's, and a long one takes epochs`() {
        var others = 0
        fun run(threads: Int, toCome: (step: Int) -> Long): HorizonEngine {
            val serial = SerialEngine()
            val other = object : CollisionEngine by serial {
                override fun advance(step: CollisionStep) {
                    others++
                    serial.advance(step)
                }
            }
            val engine = HorizonEngine(FixedPool(threads), other = other)
            Prospect.IN_THIS_JVM.set(0)
            gas(engine, layers = 64).use { simulation ->
                repeat(6) { step ->
                    simulation.collisions!!.toCome = toCome(step)
                    simulation.advance()
                }
            }
            return engine
        }
        for (threads in 1..3) {
            others = 0
            val short = run(threads) { 5L - it }
            assertEquals(0L, short.epochSteps)
            assertTrue(short.isShort)
            assertEquals(0, others)
            // Two threads are one up to the longer of the two bounds.
            val long = run(threads) { 10_000L - it }
            assertTrue(long.epochSteps > 0)
            assertEquals(threads <= 2, long.isShort)
            val veryLong = run(threads) { 10_000_000L - it }
            assertTrue(veryLong.epochSteps > 0 && !veryLong.isShort)
            assertTrue(run(threads) { CollisionStep.UNKNOWN }.epochSteps > 0)
        }
        // One whose end is not known at first.
        assertTrue(run(2) { if (it == 0) 0 else 10_000_000L }.epochSteps > 0)
    }

    @Test
    fun `threads share steps and one takes them alone in turns while it is tried, with the same bits`() {
        val serial = gas(SerialEngine(), apart = 4.0, layers = 400)
        // A clock by which each step takes half of what is measured: the ways change all the time.
        var now = 0L
        val trial = trial(Long.MAX_VALUE) {
            now += MEASURED / 2
            now
        }
        val engine = HorizonEngine(
            FixedPool(2),
            HorizonSteps.WORTH_SPHERES,
            null,
            ScalarFilter,
            ListTuning.NEVER,
            trial,
            null,
        )
        var alone = 0
        var shared = 0
        gas(engine, apart = 4.0, layers = 400).use { simulation ->
            while (simulation.step < 80) {
                val before = engine.shared.steps
                val isAlone = trial.way != SHARED
                simulation.advance()
                serial.advance()
                assertTrue(!isAlone || engine.shared.steps == before)
                if (engine.shared.steps > before) shared++ else alone++
                val at = simulation.step
                assertEquals(stateDigest(serial.population), stateDigest(simulation.population)) { "after step $at" }
            }
        }
        assertEquals(80L, engine.epochSteps)
        // So there are changes in the middle of an epoch.
        assertTrue(engine.epochs < 40) { "${engine.epochs} epochs" }
        assertTrue(alone > 15 && shared > 15) { "$alone alone, $shared shared" }
    }

    @Test
    fun `steps that are not taken in epochs are measured as well, and light loops after a step follow`() {
        // Dense enough for lists, and for another engine where there are none.
        for (lists in listOf(ListTuning.ALWAYS, ListTuning.NEVER)) {
            var now = 0L
            val trial = trial(Long.MAX_VALUE) {
                now += MEASURED
                now
            }
            val engine = HorizonEngine(FixedPool(2), HorizonSteps.WORTH_SPHERES, null, ScalarFilter, lists, trial, null)
            val serial = gas(SerialEngine(), apart = 1.85)
            gas(engine, apart = 1.85).use { simulation ->
                val ways = HashSet<Boolean>()
                repeat(30) {
                    val isAlone = trial.way != SHARED
                    ways += isAlone
                    simulation.advance()
                    serial.advance()
                    val pieces = AtomicInteger()
                    engine.loop.runLight(10_000) { _, _, _ -> pieces.incrementAndGet() }
                    assertEquals(isAlone, pieces.get() == 1)
                    engine.loop.run(10_000) { _, _, _ -> pieces.incrementAndGet() }
                    assertTrue(pieces.get() > 5)
                }
                assertEquals(setOf(true, false), ways)
                assertEquals(0L, engine.epochSteps)
                assertEquals(stateDigest(serial.population), stateDigest(simulation.population))
            }
        }
    }

    @Test
    fun `another engine is tried where it may be quicker, and not in a step that would take it very long`() {
        for ((dt, isTried) in listOf(0.1 to true, 3.0 to false)) {
            var now = 0L
            // By this clock another engine is quicker.
            lateinit var trial: QuickerWay
            trial =
                trial(MEASURED) {
                    (MEASURED / if (trial.way == HorizonSteps.OTHER) 4 else 2).let {
                        now += it
                        now
                    }
                }
            val engine =
                HorizonEngine(
                    FixedPool(1),
                    HorizonSteps.WORTH_SPHERES,
                    null,
                    ScalarFilter,
                    ListTuning.NEVER,
                    trial,
                    null,
                )
            gas(engine, apart = 3.0, dt = dt).use { simulation ->
                repeat(30) { simulation.advance() }
                assertTrue(engine.epochSteps > 0) { "dt $dt" }
                assertEquals(isTried, engine.epochSteps < 30) { "dt $dt: ${engine.epochSteps} of 30" }
            }
        }
    }

    @Test
    fun `many spheres are shared from the beginning, few are not`() {
        for ((layers, isShared) in listOf(620 to false, 630 to true)) {
            val engine = Engines.horizon(2)
            gas(engine, apart = 2.75, layers = layers).use { simulation ->
                // So few steps are no trial.
                repeat(3) { simulation.advance() }
                assertTrue(engine.epochSteps > 0)
                assertEquals(isShared, engine.shared.steps > 0) { "${simulation.population.size} spheres" }
            }
        }
    }

    @Test
    fun `without a fixed layout a dilute gas is taken in epochs of several steps, and a dense one serially`() {
        val dilute = HorizonEngine(FixedPool(1), fewest = 0)
        val simulation = gas(dilute)
        repeat(30) { simulation.advance() }
        assertEquals(30L, dilute.epochSteps)
        assertTrue(dilute.epochs <= 15) { "${dilute.epochs} epochs" }
        val dense = HorizonEngine(FixedPool(1), fewest = 0)
        val crowd = gas(dense, apart = 1.85)
        repeat(30) { crowd.advance() }
        assertEquals(0L, dense.epochSteps)
        assertTrue(crowd.collisions!!.counters.collisions > 3000)
    }

    @Test
    fun `without a fixed layout a long step is taken in windows, in a dense gas too`() {
        for ((apart, dt, threads) in listOf(Triple(3.0, 1.6, 1), Triple(3.0, 1.2, 2), Triple(2.0, 0.8, 1))) {
            val serial = simulationOf(gas(SerialEngine(), apart).population, periodic(apart), dt)
            val engine = HorizonEngine(FixedPool(threads), fewest = 0)
            val long = simulationOf(gas(SerialEngine(), apart).population, periodic(apart), dt, engine = engine)
            for (step in 1..4) {
                serial.advance()
                long.advance()
                assertSameStep(serial, long, "step $step of $dt, $apart apart")
            }
            assertTrue(engine.windows >= engine.epochSteps && engine.epochSteps > 0) {
                "${engine.windows} more windows, ${engine.epochSteps} steps"
            }
            engine.close()
        }
    }

    private fun assertSameLastCollisions(expected: Simulation, actual: Simulation, story: String) {
        fun times(s: Simulation) = s.population.run { (0 until size).associate { id[it] to lastCollision[it] } }
        assertEquals(times(expected), times(actual)) { story }
    }

    private fun periodic(apart: Double) = Periodic(Box.centred(8 * apart, 8 * apart, 8 * apart))

    @Test
    fun `where nearly all collide, groups whose clusters are dropped over and over give the serial engine's bits`() {
        var reopened = 0L
        for (seed in 1..DENSE_DRAWS) {
            val random = SeededRandom(seed)
            val apart = random.nextDouble(1.9, 2.4)
            val layers = 4 + random.nextInt(8)
            val tuning = HorizonTuning(1 + random.nextInt(3))
            val engine = HorizonEngine(FixedPool(2 + random.nextInt(4)), 0, tuning)
            val serial = gas(SerialEngine(), apart, layers, seed)
            val dense = gas(engine, apart, layers, seed)
            for (step in 1..4) {
                serial.advance()
                dense.advance()
                assertSameStep(serial, dense, "seed $seed, step $step")
            }
            reopened += engine.shared.reopened
            engine.close()
        }
        println("$reopened spheres of dropped clusters")
        assertTrue(reopened > 100 * DENSE_DRAWS) { "$reopened spheres" }
    }

    @Test
    fun `a step in which groups undo more than they have done is another engine's`() {
        val serial = gas(SerialEngine(), apart = 2.1, layers = 64)
        val engine = HorizonEngine(FixedPool(2), tuning = HorizonTuning(2))
        val crowd = gas(engine, apart = 2.1, layers = 64)
        for (step in 1..10) {
            serial.advance()
            crowd.advance()
            assertSameStep(serial, crowd, "step $step")
        }
        assertTrue(engine.shared.reopened > 0)
        assertTrue(engine.shared.steps < 5) { "${engine.shared.steps} steps of groups" }
        assertEquals(0L, crowd.collisions!!.counters.causalityReplays)
        engine.close()
    }

    @Test
    fun `groups whose work had mostly to be joined are not asked in the next epochs`() {
        // A pile of flat layers, of which the groups get a half each: larger borders than is expected.
        val engine = HorizonEngine(
            FixedPool(2),
            HorizonSteps.WORTH_SPHERES,
            null,
            LineFilter.BEST,
            ListTuning.NEVER,
            null,
            null,
        )
        val pile = gas(engine, layers = 64)
        repeat(40) { pile.advance() }
        assertTrue(engine.shared.reopened > 0)
        assertTrue(engine.shared.steps in 1..20) { "${engine.shared.steps} steps of groups" }
        engine.close()
    }

    /** 400 spheres a few radii apart in a sheet with a [perturbation], by the serial engine and by one on epochs. */
    private fun onCurvedPaths(perturbation: Double, steps: Int): HorizonEngine {
        val random = SeededRandom(5)
        val n = 400
        fun gauss() = DoubleArray(n) { 0.05 * random.nextGaussian() }
        val sheet = HillSheet(Box.centred(80.0 / (1 - perturbation), 80.0, 20.0), 1.0, perturbation = perturbation)
        val x = DoubleArray(n) { 4.0 * (it % 20) - 38 }
        val start = Population(
            x,
            DoubleArray(n) { 4.0 * (it / 20) - 38 },
            gauss(),
            gauss(),
            gauss().also { for (k in 0 until n) it[k] -= 1.5 * x[k] },
            gauss(),
            DoubleArray(n) { 1.0 },
            DoubleArray(n) { 1.0 },
        )
        val engine = HorizonEngine(FixedPool(1), fewest = 0)
        fun simulation(engine: CollisionEngine): Simulation {
            val forcing = CollisionForcing(ConstantRestitution(0.5), engine = engine, recordCollisions = true)
            return Simulation(start.copy(), sheet, forcing, FixedTimeStep(0.03), listOf(HillFrame(1.0)))
        }
        val serial = simulation(SerialEngine())
        val horizon = simulation(engine)
        for (step in 1..steps) {
            serial.advance()
            horizon.advance()
            assertSameStep(serial, horizon, "step $step")
        }
        return engine
    }

    @Test
    fun `where spheres fly on curved paths, the layout is found with which they keep to their lines`() {
        val engine = onCurvedPaths(0.0, 300)
        assertTrue(engine.epochSteps > 200) { "${engine.epochSteps} steps" }
        assertTrue(engine.epochs < 150) { "${engine.epochs} epochs" }
        assertTrue(engine.strays > 0)
    }

    @Test
    fun `where images come nearer no step is taken in an epoch`() {
        assertEquals(0L, onCurvedPaths(0.3, 60).epochSteps)
    }

    @Test
    fun `between walls, spheres are reflected in epochs of several steps, by groups too`() {
        for (threads in listOf(1, 3)) {
            val serial = simulationOf(gas(SerialEngine()).population, Walls(BOX, 0.9), 0.1)
            val engine = HorizonEngine(FixedPool(threads), 0, HorizonTuning(4))
            val walled = simulationOf(gas(SerialEngine()).population, Walls(BOX, 0.9), 0.1, engine = engine)
            for (step in 1..24) {
                serial.advance()
                walled.advance()
                assertSameStep(serial, walled, "step $step on $threads")
            }
            assertEquals(24L, engine.epochSteps)
            assertTrue(engine.epochs <= 8) { "${engine.epochs} epochs" }
            val counters = walled.collisions!!.counters
            assertTrue(counters.wallCollisions > 200) { "${counters.wallCollisions} at walls" }
            assertEquals(serial.collisions!!.counters.wallCollisions, counters.wallCollisions)
            assertEquals(threads > 1, engine.shared.steps > 0)
            engine.close()
        }
    }

    @Test
    fun `few spheres make no epochs, and a closed engine no step`() {
        val few = HorizonEngine(FixedPool(1), fewest = 1000)
        repeat(3) { gas(few).advance() }
        assertEquals(0L, few.epochSteps)
        val simulation = gas(few)
        few.close()
        assertTrue("closed" in failure(simulation)!!)
    }

    @Test
    fun `a step that is taken back is done again in the same bits, in the same epoch or a new one`() {
        val serial = gas(SerialEngine())
        val engine = HorizonEngine(FixedPool(1), 0, HorizonTuning(5))
        var isBroken = false
        val p = gas(engine).population
        val horizon = Simulation(
            p,
            Periodic(BOX),
            gas(engine).collisions,
            { _ -> 0.1 },
            outputs = listOf(
                object : Output {
                    override fun write(simulation: Simulation) {
                        if (isBroken) throw ArithmeticException("on purpose")
                    }
                },
            ),
        )
        for (step in 1..12) {
            isBroken = step % 3 == 0
            if (isBroken) assertTrue("on purpose" in failure(horizon)!!)
            isBroken = false
            serial.advance()
            horizon.advance()
            assertSameStep(serial, horizon, "step $step")
        }
        assertTrue(engine.epochSteps > 12)
    }

    /** In every third draw steps change hands all the time, by a clock that runs as it likes. */
    private fun trial(seed: Long): QuickerWay? {
        if (seed % 3 != 0L) return null
        val random = SeededRandom(seed)
        var now = 0L
        return trial(MEASURED) {
            now += random.nextInt(MEASURED.toInt())
            now
        }
    }

    /** Another engine is tried after [other] nanoseconds. */
    private fun trial(other: Long, clock: LongSupplier) = QuickerWay(longArrayOf(other, MEASURED, MEASURED), clock)

    private fun islands(pool: FixedPool) = if (pool.threads == 1) null else IslandsEngine(pool, fewest = 0)

    private fun gas(
        engine: CollisionEngine,
        apart: Double = 3.0,
        layers: Int = 8,
        seed: Long = 3,
        dt: Double = 0.1,
    ): Simulation {
        val random = SeededRandom(seed)
        val n = 64 * layers
        fun gauss() = DoubleArray(n) { random.nextGaussian() }
        val start = Population(
            DoubleArray(n) { apart * (it % 8 - 3.5) },
            DoubleArray(n) { apart * (it / 8 % 8 - 3.5) },
            DoubleArray(n) { apart * (it / 64 - (layers - 1) / 2.0) },
            gauss(),
            gauss(),
            gauss(),
            DoubleArray(n) { 0.9 },
            DoubleArray(n) { 1.0 },
        )
        val edge = 8 * apart
        return simulationOf(start, Periodic(Box.centred(edge, edge, layers * apart)), dt, engine = engine)
    }

    private companion object {
        val DRAWS = Draws.share(usual = 300, long = 2000)
        val DENSE_DRAWS = Draws.share(usual = 60, long = 500)
        const val STEPS = 20
        val THREADS = intArrayOf(1, 2, 3, 2, 5, 9)
        val BOX = Box.centred(24.0, 24.0, 24.0)
        val LONG_BOX = Box.centred(320.0, 20.0, 20.0)

        /** Half the spheres of [beams] fly, so that the bound along x is hardly more than their speed. */
        val TIGHT = HorizonTuning(6, classBound = 1.55, deviation = 0.0, cellsAlong = 8.0)
    }
}
