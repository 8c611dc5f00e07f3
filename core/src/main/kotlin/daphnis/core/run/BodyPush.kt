package daphnis.core.run

import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.collision.CollisionRecord
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.ExactSum
import kotlin.math.sqrt

/**
 * What pushed the body [id] along its orbit since a time. A push P at one place moves the guiding centre by
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
 *
 * @param orbits null without Hill's frame: there is p_y of impacts then, and no rest
 */
internal class BodyPush(val id: Int, val orbits: OrbitalFrequencies?) {
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
    fun others(simulation: Simulation, k: Int): Double {
        val orbits = orbits ?: return Double.NaN
        val square = orbits.radialFactor * orbits.radialFactor
        val whole = simulation.population.mass[k] * orbits.omega * square / 2 * (guidingX(simulation, k) - guiding)
        return whole - impacts
    }

    /** X as if no face had been crossed, of the body at index [k]. NaN without Hill's frame. */
    fun guidingX(simulation: Simulation, k: Int): Double {
        val orbits = orbits ?: return Double.NaN
        val p = simulation.population
        return orbits.guidingX(p.x[k], p.vy[k]) + p.boxesCrossed(id, 0) * width(simulation)
    }

    private fun width(simulation: Simulation) =
        if (simulation.boundary.repeats(0)) simulation.boundary.box.length(0) else 0.0

    /** Counts from the present state on. */
    fun begin(simulation: Simulation) {
        isNew = false
        count = 0
        sum.clear()
        val k = simulation.population.indexOf(id)
        guiding = if (k < 0) Double.NaN else guidingX(simulation, k)
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
        state.put("$id", doubleArrayOf(count.toDouble(), guiding) + sum.parts())
    }

    /** Takes over what [save] put into [state]; nothing where it knows no such body. */
    fun restore(state: OutputState) {
        if ("$id" !in state.names) return
        val numbers = state.doubles("$id")
        require(numbers.size >= 2) { "the state of body $id has ${numbers.size} numbers" }
        isNew = false
        count = numbers[0].toLong()
        guiding = numbers[1]
        sum.clear()
        for (k in 2 until numbers.size) sum.add(numbers[k])
    }
}
