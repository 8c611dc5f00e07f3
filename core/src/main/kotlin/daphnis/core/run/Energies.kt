package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.force.Drift
import daphnis.core.hill.Satellite

/**
 * The energies of a state, mass · (length/time)². NaN where a force has no potential energy
 * ([daphnis.core.force.Force.potentialEnergy]).
 *
 * @property potential in all forces except the frame
 * @property total kinetic, that of rotation and [potential]; NaN in a rotating frame, in which it is not conserved
 * @property hill the same in the rotating frame, relative to it, plus that of the frame, and of satellites that feel the
 *   ring; NaN without a frame
 */
internal class Energies(simulation: Simulation, sums: StepSums) {
    val potential: Double
    val total: Double
    val hill: Double

    init {
        val kinetic = sums.of(simulation).kineticEnergy + (sums.spins(simulation)?.energyOfRotation ?: 0.0)
        var forces = 0.0
        var frame = Double.NaN
        var own = 0.0
        for (force in simulation.forces) {
            val energy = sums.potentialEnergy(simulation, force)
            if (force is Drift) frame = energy else forces += energy
            own += (force as? Satellite)?.energy ?: 0.0
        }
        potential = forces
        hill = kinetic + forces + frame + own
        total = if (simulation.forces.any { it is Drift }) Double.NaN else kinetic + forces
    }
}
