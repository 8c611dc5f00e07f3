package daphnis.core.run

import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.population.ExactSum
import daphnis.core.wall.WallContact
import daphnis.core.wall.WallSums

/**
 * Sums over the collisions of a run with walls, where any of these moves or is thermal: what they give to spheres. They
 * are exact ([ExactSum]): the order of the collisions changes no bit. The simulation's collisional forcing must record
 * collisions.
 */
public class WallStatistics : Output {
    private val sums = WallSums()
    private var lastStep = -1L

    /** Collisions with walls summed. */
    public val count: Long get() = sums.count

    /** Energy that walls have given to spheres, that of spins with it, less what they took. */
    public val given: Double get() = sums.value(WallSums.WORK)

    /**
     * Σ of the momentum that the wall [face] has given to spheres along its normal: over area and time the pressure on
     * it.
     */
    public fun impulse(face: Int): Double = sums.value(WallSums.IMPULSES + face)

    /** The same of the boundary's surface [k], counted from 0. */
    public fun surfaceImpulse(k: Int): Double = impulse(WallContact.FACES + k)

    override fun write(simulation: Simulation) {
        if (simulation.step == lastStep || simulation.step == 0L) return
        lastStep = simulation.step
        simulation.addStepTo(sums)
    }

    override fun save(state: OutputState) {
        val more = sums.size - WallSums.IMPULSES - WallContact.FACES
        state.put(COUNT, if (more == 0) longArrayOf(count) else longArrayOf(count, more.toLong()))
        for (k in 0 until sums.size) state.put("$SUM$k", sums.sum(k).parts().toDoubleArray())
    }

    override fun restore(state: OutputState) {
        val counts = state.longs(COUNT)
        sums.clear()
        sums.count = counts[0]
        val more = counts.getOrElse(1) { 0 }.toInt()
        for (k in 0 until WallSums.IMPULSES + WallContact.FACES + more) {
            for (part in state.doubles("$SUM$k")) sums.sum(k).add(part)
        }
    }

    private companion object {
        const val COUNT = "wallCollisions"
        const val SUM = "wallSum"
    }
}
