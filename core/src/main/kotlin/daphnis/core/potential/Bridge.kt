package daphnis.core.potential

/**
 * A bond with hysteresis, such as a capillary bridge between wet grains (Herminghaus 2005, Adv. Phys. 54, 221) or two
 * surfaces that stick: it forms when the surfaces meet, and breaks when the two are [ratio] times the sum of their
 * radii apart, which takes the energy [energy] and loses it. Two that have less of it along the line of centres turn
 * back there: they are bound.
 *
 * After an impact with the speed v and the coefficient ε two spheres of reduced mass μ leave each other if ε v is at
 * least √(2 energy/μ), with the speed √(ε² v² − 2 energy/μ): below a critical speed they stick, as spheres with adhesion
 * do (Brilliantov, Albers, Spahn & Pöschel 2007, Phys. Rev. E 76, 051302). No force acts in between, and no contact
 * lasts: bound spheres go to and fro between their surfaces and the distance of rupture.
 *
 * @property ratio > 1
 * @property energy > 0, in units of mass · (length/time)²
 * @property radius of two spheres whose bridge takes [energy], > 0
 * @property exponent how it grows with size: as the effective radius r₁ r₂/(r₁ + r₂) to this power. 0 for the same of
 *   all sizes; 4/3 for elastic spheres with adhesion (Johnson, Kendall & Roberts 1971, Proc. R. Soc. A 324, 301)
 * @throws IllegalArgumentException for other numbers
 */
public class Bridge @JvmOverloads constructor(
    public val ratio: Double,
    public val energy: Double,
    public val radius: Double = 1.0,
    public val exponent: Double = 0.0,
) : PairInteraction() {
    override val states: List<PairState> = listOf(
        PairState(0.0, Edge.contact(BRIDGED), null),
        PairState(0.0, Edge.contact(BRIDGED), Edge(ratio, FAR, energy), SizeLaw(radius / 2, exponent)),
    )

    init {
        require(ratio > 1 && ratio.isFinite()) { "a bridge breaks at ratio $ratio; it must be > 1, which is contact" }
        require(radius > 0 && radius.isFinite()) { "the radius of a bridge is $radius; it must be > 0" }
        require(exponent.isFinite()) { "the energy of a bridge goes with the power $exponent of sizes" }
        require(energy > 0 && energy.isFinite()) { "a bridge takes the energy $energy; it must be > 0" }
    }
}

private const val FAR = 0
private const val BRIDGED = 1
