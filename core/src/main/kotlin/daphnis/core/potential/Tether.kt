package daphnis.core.potential

/**
 * Two spheres bound for good: their distance stays between [least] and [greatest] times the sum of their radii, and at
 * either they bounce without loss (Rapaport 1979, J. Chem. Phys. 71, 3299). At [least] = 1 surfaces meet, as the contact
 * law says.
 *
 * @throws IllegalArgumentException unless 1 ≤ least < greatest
 */
public class Tether(public val least: Double, public val greatest: Double) : PairInteraction() {
    init {
        require(least >= 1 && least < greatest && greatest.isFinite()) {
            "a tether is between $least and $greatest sums of radii; it must be at least 1, and have some play"
        }
    }

    override val states: List<PairState> = listOf(
        PairState(
            0.0,
            if (least == 1.0) Edge.contact(0) else Edge(least, 0, Double.POSITIVE_INFINITY),
            Edge(greatest, 0, Double.POSITIVE_INFINITY),
        ),
    )
}

/**
 * Chains of spheres: those with the ids k·[length] … k·[length] + [length] − 1 are one, in which each is bound by
 * [tether] to the next.
 *
 * @throws IllegalArgumentException unless [length] is at least 2
 */
public class Chains(public val length: Int, public val tether: Tether) {
    init {
        require(length >= 2) { "chains have $length spheres; it must be at least 2" }
    }

    /** Whether the spheres with these ids are neighbours in a chain. */
    internal fun areTied(first: Int, second: Int): Boolean {
        val higher = maxOf(first, second)
        return higher - minOf(first, second) == 1 && higher % length != 0
    }
}
