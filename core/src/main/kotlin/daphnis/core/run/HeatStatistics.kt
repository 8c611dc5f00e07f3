package daphnis.core.run

import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.collision.HeatSums
import daphnis.core.population.ExactSum

/**
 * The heat that collisions of smooth elastic spheres carry from centre to centre, since the start of a run. Sums are
 * exact ([ExactSum]): the order of the collisions changes no bit. The simulation's collisional forcing must record
 * collisions.
 */
public class HeatStatistics : Output {
    private val sums = HeatSums()
    private var lastStep = -1L

    /**
     * Σ ΔE δ_a along [axis], mass · length³/time²: over volume and time it is the collisional part of the heat flux in
     * a gas whose centre of mass is at rest.
     */
    public fun carried(axis: Int): Double = sums.value(axis)

    override fun write(simulation: Simulation) {
        if (simulation.step == lastStep || simulation.step == 0L) return
        lastStep = simulation.step
        simulation.addStepTo(sums)
    }

    override fun save(state: OutputState) {
        for (axis in 0..2) state.put("$SUM$axis", sums.sum(axis).parts().toDoubleArray())
    }

    override fun restore(state: OutputState) {
        sums.clear()
        for (axis in 0..2) for (part in state.doubles("$SUM$axis")) sums.sum(axis).add(part)
    }

    private companion object {
        const val SUM = "heatSum"
    }
}
