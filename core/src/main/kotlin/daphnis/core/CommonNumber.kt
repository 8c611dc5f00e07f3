package daphnis.core

import daphnis.core.force.MutualGravity

/** A number of all spheres together. Nodes that hold them find it together, and each gets the same. */
internal enum class CommonNumber {
    /** The potential energy in one of the forces. */
    POTENTIAL_ENERGY {
        override fun of(simulation: Simulation, force: Int): Double =
            simulation.forces[force].potentialEnergy(simulation.population, simulation.boundary, simulation.time)
    },

    /** See [MutualGravity.stressXY]. */
    STRESS_XY {
        override fun of(simulation: Simulation, force: Int): Double =
            (simulation.forces[force] as MutualGravity).stressXY(simulation.population, simulation.time)
    },

    /** See [daphnis.core.boundary.Growth.fillingFactor]. */
    FILLING_FACTOR {
        override fun of(simulation: Simulation, force: Int): Double =
            simulation.boundary.growth?.fillingFactor(simulation.population) ?: Double.NaN
    }, ;

    /** That of [simulation] at the end of its last step; [force] is the place among its forces of the one meant. */
    abstract fun of(simulation: Simulation, force: Int): Double

    /** The same, from those who hold its spheres. */
    fun anywhere(simulation: Simulation, force: Int = 0): Double {
        var number = Double.NaN
        val isElsewhere = simulation.sumElsewhere { number = it.number(this, force) }
        return if (isElsewhere) number else of(simulation, force)
    }
}
