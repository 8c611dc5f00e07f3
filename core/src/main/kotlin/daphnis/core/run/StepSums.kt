package daphnis.core.run

import daphnis.core.CommonNumber
import daphnis.core.Simulation
import daphnis.core.boundary.at
import daphnis.core.boundary.isChanging
import daphnis.core.force.EnergySums
import daphnis.core.force.Force
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.MaterialSums
import daphnis.core.population.Partitioned
import daphnis.core.population.PopulationSums
import daphnis.core.population.SpinSums
import daphnis.core.wave.ModeSums

/**
 * The [sums] over a population, taken once after a step for any number of outputs: by the threads of this process, or,
 * where nodes hold the spheres, by them. Both give the same bits.
 *
 * @property areWallsDriven whether any wall moves or is thermal
 * @property surfaces how many walls there are that are not faces of the box
 * @property haveGrowth whether spheres grow
 * @property pistons faces of the walls that are pistons
 * @property haveEdges whether spheres do something to one another besides impacts
 * @property arePlain whether they only meet, and neither have edges nor merge nor break
 * @property sources how many sources and sinks there are
 */
internal class StepSums(
    private val sums: PopulationSums,
    private val spins: SpinSums? = null,
    private val byMaterial: MaterialSums? = null,
    private val modes: ModeSums? = null,
    val areWallsDriven: Boolean = false,
    val surfaces: Int = 0,
    val haveGrowth: Boolean = false,
    val pistons: Set<Int> = emptySet(),
    val haveEdges: Boolean = false,
    val arePlain: Boolean = true,
    val sources: Int = 0,
) {
    /** Names of the materials that there are sums of. */
    val materials: List<String> get() = byMaterial?.materials.orEmpty()

    /** Whether there are sums over spins. */
    val haveSpins: Boolean get() = spins != null

    /** Whether there are sums over the heat that particles carry. */
    val haveHeat: Boolean get() = sums.carriesHeat

    /** Spheres with this id or a higher one are bodies. */
    val firstBody: Int get() = sums.firstBody

    /** Of orbits in Hill's frame; null without it. */
    val frequencies: OrbitalFrequencies? get() = sums.frequencies

    private var takenAt = -1L
    private var energies: EnergySums? = null
    private var hasEnergies = false
    private var haveTakenSpins = false
    private var haveTakenMaterials = false
    private var modesTakenAt = -1L

    /** Sums of the state that [simulation] has after its step. */
    fun of(simulation: Simulation): PopulationSums = if (takenAt == simulation.step) sums else take(simulation)

    /** Sums over spins of the same state; null for spheres without any. */
    fun spins(simulation: Simulation): SpinSums? {
        if (spins != null) of(simulation)
        if (spins != null && !haveTakenSpins) spins.take(simulation.population, loopOf(simulation))
        haveTakenSpins = true
        return spins
    }

    /** Sums by material of the same state; null where spheres have none. */
    fun materials(simulation: Simulation): MaterialSums? {
        if (byMaterial == null) return null
        val sums = of(simulation)
        if (!haveTakenMaterials) byMaterial.take(simulation.population, sums, loopOf(simulation))
        haveTakenMaterials = true
        return byMaterial
    }

    /**
     * Fourier modes of the same state. Where nodes hold the spheres, they are fetched.
     *
     * @throws IllegalStateException in a run that was not to have any
     */
    fun modes(simulation: Simulation): ModeSums {
        val modes = checkNotNull(modes) { "no modes were asked for" }
        if (modesTakenAt == simulation.step) return modes
        modesTakenAt = -1
        modes.take(simulation.population, loopOf(simulation))
        modesTakenAt = simulation.step
        return modes
    }

    /** Takes the sums again, and energies when they are asked for. */
    fun take(simulation: Simulation): PopulationSums {
        val energies = energiesIn(simulation)
        takenAt = -1
        modesTakenAt = -1
        val boundary = simulation.boundary
        if (boundary.isChanging) sums.drive(boundary.at(simulation.time).meanFlow)
        val isElsewhere = simulation.sumElsewhere { parts ->
            sums.take(parts)
            energies.clear()
            energies.merge(parts.energies)
            spins?.parts?.clear()
            spins?.parts?.merge(parts.spins.parts)
            byMaterial?.parts?.clear()
            byMaterial?.parts?.merge(parts.materials.parts)
        }
        hasEnergies = isElsewhere
        haveTakenSpins = isElsewhere
        haveTakenMaterials = isElsewhere
        if (!isElsewhere) sums.take(simulation.population, loopOf(simulation))
        takenAt = simulation.step
        return sums
    }

    /** Potential energy in [force], one of those of [simulation], after its step. */
    fun potentialEnergy(simulation: Simulation, force: Force): Double {
        val energies = energiesIn(simulation)
        val time = simulation.time
        if (!energies.have(force)) {
            if (force !is Partitioned) return force.potentialEnergy(simulation.population, simulation.boundary, time)
            return CommonNumber.POTENTIAL_ENERGY.anywhere(simulation, simulation.forces.indexOf(force))
        }
        of(simulation)
        if (!hasEnergies) energies.take(simulation.population, time, loopOf(simulation))
        hasEnergies = true
        return energies.of(force)
    }

    private fun energiesIn(simulation: Simulation): EnergySums =
        energies ?: EnergySums(simulation.forces, simulation.boundary).also { energies = it }

    private fun loopOf(simulation: Simulation): RangeLoop = simulation.workforce?.loop ?: InlineLoop
}
