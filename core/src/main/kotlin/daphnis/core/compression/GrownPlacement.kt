package daphnis.core.compression

import daphnis.core.Simulation
import daphnis.core.TimeStep
import daphnis.core.boundary.Box
import daphnis.core.collision.ConstantRestitution
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.initial.GaussianVelocities
import daphnis.core.initial.Placement
import daphnis.core.initial.PlacementException
import daphnis.core.initial.Positions
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.initial.fillingFactor
import daphnis.core.population.Population
import daphnis.core.step.CollapseException
import kotlin.math.sqrt

/**
 * Random places of any density up to jamming: spheres so small that they fill a fifth of the box are placed at random,
 * and then all grow in proportion to their radii while they collide elastically ([GrowingSpheres], with its
 * thermostat), the slower the denser they are. Spheres that fill less than a fifth are placed at random and do not move.
 *
 * The state is near equilibrium, not in it: at the filling factor 0.5 the pressure is 11 % above that of Carnahan &
 * Starling at first, and within 1 % of it after two diameters over the thermal speed.
 *
 * The same bits for any number of threads. Equal spheres jam at about 0.64, and discs crystallize.
 *
 * @param threads threads to compute on, the caller's included
 */
public class GrownPlacement @JvmOverloads constructor(private val threads: Int = 1) : Placement {
    /** @throws PlacementException also for walls, and when spheres jam before they have their radii, or cannot have them */
    override fun place(radii: DoubleArray, box: Box, walled: BooleanArray, random: SeededRandom): Positions {
        check(radii, box, walled)
        val filling = fillingFactor(radii, box)
        val part = if (filling <= LOOSE) 1.0 else scale(LOOSE / filling, box)
        val small = DoubleArray(radii.size) { radii[it] * part }
        val start = RandomPlacement(threads = threads).place(small, box, walled, random)
        return if (part == 1.0) start else grown(start, radii, part, box, random)
    }

    /** All in the middle, which costs nothing; checks what can be known without growth. */
    internal fun middle(radii: DoubleArray, box: Box, walled: BooleanArray): Positions {
        check(radii, box, walled)
        return Positions(DoubleArray(radii.size), DoubleArray(radii.size), DoubleArray(radii.size))
    }

    private fun check(radii: DoubleArray, box: Box, walled: BooleanArray) {
        if ((0 until box.space.dimensions).any {
                walled[it]
            }
        ) {
            throw PlacementException("spheres grow in a box that repeats along all axes only")
        }
        if (radii.isEmpty()) return
        val largest = radii.max()
        for (axis in 0 until box.space.dimensions) {
            if (2 * largest * ROOM < box.length(axis)) continue
            throw PlacementException("a sphere of radius $largest touches its own image along ${"xyz"[axis]}")
        }
        val filling = fillingFactor(radii, box)
        val what = if (box.space.isPlane) "discs" else "spheres"
        val equal = radii.all { it == largest }
        val most = if (equal) box.space.closestPacking else 1.0
        if (filling >= most) {
            throw PlacementException("the filling factor would be $filling; $what fill $most at most")
        }
        val reached = if (box.space.isPlane) MOST_DISCS else MOST_SPHERES
        if (equal && filling > reached) {
            throw PlacementException(
                "the filling factor would be $filling; equal $what that grow jam at $reached or before; " +
                    "use a lattice above that",
            )
        }
    }

