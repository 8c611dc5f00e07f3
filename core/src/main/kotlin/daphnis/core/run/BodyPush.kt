package daphnis.core.run

import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.collision.CollisionRecord
import daphnis.core.population.ExactSum
import kotlin.math.sqrt

/**
 * What pushed a [body] along its orbit since a time. A push P at one place moves the guiding centre by
 *
 * ```
 *   ΔX = 2 P Ω / (m κ²)
 * ```
 *
 * and free motion does not move it. P times the distance from the planet is the change of angular momentum. So P of
 * everything together follows from X, and P of the impacts from their impulses p. An impact at time t within a step of
 * length h also displaces the body until the end of the step. To first order in h its push is p_y + Ω (h − 2t) p_x: the
 * sum [impacts] is off by (Ωh)² of it, and [others], the rest, by as much. The sum is exact, so the order in which an
 * engine finds impacts changes no bit.
 * Without Hill's frame there is p_y of impacts, and no rest.
 */
internal class BodyPush(val body: Traced) {
    private val orbits = body.orbits
    private val sum = ExactSum()
    private var guiding = Double.NaN

    /** Whether [begin] was not called yet, nor [restore]. */
    var isNew = true
        private set

    /** Impacts since the beginning. */
    var count = 0L
        private set

    /** P of impacts. */
    val impacts: Double get() = sum.value()

    /** P of everything else: gravity of the ring, of other bodies and of satellites. NaN without Hill's frame. */
    fun others(simulation: Simulation): Double {
        val orbits = orbits ?: return Double.NaN
        val square = orbits.radialFactor * orbits.radialFactor
        val whole = body.mass(simulation) * orbits.omega * square / 2 * (body.guidingX(simulation) - guiding)
        return whole - impacts
    }

    /** Counts from the present state on. */
    fun begin(simulation: Simulation) {
        isNew = false
        count = 0
        sum.clear()
        guiding = body.guidingX(simulation)
    }

    /** Adds impact [k] of [record] in a step of [duration]; [sign] is −1 where the body has the lower id. */
    fun add(record: CollisionRecord, k: Int, sign: Double, duration: Double) {
        val dx = record.separation(k, 0)
        val dy = record.separation(k, 1)
        val dz = record.separation(k, 2)
        val along = record.impulse(k) / sqrt(dx * dx + dy * dy + dz * dz)
        val px = along * dx + record.tangentialImpulse(k, 0)
        val py = along * dy + record.tangentialImpulse(k, 1)
        val omega = orbits?.omega ?: 0.0
        sum.add(sign * (py + omega * (duration - 2 * record.time[k]) * px))
        count++
    }

    fun save(state: OutputState) {
        state.put("${body.id}", doubleArrayOf(count.toDouble(), guiding) + sum.parts())
    }

    /** Takes over what [save] put into [state]; nothing where it knows no such body. */
    fun restore(state: OutputState) {
        if ("${body.id}" !in state.names) return
        val numbers = state.doubles("${body.id}")
        require(numbers.size >= 2) { "the state of body ${body.id} has ${numbers.size} numbers" }
        isNew = false
        count = numbers[0].toLong()
        guiding = numbers[1]
        sum.clear()
        for (k in 2 until numbers.size) sum.add(numbers[k])
    }
}
