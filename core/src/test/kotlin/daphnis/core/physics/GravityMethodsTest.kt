package daphnis.core.physics

import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.prepare
import daphnis.core.force.MeshGravity
import daphnis.core.force.MutualGravity
import daphnis.core.force.SelfGravity
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.space.Images
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.lang.management.ManagementFactory
import java.util.Locale
import kotlin.math.PI
import kotlin.math.sqrt

/**
 * Force of a mesh and of a tree in `self-gravity-wakes`, against the direct sum over all images of the sheet, at the
 * start and with wakes. The long form lays the patch out 7 by 7 times, which is the same sheet, and prints how long
 * each took on one thread, in turns.
 */
@Tag("physics")
@Tag("thorough")
class GravityMethodsTest {
    private val omega = 0.00013143527
    private val orbit = 2 * PI / omega

    @Test
    fun `error of the force, uniform and in wakes`() {
        val gravity = """forces=[{"type":"self-gravity","method":"mesh","softening":0.1}]"""
        val setup = ScenarioSetup.of(BuiltIn.scenario("self-gravity-wakes", listOf(gravity)), "wakes")
        compare("uniform", setup.population, setup.boundary, 0.0)
        val simulation = Simulation(
            setup.population,
            setup.boundary,
            setup.collisions(recordCollisions = false),
            setup.timeStep,
            setup.forces,
        )
        while (simulation.time < (if (fullPhysics) 2.013 else 0.1013) * orbit) simulation.advance()
        compare("in wakes", simulation.population, setup.boundary, simulation.time)
    }

    private fun compare(where: String, p: Population, boundary: BoundaryConditions, time: Double) {
        val of = 0 until p.size step p.size / 80
        val expected = direct(p, boundary, time, of)
        val mesh = MeshGravity(boundary, 1.0, 0.1)
        val error = rmsError(mesh, p, time, of, expected)
        assertPhysics("force by a mesh, $where: rms error", 0.0, error, 0.005, relative = false)
        if (!fullPhysics) return
        for (tiles in listOf(1, 7)) {
            val many = tile(p, boundary, time, tiles)
            val sheet = HillSheet(Box.centred(200.0 * tiles, 200.0 * tiles, 16.0), omega)
            val methods = listOf(
                "tree, angle 0.7, images 2" to SelfGravity(sheet, 1.0, 0.7, 0.1, 2),
                "tree, angle 0.5" to SelfGravity(sheet, 1.0, 0.5, 0.1, 1),
                "tree, angle 0.35" to SelfGravity(sheet, 1.0, 0.35, 0.1, 1),
                "mesh" to MeshGravity(sheet, 1.0, 0.1),
            )
            val least = DoubleArray(methods.size) { Double.POSITIVE_INFINITY }
            repeat(if (tiles == 1) 30 else 4) { round ->
                methods.forEachIndexed { m, (_, method) ->
                    val began = cpu()
                    // A position is another each time, so that the force is not the kept one.
                    many.z[0] += 1e-9 * (round + 1)
                    method.accelerations(many, time)
                    least[m] = minOf(least[m], (cpu() - began) * 1e-3 / many.size)
                }
            }
            methods.forEachIndexed { m, (name, method) ->
                val off = rmsError(method, many, time, of, expected)
                val row = "%s, %d spheres, %s: %.3f µs, rms error %.5f"
                println(row.format(Locale.ROOT, where, many.size, name, least[m], off))
            }
        }
    }

    private fun cpu() = ManagementFactory.getThreadMXBean().currentThreadCpuTime

    /** The same sheet as a patch [tiles] times as long and wide. */
    private fun tile(p: Population, boundary: BoundaryConditions, time: Double, tiles: Int): Population {
        val offset = boundary.shear!!.offset(time)
        val n = p.size
        val all = n * tiles * tiles
        val half = 100.0 * tiles
        val x = DoubleArray(all)
        val y = DoubleArray(all)
        for (k in 0 until all) {
            val tx = k / n / tiles
            val ty = k / n % tiles
            x[k] = p.x[k % n] + 200.0 * tx
            y[k] = p.y[k % n] + 200.0 * ty + offset * tx
            x[k] -= half - 100
            y[k] -= half - 100
            y[k] -= Math.floor((y[k] + half) / (2 * half)) * 2 * half
        }
        fun of(a: DoubleArray) = DoubleArray(all) { a[it % n] }
        return Population(x, y, of(p.z), of(p.vx), of(p.vy), of(p.vz), of(p.radius), of(p.mass))
    }

    /** Over images up to 15 boxes away, faded from half of that on. */
    private fun direct(
        p: Population,
        boundary: BoundaryConditions,
        time: Double,
        of: IntProgression,
    ): Array<DoubleArray> {
        val images = 15
        val shifts = Images().also { it.prepare(boundary, time) }
        val range2 = 200.0 * 200.0 * (images + 0.5) * (images + 0.5)
        val a = Array(3) { DoubleArray(of.count()) }
        for (ix in -images - 1..images + 1) {
            val middle = -Math.rint(ix * shifts.shearOffset / 200.0).toInt()
            for (iy in middle - images - 1..middle + images + 1) {
                val code = Images.code(ix, iy, 0)
                of.forEachIndexed { place, i ->
                    for (j in 0 until p.size) {
                        val dx = p.x[j] - p.x[i] + shifts.shift(code, 0)
                        val dy = p.y[j] - p.y[i] + shifts.shift(code, 1)
                        val dz = p.z[j] - p.z[i]
                        val rho2 = dx * dx + dy * dy
                        if (rho2 >= range2 || i == j && code == 0) continue
                        val t = minOf(1.0, (range2 - rho2) / (0.75 * range2))
                        val d2 = rho2 + dz * dz + 0.01
                        val f = p.mass[j] / (d2 * sqrt(d2)) * t * t * (3 - 2 * t)
                        a[0][place] += f * dx
                        a[1][place] += f * dy
                        a[2][place] += f * dz
                    }
                }
            }
        }
        return a
    }

    private fun rmsError(
        method: MutualGravity,
        p: Population,
        time: Double,
        of: IntProgression,
        expected: Array<DoubleArray>,
    ): Double {
        val found = method.accelerations(p, time)
        var error = 0.0
        var size = 0.0
        for (axis in 0..2) {
            of.forEachIndexed { place, i ->
                error += (found[axis][i] - expected[axis][place]).let { it * it }
                size += expected[axis][place] * expected[axis][place]
            }
        }
        return sqrt(error / size)
    }
}