    /**
     * Where spheres are when they have grown to [radii] from places [start], where they do not overlap with the [part]
     * of these. The unit of time is that in which a sphere flies a mean diameter, at the speed of a component.
     *
     * @throws PlacementException when they jam before
     */
    internal fun grown(start: Positions, radii: DoubleArray, part: Double, box: Box, random: SeededRandom): Positions {
        val n = radii.size
        val field = GaussianVelocities(2 * radii.average())
        val v = Array(3) { DoubleArray(n) }
        val drawn = DoubleArray(3)
        for (k in 0 until n) {
            field.draw(random, drawn)
            for (axis in 0 until box.space.dimensions) v[axis][k] = drawn[axis]
        }
        val small = DoubleArray(n) { radii[it] * part }
        val spheres = Population(
            start.x.copyOf(),
            start.y.copyOf(),
            start.z.copyOf(),
            v[0],
            v[1],
            v[2],
            small,
            DoubleArray(n) { 1.0 },
        )
        val full = fillingFactor(radii, box)
        HorizonEngine(threads).use { engine ->
            var now = part
            for (stage in STAGES) {
                // A hair more than asked for, so that none overlap with the radii that are.
                val goal = if (full <= stage.filling(box)) ROOM else scale(stage.filling(box) / full, box)
                if (goal <= now) continue
                grow(spheres, box, engine, goal / now, stage.rate, full)
                now = goal
                if (goal == ROOM) break
            }
            if (now < ROOM) grow(spheres, box, engine, ROOM / now, SLOWEST, full)
        }
        val at = spheres.indicesById()
        fun places(axis: Int) = DoubleArray(n) { spheres.position(axis)[at[it]] }
        return Positions(places(0), places(1), places(2))
    }

    /** Until radii are [factor] times what they are. */
    private fun grow(
        spheres: Population,
        box: Box,
        engine: HorizonEngine,
        factor: Double,
        rate: Double,
        full: Double,
    ) {
        val boundary = GrowingSpheres(box, rate)
        var dt = minOf(LONGEST, MOST_GROWTH / rate)
        val forcing = CollisionForcing(ConstantRestitution(1.0), engine = engine)
        val end = (factor - 1) / rate
        val simulation = Simulation(spheres, boundary, forcing, TimeStep { dt })
        while (true) {
            val rest = end - simulation.time
            if (rest <= end * LAST) return
            dt = minOf(dt, rest)
            try {
                simulation.advance()
            } catch (e: CollapseException) {
                jam(boundary.fillingFactor(spheres), full, e)
            } catch (e: IllegalArgumentException) {
                jam(boundary.fillingFactor(spheres), full, e)
            }
            val pressure = boundary.reducedPressure
            val work = forcing.counters.collisions / maxOf(1, spheres.size)
            if (pressure > JAMMED || work > MOST_WORK) jam(boundary.fillingFactor(spheres), full, null)
            dt = minOf(LONGEST, MOST_GROWTH / rate)
            if (pressure > 1) dt = minOf(dt, MOST_HEATING / (rate * pressure))
        }
    }

    private fun jam(filling: Double, full: Double, cause: Exception?): Nothing = throw PlacementException(
        "growing spheres jam at a filling factor of $filling, before $full",
    ).also { if (cause != null) it.initCause(cause) }

    /** Up to [filling] radii grow by [rate] of what they are per unit of time. */
    private class Stage(private val filling: Double, val rate: Double) {
        fun filling(box: Box) = if (box.space.isPlane) PLANE * filling else filling
    }

    /** Of lengths, where volumes change by the factor [ofVolumes]. */
    private fun scale(ofVolumes: Double, box: Box): Double =
        if (box.space.isPlane) sqrt(ofVolumes) else StrictMath.cbrt(ofVolumes)

    private companion object {
        /** Spheres find places at random with few tries. */
        const val LOOSE = 0.2
        val STAGES = listOf(Stage(0.45, 0.5), Stage(0.55, 0.1), Stage(0.6, 0.02))
        const val SLOWEST = 0.002

        /** Of a step: units of time, growth, and growth of the energy. */
        const val LONGEST = 0.1
        const val MOST_GROWTH = 0.02
        const val MOST_HEATING = 0.2

        /** Reduced pressure at which spheres are jammed for all that matters here. */
        const val JAMMED = 1e4

        /** Collisions per sphere in a stage; with pressures that diverge as 3/(1 − φ/φ_J) up to [JAMMED] it has some 5,000. */
        const val MOST_WORK = 50_000

        /** Filling factors above which equal ones do not come. */
        const val MOST_SPHERES = 0.65
        const val MOST_DISCS = 0.9

        const val ROOM = 1 + 1e-9
        const val LAST = 1e-12

        /** Filling factor at which discs jam over that at which spheres do. */
        const val PLANE = 1.3
    }
}
