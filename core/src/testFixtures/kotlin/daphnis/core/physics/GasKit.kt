package daphnis.core.physics

import daphnis.core.FixedTimeStep
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollapseGuard
import daphnis.core.collision.NoGuard
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.LatticePlacement
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Conserved
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRestitution
import kotlin.math.sqrt

/** Cube that holds [count] spheres of diameter 1 at filling factor [filling]. */
fun cube(count: Int, filling: Double): Box =
    StrictMath.cbrt(count * Math.PI / 6 / filling).let { Box.centred(it, it, it) }

/**
 * Spheres of diameter 1 and mass 1 with velocities drawn by [velocity], scaled to temperature 1 and no momentum, before
 * the mean flow [shearRate].
 */
fun gas(
    count: Int,
    box: Box,
    seed: Long,
    lattice: Boolean,
    shearRate: Double = 0.0,
    velocity: (SeededRandom) -> Double = { it.nextGaussian() },
): Population {
    val random = SeededRandom(seed)
    val radii = DoubleArray(count) { 0.5 }
    val p = (if (lattice) LatticePlacement() else RandomPlacement()).place(radii, box, BooleanArray(3), random)
    val v = Array(3) { DoubleArray(count) { velocity(random) } }
    var square = 0.0
    for (component in v) {
        val mean = component.average()
        for (k in 0 until count) {
            component[k] -= mean
            square += component[k] * component[k]
        }
    }
    val scale = sqrt(3 * count / square)
    for (component in v) for (k in 0 until count) component[k] *= scale
    for (k in 0 until count) v[0][k] += shearRate * p.y[k]
    return Population(p.x, p.y, p.z, v[0], v[1], v[2], radii, DoubleArray(count) { 1.0 })
}

fun gasSimulation(
    population: Population,
    boundary: BoundaryConditions,
    dt: Double,
    e: Double = 1.0,
    guard: CollapseGuard = NoGuard,
    record: Boolean = false,
    outputs: List<Output> = emptyList(),
) = Simulation(
    population,
    boundary,
    CollisionForcing(ConstantRestitution(e), guard, recordCollisions = record),
    FixedTimeStep(dt),
    outputs = outputs,
)

/** An elastic gas at temperature 1 in a periodic cube, its lattice molten or its random start forgotten. */
fun equilibriumGas(
    count: Int,
    filling: Double,
    dt: Double,
    outputs: List<Output> = emptyList(),
    from: Double,
): Simulation {
    val box = cube(count, filling)
    val simulation =
        gasSimulation(gas(count, box, 1, filling > 0.2), Periodic(box), dt, record = true, outputs = outputs)
    while (simulation.time < from) simulation.advance()
    return simulation
}

fun temperature(p: Population) = Conserved.of(p).let { 2 * it.kineticEnergy / it.mass / 3 }
