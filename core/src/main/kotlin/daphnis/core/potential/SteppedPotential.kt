package daphnis.core.potential

/**
 * A potential energy of two spheres that is constant between edges (Alder & Wainwright 1959, J. Chem. Phys. 31, 459):
 * at a distance below ratio k times the sum of the radii, and not below ratio k + 1, it is energy k. Beyond all edges it
 * is 0. Spheres are hard: surfaces meet at ratio 1. With an edge at ratio 1 they are not, and within it they may pass
 * through one another.
 *
 * @param ratios from the largest to the smallest, each at least 1
 * @param energies in units of mass · (length/time)²; neighbours differ, the first from 0
 * @throws IllegalArgumentException for other numbers
 */
public class SteppedPotential(ratios: DoubleArray, energies: DoubleArray) : PairInteraction() {
    override val states: List<PairState>

    init {
        require(ratios.isNotEmpty()) { "a stepped potential has no steps" }
        require(ratios.size == energies.size) { "there are ${ratios.size} ratios and ${energies.size} energies" }
        var last = 0.0
        for (k in ratios.indices) {
            problem(ratios[k], ratios.getOrNull(k - 1), energies[k], last)?.let { throw IllegalArgumentException(it) }
            last = energies[k]
        }
        fun energy(state: Int) = if (state == 0) 0.0 else energies[state - 1]
        fun edge(k: Int, from: Int, next: Int) = Edge(ratios[k], next, energy(next) - energy(from))
        states = (0..ratios.size).map { state ->
            val inner = when {
                state < ratios.size -> edge(state, state, state + 1)
                ratios.last() == 1.0 -> null
                else -> Edge.contact(state)
            }
            PairState(energy(state), inner, if (state == 0) null else edge(state - 1, state, state - 1))
        }
    }

    public companion object {
        /** Attraction of [depth] up to [ratio] times the sum of the radii. */
        @JvmStatic
        public fun squareWell(ratio: Double, depth: Double): SteppedPotential =
            SteppedPotential(doubleArrayOf(ratio), doubleArrayOf(-depth))

        /** Repulsion of [height] up to [ratio] times the sum of the radii. */
        @JvmStatic
        public fun squareShoulder(ratio: Double, height: Double): SteppedPotential =
            SteppedPotential(doubleArrayOf(ratio), doubleArrayOf(height))

        /** What is wrong with a step of [ratio] and [energy] that follows one of [ratioBefore] and [energyBefore]. */
        internal fun problem(ratio: Double, ratioBefore: Double?, energy: Double, energyBefore: Double): String? =
            when {
                !(ratio >= 1 && ratio.isFinite()) ->
                    "a step begins at ratio $ratio; it must be at least 1, which is contact"
                ratioBefore != null && ratio >= ratioBefore ->
                    "a step at ratio $ratio follows one at $ratioBefore; ratios must fall"
                !energy.isFinite() -> "the step at ratio $ratio has the energy $energy; it must be finite"
                energy == energyBefore ->
                    "the step at ratio $ratio changes no energy, which is $energy outside of it too"
                else -> null
            }
    }
}
