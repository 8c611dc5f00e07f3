package daphnis.core.run

import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.population.ExactSum
import daphnis.core.wall.WallContact

/**
 * Sums over the collisions of a run with walls, where any of these moves or is thermal: what they give to spheres. They
 * are exact ([ExactSum]): the order of the collisions changes no bit. The simulation's collisional forcing must record
 * collisions.
 */
public class WallStatistics : Output {
    /** Collisions with walls summed. */
    public var count: Long = 0
        private set
    private val work = ExactSum()

    /** By face, and then by surface as far as any had a collision. */
    private val impulses = ArrayList(List(WallContact.FACES) { ExactSum() })
    private var lastStep = -1L

    /** Energy that walls have given to spheres, that of spins with it, less what they took. */
    public val given: Double get() = work.value()

    /**
     * Σ of the momentum that the wall [face] has given to spheres along its normal: over area and time the pressure on
     * it.
     */
    public fun impulse(face: Int): Double = impulses[face].value()

    /** The same of the boundary's surface [k], counted from 0. */
    public fun surfaceImpulse(k: Int): Double = impulses.getOrNull(WallContact.FACES + k)?.value() ?: 0.0

    override fun write(simulation: Simulation) {
        if (simulation.step == lastStep || simulation.step == 0L) return
        lastStep = simulation.step
        val record = simulation.recordOfStep()
        for (k in 0 until record.size) {
            if (!record.isWall(k)) continue
            count++
            work.add(-record.surfaceDissipation(k))
            sumOf(record.lower[k]).add(record.impulse(k))
        }
    }

    private fun sumOf(partner: Int): ExactSum {
        val face = WallContact.number(partner)
        while (impulses.size <= face) impulses += ExactSum()
        return impulses[face]
    }

    override fun save(state: OutputState) {
        val more = impulses.size - WallContact.FACES
        state.put(COUNT, if (more == 0) longArrayOf(count) else longArrayOf(count, more.toLong()))
        for (k in 0..impulses.size) state.put("$SUM$k", sum(k).parts().toDoubleArray())
    }

    override fun restore(state: OutputState) {
        val counts = state.longs(COUNT)
        count = counts[0]
        val more = counts.getOrElse(1) { 0 }.toInt()
        while (impulses.size < WallContact.FACES + more) impulses += ExactSum()
        for (k in 0..impulses.size) {
            sum(k).clear()
            for (part in state.doubles("$SUM$k")) sum(k).add(part)
        }
    }

    private fun sum(k: Int) = if (k == 0) work else impulses[k - 1]

    private companion object {
        const val COUNT = "wallCollisions"
        const val SUM = "wallSum"
    }
}
