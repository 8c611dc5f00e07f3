package daphnis.core.population

/**
 * Granular temperature ⟨c²⟩/3 in (length/time)², weighted by mass, with c the peculiar velocity: what is left of the
 * velocity without the mean flow *as it is measured*. Across a driven [flow] that is the straight line that fits best,
 * plus the mean of the rest in slabs (one a hundred spheres, at most twenty), else the mean. Degrees of freedom that
 * the fit takes are made up for, so that there is no bias at small numbers ([PopulationSums.moments]); one sphere alone
 * has none left and gives 0, as no sphere does. This is the number in `series.csv`, `summary.json` and the report, and
 * a third of c_xx + c_yy + c_zz in `transport.csv`. Exact sums; allocates.
 *
 * @param firstBody spheres with ids from this on are left out, such as moonlets; [Int.MAX_VALUE] for none
 */
public fun granularTemperature(population: Population, flow: MeanFlow?, firstBody: Int = Int.MAX_VALUE): Double =
    PopulationSums(flow, null, firstBody).apply { take(population) }.granularTemperature
