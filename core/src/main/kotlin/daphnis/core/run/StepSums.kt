package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.force.EnergySums
import daphnis.core.force.Force
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.MaterialSums
import daphnis.core.population.PopulationSums
import daphnis.core.population.SpinSums

/**
 * The [sums] over a population, taken once after a step for any number of outputs: by the threads of this process, or,
 * where nodes hold the spheres, by them. Both give the same bits.
 */
internal class StepSums(
    private val sums: PopulationSums,
    private val spins: SpinSums? = null,
    private val byMaterial: MaterialSums? = null,
) {
    private var spinsTakenAt = -1L
    private var materialsTakenAt = -1L

    /** Names of the materials that there are sums of. */
    val materials: List<String> get() = byMaterial?.materials.orEmpty()

    /** Whether there are sums over spins. */
    val haveSpins: Boolean get() = spins != null

    /** Spheres with this id or a higher one are bodies. */
    val firstBody: Int get() = sums.firstBody

    /** Of orbits in Hill's frame; null without it. */
    val frequencies: OrbitalFrequencies? get() = sums.frequencies

    private var takenAt = -1L
    private var energies: EnergySums? = null
    private var hasEnergies = false

    /** Sums of the state that [simulation] has after its step. */
    fun of(simulation: Simulation): PopulationSums = if (takenAt == simulation.step) sums else take(simulation)

    /**
     * Sums over spins of the same state; null for spheres without any. Where nodes hold the spheres, they are fetched.
     */
    fun spins(simulation: Simulation): SpinSums? {
        if (spins == null || spinsTakenAt == simulation.step) return spins
        spinsTakenAt = -1
        spins.take(simulation.population)
        spinsTakenAt = simulation.step
        return spins
    }

    /** Sums by material of the same state, likewise; null where spheres have none. */
    fun materials(simulation: Simulation): MaterialSums? {
        if (byMaterial == null || materialsTakenAt == simulation.step) return byMaterial
        materialsTakenAt = -1
        byMaterial.take(simulation.population, of(simulation))
        materialsTakenAt = simulation.step
        return byMaterial
    }

    /** Takes the sums again, and energies when they are asked for. */
    fun take(simulation: Simulation): PopulationSums {
        val energies = energiesIn(simulation)
        takenAt = -1
        spinsTakenAt = -1
        materialsTakenAt = -1
        hasEnergies = false
        val isElsewhere = simulation.sumElsewhere { parts ->
            sums.take(parts)
            energies.clear()
            energies.merge(parts.energies)
        }
        if (isElsewhere) hasEnergies = true else sums.take(simulation.population, loopOf(simulation))
        takenAt = simulation.step
        return sums
    }

    /** Potential energy in [force], one of those of [simulation], after its step. */
    fun potentialEnergy(simulation: Simulation, force: Force): Double {
        val energies = energiesIn(simulation)
        val time = simulation.time
        if (!energies.have(force)) return force.potentialEnergy(simulation.population, simulation.boundary, time)
        of(simulation)
        if (!hasEnergies) energies.take(simulation.population, time, loopOf(simulation))
        hasEnergies = true
        return energies.of(force)
    }

    private fun energiesIn(simulation: Simulation): EnergySums =
        energies ?: EnergySums(simulation.forces, simulation.boundary).also { energies = it }

    private fun loopOf(simulation: Simulation): RangeLoop = simulation.workforce?.loop ?: InlineLoop
}
