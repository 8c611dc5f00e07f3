package daphnis.core.force.thermostat

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Open
import daphnis.core.random.CounterRandom
import kotlin.math.sqrt

/**
 * The stochastic thermostat: every sphere is accelerated by white noise of its own, ⟨a_i(t) a_j(t')⟩ = ξ² δ_ij δ(t −
 * t'), as in gases that are heated uniformly (Williams & MacKintosh 1996, Phys. Rev. E 54, R9; van Noije & Ernst 1998,
 * Granular Matter 1, 57). Without drag, T of a gas of spheres of one mass grows by m ξ² per unit of time. With a drag γ
 * it is Langevin's, v̇ = −γ v + a, whose solution is taken exactly.
 *
 * @property intensity ξ², in (length/time)² per unit of time: the same for all spheres, or with [overMass] ξ² times mass
 * @property drag γ, per unit of time
 * @property overMass whether the noise is that of a bath of temperature T, the same for spheres of all masses: ξ² =
 *   2 γ T/m, with [intensity] = 2 γ T
 * @throws IllegalArgumentException when a number is negative or not finite
 */
public class WhiteNoise @JvmOverloads constructor(
    seed: Long,
    public val intensity: Double,
    public val drag: Double = 0.0,
    public val overMass: Boolean = false,
    conservesMomentum: Boolean = false,
    override val boundary: BoundaryConditions = Open,
    override val firstBody: Int = Int.MAX_VALUE,
) : RandomKicks(seed, conservesMomentum) {
    init {
        require(intensity >= 0 && intensity.isFinite()) { "intensity is $intensity; it must be at least 0" }
        require(drag >= 0 && drag.isFinite()) { "drag is $drag; it must be at least 0" }
    }

    /** e^{−γh} − 1, and the standard deviation of a kick. */
    private var loss = 0.0
    private var sigma = 0.0

    override fun prepare(duration: Double) {
        loss = StrictMath.expm1(-drag * duration)
        val time = if (drag * duration == 0.0) duration else -StrictMath.expm1(-2 * drag * duration) / (2 * drag)
        sigma = sqrt(intensity * time)
    }

    override fun kick(w: Double, mass: Double, drawn: CounterRandom, word: Int): Double {
        val noise = sigma * drawn.gaussian(word)
        return loss * w + if (overMass) noise / sqrt(mass) else noise
    }
}
