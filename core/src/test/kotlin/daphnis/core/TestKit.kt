package daphnis.core

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.collision.CollapseGuard
import daphnis.core.collision.ConstantRestitution
import daphnis.core.collision.NoGuard
import daphnis.core.collision.Restitution
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.initial.PlacementException
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.search.Overlap
import org.junit.jupiter.api.Assertions.assertTrue

/** One sphere of a hand-made case. */
class Sphere(
    val x: Double = 0.0,
    val y: Double = 0.0,
    val z: Double = 0.0,
    val vx: Double = 0.0,
    val vy: Double = 0.0,
    val vz: Double = 0.0,
    val r: Double = 1.0,
    val m: Double = 1.0,
)

fun populationOf(vararg s: Sphere): Population = Population(
    s.map { it.x }.toDoubleArray(),
    s.map { it.y }.toDoubleArray(),
    s.map { it.z }.toDoubleArray(),
    s.map { it.vx }.toDoubleArray(),
    s.map { it.vy }.toDoubleArray(),
    s.map { it.vz }.toDoubleArray(),
    s.map { it.r }.toDoubleArray(),
    s.map { it.m }.toDoubleArray(),
)

/** The same spheres in another order of the arrays, ids kept. */
fun Population.permuted(seed: Long): Population {
    val order = IntArray(size) { it }
    val random = SeededRandom(seed)
    for (k in size - 1 downTo 1) {
        val j = random.nextInt(k + 1)
        order[k] = order[j].also { order[j] = order[k] }
    }
    fun pick(a: DoubleArray) = DoubleArray(size) { a[order[it]] }
    return Population(
        pick(x), pick(y), pick(z), pick(vx), pick(vy), pick(vz), pick(radius), pick(mass),
        IntArray(size) {
            id[order[it]]
        },
    )
}

fun simulationOf(
    population: Population,
    boundary: BoundaryConditions,
    dt: Double,
    restitution: Restitution = ConstantRestitution(1.0),
    guard: CollapseGuard = NoGuard,
    engine: CollisionEngine = SerialEngine(),
    outputs: List<Output> = emptyList(),
): Simulation = Simulation(
    population,
    boundary,
    CollisionForcing(restitution, guard, engine, recordCollisions = true),
    FixedTimeStep(dt),
    outputs = outputs,
)

/**
 * Spheres without overlap in the boundary's box (or a cube of 10 when it has none), velocities normal with deviation
 * [sigma].
 */
fun randomSpheres(
    count: Int,
    boundary: BoundaryConditions,
    seed: Long,
    sigma: Double,
    radius: (SeededRandom) -> Double,
): Population {
    val random = SeededRandom(seed)
    val radii = DoubleArray(count) { radius(random) }
    val box = if (boundary.box.volume.isFinite()) boundary.box else daphnis.core.boundary.Box.centred(10.0, 10.0, 10.0)
    val walled = BooleanArray(3) { boundary.contactFaces(it) != daphnis.core.boundary.ContactFaces.PERIODIC }
    val p = try {
        RandomPlacement(20_000).place(radii, box, walled, random)
    } catch (e: PlacementException) {
        // Too dense a draw: half as many do as well.
        return randomSpheres(count / 2, boundary, seed, sigma, radius)
    }
    fun gauss() = DoubleArray(count) { sigma * random.nextGaussian() }
    return Population(
        p.x,
        p.y,
        p.z,
        gauss(),
        gauss(),
        gauss(),
        radii,
        DoubleArray(count) {
            radii[it] * radii[it] *
                radii[it]
        },
    )
}

/**
 * What must hold after every step: finite, in the box, nobody overlapping by more than [overlap] of the sum of radii.
 */
fun assertInvariants(simulation: Simulation, overlap: Double = 1e-11) {
    val p = simulation.population
    for (axis in 0..2) {
        if (simulation.boundary.contactFaces(axis) == daphnis.core.boundary.ContactFaces.OPEN) continue
        val a = if (axis == 0) {
            p.x
        } else if (axis == 1) {
            p.y
        } else {
            p.z
        }
        for (k in 0 until p.size) {
            assertTrue(a[k].isFinite()) { "${"xyz"[axis]} of ${p.id[k]} is ${a[k]}" }
            assertTrue(a[k] >= simulation.boundary.box.lower(axis) && a[k] <= simulation.boundary.box.upper(axis)) {
                "${"xyz"[axis]} of ${p.id[k]} is ${a[k]}, outside"
            }
        }
    }
    for (k in 0 until p.size) assertTrue(p.vx[k].isFinite() && p.vy[k].isFinite() && p.vz[k].isFinite())
    val deepest = Overlap.deepest(p, simulation.boundary, simulation.time)
    assertTrue(deepest.depth <= overlap) {
        "spheres ${deepest.first} and ${deepest.second} overlap by ${deepest.depth} after step ${simulation.step}"
    }
}
