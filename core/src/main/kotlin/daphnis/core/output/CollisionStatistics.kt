package daphnis.core.output

import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.collision.CollisionRecord

/**
 * Sums over the collisions of a run: number, impact speeds, and the momentum that collisions carry. The simulation's collisional forcing
 * must record collisions.
 *
 * @property from collisions of steps that end at or before this time are left out
 */
public class CollisionStatistics(public val from: Double = Double.NEGATIVE_INFINITY) : Output {
    /** Collisions summed. */
    public var count: Long = 0
        private set

    /** Σ impact speed. */
    public var sumSpeed: Double = 0.0
        private set

    /** Σ impact speed². */
    public var sumSpeedSquared: Double = 0.0
        private set

    /** Kinetic energy lost: Σ ½ μ (1 − ε²) v_n², with μ the reduced mass. */
    public var dissipated: Double = 0.0
        private set

    /** Σ Δp_a r_b over collisions, nine numbers by row: a·3 + b. Divided by volume and time it is the collisional part of the pressure tensor. */
    public val virial: DoubleArray = DoubleArray(TENSOR)

    private var lastStep = -1L

    override fun write(simulation: Simulation) {
        if (simulation.step == lastStep || simulation.step == 0L || simulation.time <= from) return
        lastStep = simulation.step
        val record = checkNotNull(simulation.collisions?.record) { "collisions are not recorded; make CollisionForcing with recordCollisions = true" }
        for (k in 0 until record.size) add(record, k)
    }

    private fun add(record: CollisionRecord, k: Int) {
        val speed = record.impactSpeed(k)
        val coefficient = record.coefficient(k)
        val impulse = record.impulse(k)
        count++
        sumSpeed += speed
        sumSpeedSquared += speed * speed
        // impulse = μ (1 + ε) v_n, so the loss ½ μ (1 − ε²) v_n² is half of impulse · (1 − ε) · v_n.
        dissipated += 0.5 * impulse * (1 - coefficient) * speed
        val dx = record.separation(k, 0)
        val dy = record.separation(k, 1)
        val dz = record.separation(k, 2)
        val f = impulse / Math.sqrt(dx * dx + dy * dy + dz * dz)
        for (a in 0..2) for (b in 0..2) virial[a * 3 + b] += f * record.separation(k, a) * record.separation(k, b)
    }

    private companion object {
        const val TENSOR = 9
    }
}
