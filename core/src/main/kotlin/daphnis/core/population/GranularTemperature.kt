@file:JvmName("GranularTemperature")

package daphnis.core.population

/**
 * Granular temperature ⟨c²⟩/3, in the plane ⟨c²⟩/2, in (length/time)², weighted by mass, where c is the peculiar
 * velocity: the velocity minus the *measured* mean flow. Across a driven [flow] that is the straight line that fits
 * best, plus the mean of the remainder in slabs (one per hundred spheres, at most twenty); otherwise it is the mean.
 * The result is corrected for the degrees of freedom that the fit takes, so that there is no bias at small numbers
 * ([PopulationSums.moments]). A single sphere has none left and gives 0, and so does an empty population. This is the
 * number in `series.csv`, `summary.json` and the report, and that part of c_xx + c_yy + c_zz in `transport.csv`. Sums
 * are exact. Allocates.
 *
 * @param within says what flow is driven, and in what space
 * @param firstBody spheres with this id or a higher one are left out, such as moonlets; [Int.MAX_VALUE] for none
 */
@JvmOverloads
@JvmName("within")
public fun granularTemperature(population: Population, within: Kinematics, firstBody: Int = Int.MAX_VALUE): Double =
    PopulationSums(within.meanFlow, null, firstBody, within.space)
        .apply { take(population) }.granularTemperature

/** The same in three dimensions, across a driven [flow]. */
@JvmOverloads
@JvmName("of")
public fun granularTemperature(population: Population, flow: MeanFlow?, firstBody: Int = Int.MAX_VALUE): Double =
    PopulationSums(flow, null, firstBody).apply { take(population) }.granularTemperature
