package daphnis.core.compression

import daphnis.core.Simulation
import daphnis.core.TimeStep
import daphnis.core.boundary.Box
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.GaussianVelocities
import daphnis.core.initial.PlacementException
import daphnis.core.initial.Positions
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.step.CollapseException
import daphnis.core.surface.ConstantRestitution

/** The [spheres] of a placement as they grow in [box]. */
internal class GrowingGas private constructor(val spheres: Population, private val box: Box) {
    /** Where they are, in the order of their ids. */
    fun places(): Positions {
        val at = spheres.indicesById()
        fun along(axis: Int) = DoubleArray(at.size) { spheres.position(axis)[at[it]] }
        return Positions(along(0), along(1), along(2))
    }

    /** Told of a step; true ends the growth. */
    fun interface After {
        /**
         * There were [collisions] since growth began, and radii grew in the step by the part [growth] of those then.
         */
        fun step(growing: GrowingSpheres, collisions: Long, growth: Double): Boolean
    }

    /**
     * Grows until radii are [factor] times what they are, or [after] ends it.
     *
     * @param rate growth of a radius per unit of time, over that at the beginning
     * @param mostWork collisions per sphere after which they are jammed
     * @param goal what they grow to, in words
     * @return the factor by which they have grown
     * @throws PlacementException when they jam before
     */
    fun grow(engine: CollisionEngine, factor: Double, rate: Double, mostWork: Int, goal: String, after: After): Double {
        val boundary = GrowingSpheres(box, rate)
        var dt = minOf(LONGEST, MOST_GROWTH / rate)
        val forcing = CollisionForcing(ConstantRestitution(1.0), engine = engine)
        val end = (factor - 1) / rate
        val simulation = Simulation(spheres, boundary, forcing, TimeStep { dt })
        while (true) {
            val rest = end - simulation.time
            if (rest <= end * LAST) return factor
            dt = minOf(dt, rest)
            try {
                simulation.advance()
            } catch (e: CollapseException) {
                jam(boundary, goal, e)
            } catch (e: IllegalArgumentException) {
                jam(boundary, goal, e)
            }
            val pressure = boundary.reducedPressure
            val collisions = forcing.counters.collisions
            if (pressure > JAMMED || collisions / maxOf(1, spheres.size) > mostWork) jam(boundary, goal, null)
            if (after.step(boundary, collisions, rate * dt)) return boundary.scaleAt(simulation.time)
            dt = minOf(LONGEST, MOST_GROWTH / rate)
            if (pressure > 1) dt = minOf(dt, MOST_HEATING / (rate * pressure))
        }
    }

    private fun jam(boundary: GrowingSpheres, goal: String, cause: Exception?): Nothing = throw PlacementException(
        "growing spheres jam at a filling factor of ${boundary.fillingFactor(spheres)}, before $goal",
    ).also { if (cause != null) it.initCause(cause) }

    companion object {
        /** Reduced pressure at which spheres are jammed for all that matters here. */
        const val JAMMED = 1e4

        /** Of a step: units of time, growth, and growth of the energy. */
        private const val LONGEST = 0.1
        private const val MOST_GROWTH = 0.02
        private const val MOST_HEATING = 0.2
        private const val LAST = 1e-12

        /**
         * Spheres at [start] with the [part] of [radii]. In a unit of time one flies a mean diameter of these, at the
         * speed of a component.
         */
        fun of(start: Positions, radii: DoubleArray, part: Double, box: Box, random: SeededRandom): GrowingGas {
            val n = radii.size
            val field = GaussianVelocities(2 * radii.average())
            val v = Array(3) { DoubleArray(n) }
            val drawn = DoubleArray(3)
            for (k in 0 until n) {
                field.draw(random, drawn)
                for (axis in 0 until box.space.dimensions) v[axis][k] = drawn[axis]
            }
            val small = DoubleArray(n) { radii[it] * part }
            val (x, y, z) = listOf(start.x.copyOf(), start.y.copyOf(), start.z.copyOf())
            return GrowingGas(Population(x, y, z, v[0], v[1], v[2], small, DoubleArray(n) { 1.0 }), box)
        }
    }
}
