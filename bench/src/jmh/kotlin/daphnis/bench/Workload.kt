package daphnis.bench

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Periodic
import daphnis.core.collision.NoGuard
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.population.Population
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.surface.ConstantRestitution

/**
 * What the engines are compared on. Each begins in the same state every time and advances [steps] steps.
 *
 * | | |
 * |---|---|
 * | PAPER_1, PAPER_2, PAPER_3 | the runs of the paper's figures, all 30 time units |
 * | CLUMPED | 1e5 elastic spheres that start at φ = 0.3 in the lower corner of a box eight times as long each way |
 * | DENSE | 1e5 elastic spheres at φ = 0.45, molten, 0.6 τ |
 * | GAS_1E4, GAS_1E5, GAS_1E6 | elastic gases at φ = 0.1, steps of 0.1 τ |
 * | RING_1E5, RING_1E6 | the built-in ring patch, steady, copied to about that number; 198 steps per orbit |
 * | WAKES | the built-in self-gravity wakes, 1,476 particles, 1000 steps per orbit |
 * | MOONLET | the built-in moonlet, 60,000 particles, from its start |
 */
enum class Workload(val dt: Double, val steps: Int, private val make: () -> ScenarioSetup) {
    PAPER_1(0.1, 300, { builtIn("paper-figure-1") }),
    PAPER_2(0.1, 300, { builtIn("paper-figure-2") }),
    PAPER_3(0.3, 100, { builtIn("paper-figure-3") }),
    DENSE(0.03, 20, { gas(100_000, 0.45, "lattice") }),
    CLUMPED(0.05, 20, { clump(100_000, 0.3) }),
    GAS_1E4(0.1, 100, { gas(10_000, 0.1, "random") }),
    GAS_1E5(0.1, 20, { gas(100_000, 0.1, "random") }),
    GAS_1E6(0.1, 5, { gas(1_000_000, 0.1, "random") }),
    RING_1E5(RING_STEP, 20, { ring(6) }),
    RING_1E6(RING_STEP, 5, { ring(19) }),
    WAKES(2 * Math.PI / WAKES_OMEGA / 1000, 200, { builtIn("self-gravity-wakes") }),
    MOONLET(159.395, 20, { builtIn("moonlet") }),
    ;

    /** A state to start from, which [simulation] copies. */
    inner class Start {
        private val start = StartState(if (this@Workload == DENSE) molten(make()) else make())

        fun simulation(engine: CollisionEngine): Simulation = start.simulation(engine, dt)
    }
}

/** A state to start from. */
internal class StartState(private val setup: ScenarioSetup) {
    val size: Int get() = setup.population.size

    /** One that begins with a copy of the state, in steps of [dt]. */
    fun simulation(engine: CollisionEngine, dt: Double): Simulation = Simulation(
        setup.population.copy(),
        setup.boundary,
        CollisionForcing(setup.restitution, setup.guard, engine),
        FixedTimeStep(dt),
        setup.forces,
    )
}

/** [setup] of an elastic gas, whose lattice it melts. */
internal fun molten(setup: ScenarioSetup): ScenarioSetup {
    val forcing = CollisionForcing(ConstantRestitution(1.0), NoGuard)
    val simulation = Simulation(setup.population, setup.boundary, forcing, FixedTimeStep(0.02))
    while (simulation.time < MELTING) simulation.advance()
    return setup
}

private const val MELTING = 1.5

private const val RING_OMEGA = 1.313952e-4
private const val WAKES_OMEGA = 0.00013143527

/** After 21 of these the images of a square patch have slid by one box, and are where they were at the start. */
internal const val RING_STEP = 1 / (1.5 * 21 * RING_OMEGA)

/** [edges] × [edges] steady ring patches, images of one another. */
internal fun ring(edges: Int): ScenarioSetup {
    fun scenario(length: Double) = BuiltIn.scenario(
        "ring-patch",
        listOf(
            "frame={\"type\":\"hill\",\"angularSpeed\":$RING_OMEGA}",
            "box.lengths=[$length,$length,20]",
            "timeStep={\"type\":\"fixed\",\"dt\":$RING_STEP}",
        ),
    )
    val small = ScenarioSetup.of(scenario(RING_EDGE), "ring")
    val patch =
        Simulation(
            small.population,
            small.boundary,
            CollisionForcing(small.restitution),
            FixedTimeStep(RING_STEP),
            small.forces,
        )
    repeat(RING_SETTLING) { patch.advance() }
    val p = small.population
    val n = p.size
    fun column(a: DoubleArray, each: (Int) -> Double = { 0.0 }) = DoubleArray(n * edges * edges) {
        a[it % n] +
            each(it / n)
    }
    fun offset(k: Int) = (k - (edges - 1) / 2.0) * RING_EDGE
    val all = Population(
        column(p.x) { offset(it / edges) },
        column(p.y) { offset(it % edges) },
        column(p.z),
        column(p.vx),
        column(p.vy) { -1.5 * RING_OMEGA * offset(it / edges) },
        column(p.vz),
        column(p.radius),
        column(p.mass),
    )
    return ScenarioSetup.of(scenario(edges * RING_EDGE), "ring", all)
}

private const val RING_EDGE = 200.0

/** Six orbits, a whole number of times 21. */
private const val RING_SETTLING = 21 * 57

internal fun builtIn(name: String) = ScenarioSetup.of(BuiltIn.scenario(name), name)

/** The gas at [filling], walled into a corner of a box with eight times its edge. */
private fun clump(count: Int, filling: Double): ScenarioSetup {
    val dense = gas(count, filling, "lattice")
    val p = dense.population
    val edge = dense.boundary.box.length(0)
    for (a in listOf(p.x, p.y, p.z)) for (k in a.indices) a[k] -= CLUMPED_EDGES / 2 * edge - edge / 2 - 1
    val text = gasText(count, CLUMPED_EDGES * edge, "lattice").replace("\"periodic\"", "\"walls\"")
    return ScenarioSetup.of(ScenarioJson.parse(text, "clump"), "clump", p)
}

private const val CLUMPED_EDGES = 8.0

internal fun gas(count: Int, filling: Double, placement: String): ScenarioSetup {
    val edge = StrictMath.cbrt(count * Math.PI / 6 / filling)
    return ScenarioSetup.of(ScenarioJson.parse(gasText(count, edge, placement), "gas"), "gas").also {
        check(it.boundary is Periodic)
    }
}

private fun gasText(count: Int, edge: Double, placement: String) = """{
  "box": { "lengths": [$edge, $edge, $edge] }, "boundary": { "type": "periodic" },
  "particles": { "count": $count, "sizes": { "type": "equal", "radius": 0.5 }, "mass": 1 },
  "placement": { "type": "$placement" }, "velocities": { "type": "gaussian", "sigma": 1 },
  "restitution": { "type": "constant", "coefficient": 1 }, "timeStep": { "type": "fixed", "dt": 0.1 }, "until": 1
}"""
