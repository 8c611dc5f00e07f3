package daphnis.core.population

import daphnis.core.parallel.RangeBody
import daphnis.core.parallel.RangeLoop

/**
 * Both rounds of sums over the spheres of one population, each by the threads of a loop. The population may be that of
 * a simulation or the part of it that one machine holds. Made once; allocates nothing once warm.
 */
internal class PopulationFold(
    private val flow: MeanFlow?,
    private val firstBody: Int,
    private val carriesHeat: Boolean = false,
) : SumParts {
    private var population: Population? = null
    private var loop: RangeLoop? = null

    // Worker 0 adds to the sums that are asked for, each other one to sums of its own, which are merged into those.
    private var first: FirstMoments? = null
    private var central: CentralMoments? = null
    private val otherFirst = Workers { FirstMoments(flow?.normalAxis ?: 0, firstBody) }
    private val otherCentral = Workers { CentralMoments(flow, firstBody, carriesHeat) }
    private val takeFirst = RangeBody { worker, from, to ->
        (if (worker == 0) first!! else otherFirst[worker - 1]).add(population!!, from, to)
    }
    private val takeCentral = RangeBody { worker, from, to ->
        (if (worker == 0) central!! else otherCentral[worker - 1]).add(population!!, from, to)
    }

    /** Does [act], in which the rounds are over [population] on the threads of [loop]. */
    inline fun over(population: Population, loop: RangeLoop, act: () -> Unit) {
        look(population, loop)
        try {
            act()
        } finally {
            look(null, null)
        }
    }

    fun look(population: Population?, loop: RangeLoop?) {
        this.population = population
        this.loop = loop
    }

    override fun first(sums: FirstMoments) {
        val loop = loop!!
        otherFirst.upTo(loop.workers - 1)
        sums.clear()
        for (k in 0 until otherFirst.count) otherFirst[k].clear()
        first = sums
        loop.run(population!!.size, body = takeFirst)
        for (k in 0 until otherFirst.count) sums.merge(otherFirst[k])
        first = null
    }

    override fun central(means: Means, sums: CentralMoments) {
        val loop = loop!!
        otherCentral.upTo(loop.workers - 1)
        sums.clear(means)
        for (k in 0 until otherCentral.count) otherCentral[k].clear(means)
        central = sums
        loop.run(population!!.size, body = takeCentral)
        for (k in 0 until otherCentral.count) sums.merge(otherCentral[k])
        central = null
    }
}
