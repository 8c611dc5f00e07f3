package daphnis.core.population

/**
 * Partial temperatures of a population whose spheres have materials, from exact sums ([ExactSum]), so that they are the
 * same to the last bit for every order of the arrays. Made once and filled by [take].
 *
 * @property materials names by number, see [Population.materials]
 * @param flow the mean flow that the boundary drives, or null
 * @param firstBody spheres with this id or a higher one are left out, such as moonlets; [Int.MAX_VALUE] for none
 */
public class MaterialSums @JvmOverloads constructor(
    public val materials: List<String>,
    private val flow: MeanFlow? = null,
    private val firstBody: Int = Int.MAX_VALUE,
) {
    private val energies = Array(materials.size) { ExactSum() }
    private val counts = LongArray(materials.size)

    /** Number of spheres of the material of [number]. */
    public fun count(number: Int): Long = counts[number]

    /**
     * T = ⟨m c²⟩/3 of the spheres of the material of [number], an energy: c is the velocity without the boundary's flow
     * and without the mean of all materials, weighted by mass (Garzó & Dufty 1999, Phys. Rev. E 60, 5706). No correction
     * for degrees of freedom. NaN without spheres.
     */
    public fun temperature(number: Int): Double =
        if (counts[number] > 0) energies[number].value() / counts[number] / AXES else Double.NaN

    /**
     * Takes the sums of the present state of [population].
     *
     * @param sums of the same state
     */
    public fun take(population: Population, sums: PopulationSums) {
        for (sum in energies) sum.clear()
        counts.fill(0)
        if (!population.hasMaterials) return
        val p = population
        val c = DoubleArray(AXES)
        for (k in 0 until p.size) {
            if (p.id[k] >= firstBody) continue
            for (axis in 0 until AXES) c[axis] = p.velocity(axis)[k] - sums.mean[axis]
            if (flow != null) c[flow.flowAxis] -= flow.rate * p.position(flow.normalAxis)[k]
            val number = p.material[k].toInt()
            counts[number]++
            energies[number].add(p.mass[k] * (c[0] * c[0] + c[1] * c[1] + c[2] * c[2]))
        }
    }

    private companion object {
        const val AXES = 3
    }
}
