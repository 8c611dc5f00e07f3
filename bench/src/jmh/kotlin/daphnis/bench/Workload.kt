package daphnis.bench

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollapseGuard
import daphnis.core.collision.ConstantRestitution
import daphnis.core.collision.NoGuard
import daphnis.core.collision.Restitution
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.population.Population
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup

/**
 * What the engines are compared on. Each begins in the same state every time and advances [steps] steps.
 *
 * | | |
 * |---|---|
 * | PAPER_1, PAPER_2, PAPER_3 | the runs of the paper's figures, all 30 time units |
 * | CLUMPED | 1e5 elastic spheres that start at φ = 0.3 in the lower corner of a box that is eight times as large each way |
 * | DENSE | 1e5 elastic spheres at φ = 0.45, molten, 0.6 τ |
 * | GAS_1E4, GAS_1E5, GAS_1E6 | elastic gases at φ = 0.1, steps of 0.1 τ |
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
    ;

    /** A state to start from, which [simulation] copies. */
    inner class Start {
        private val setup = make()
        private val boundary: BoundaryConditions = setup.boundary
        private val restitution: Restitution = setup.restitution
        private val guard: CollapseGuard = setup.guard
        private val population: Population = setup.population.also { if (this@Workload == DENSE) melt(it, boundary) }

        fun simulation(engine: CollisionEngine): Simulation = Simulation(population.copy(), boundary, CollisionForcing(restitution, guard, engine), FixedTimeStep(dt))
    }

    private fun melt(population: Population, boundary: BoundaryConditions) {
        val simulation = Simulation(population, boundary, CollisionForcing(ConstantRestitution(1.0), NoGuard), FixedTimeStep(0.02))
        while (simulation.time < MELTING) simulation.advance()
    }
}

private const val MELTING = 1.5

private fun builtIn(name: String) = ScenarioSetup.of(BuiltIn.scenario(name), name)

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

private fun gas(count: Int, filling: Double, placement: String): ScenarioSetup {
    val edge = StrictMath.cbrt(count * Math.PI / 6 / filling)
    return ScenarioSetup.of(ScenarioJson.parse(gasText(count, edge, placement), "gas"), "gas").also { check(it.boundary is Periodic) }
}

private fun gasText(count: Int, edge: Double, placement: String) = """{
  "box": { "lengths": [$edge, $edge, $edge] }, "boundary": { "type": "periodic" },
  "particles": { "count": $count, "sizes": { "type": "equal", "radius": 0.5 }, "mass": 1 },
  "placement": { "type": "$placement" }, "velocities": { "type": "gaussian", "sigma": 1 },
  "restitution": { "type": "constant", "coefficient": 1 }, "timeStep": { "type": "fixed", "dt": 0.1 }, "until": 1
}"""
