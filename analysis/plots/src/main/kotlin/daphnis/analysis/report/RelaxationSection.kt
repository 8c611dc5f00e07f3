package daphnis.analysis.report

import daphnis.analysis.correlation.SpatialStructureFactor
import daphnis.analysis.diffusion.Coordinate
import daphnis.analysis.diffusion.IntermediateScattering
import daphnis.analysis.diffusion.MeanSquareDisplacement
import daphnis.analysis.diffusion.Trajectories
import daphnis.core.format.Snapshot

/** How a box at rest that repeats along all axes forgets where its particles were: each of them, and all together. */
internal class RelaxationSection(private val study: Study) : Section {
    private val input = study.input
    private val last = study.lastSnapshot
    private val diameter = 2 * study.bulk.meanRadius
    private val axes = (0 until study.last.dimensions).toList()
    private val ids = input.idsThroughout().filter { !input.isBody(it) }
    private val chosen = chosen()
    override val applies: Boolean = input.omega == null &&
        input.hasTimes &&
        !study.isGrowing &&
        !SourcesSection.areThere(study) &&
        last.image != null &&
        study.last.boundary.meanFlow == null &&
        axes.all { last.periodic[it] } &&
        chosen.size >= MeanSquareDisplacement.FEWEST_TIMES &&
        ids.size >= 2
    private var trajectories = if (applies) Trajectories(axes.map { Coordinate.Position(it) }, taken()) else null

    /**
     * Where S(k) of the last state is highest, over three bins, near one wave in a diameter; just that wave for a gas
     * too dilute to have a peak.
     */
    private val waveNumber: Double by lazy {
        if (study.bulk.fillingFactor < LEAST_FILLED) return@lazy 2 * Math.PI / diameter
        val factor = SpatialStructureFactor(PEAKS * 2 * Math.PI / diameter, BINS)
        val s = factor.of(study.last)
        val peak = (BINS * 3 / 8 until BINS - 1).maxBy {
            (s[it - 1] + s[it] + s[it + 1]).let { v -> if (v.isNaN()) 0.0 else v }
        }
        factor.waveNumbers(study.last)[peak]
    }

    /** Of all particles: none where some come or go, or where the box changes. */
    private var scattering = if (applies && ids.size == study.bulk.particles && !study.boxes.isChanging) {
        IntermediateScattering(waveNumber - SHELL / diameter, waveNumber + SHELL / diameter)
    } else {
        null
    }
    private var seen = 0

    override val heading = "Relaxation"
    override val over get() = "How particles forget where they were. " +
        "${ReportText.count(chosen.size, "state")} from time ${study.time(study.from)} on."
    override val followed = if (applies) chosen else emptyList()

    override fun follow(snapshot: Snapshot) {
        val state = input.state(chosen[seen++], snapshot)
        if (snapshot.image == null) trajectories = null
        trajectories?.add(snapshot)
        val particles = (0 until state.population.size).count { state.isParticle(it) }
        if (particles == ids.size) scattering?.add(state) else scattering = null
    }

    override val leftOut get() = "the states do not say how often particles crossed the box".takeIf {
        trajectories ==
            null
    }

    override fun write(page: ReportPage) {
        val t = trajectories ?: return
        ScatteringPart(study, t, waveNumber).write(page)
        RelaxationPart(study, t, diameter, t.particles == study.bulk.particles).write(page, scattering)
    }

    /** Every n-th of many. */
    private fun taken(): IntArray {
        val every = maxOf(1, (ids.size + MOST_PARTICLES - 1) / MOST_PARTICLES)
        return ids.filterIndexed { k, _ -> k % every == 0 }.toIntArray()
    }

    private fun chosen(): List<Int> {
        val most = (MOST_VALUES / maxOf(1, ids.size)).coerceIn(FEW_STATES, MOST_STATES)
        val late = input.times.indices.filter { input.times[it] >= study.from }
        val every = maxOf(1, (late.size + most - 1) / most)
        return late.filterIndexed { k, _ -> k % every == 0 }
    }

    private companion object {
        const val LEAST_FILLED = 0.1
        const val PEAKS = 1.6
        const val BINS = 64

        /** Half the width of the shell of wave vectors, times the diameter. */
        const val SHELL = 0.15

        /** Bounds on memory: 61 MB, and on time: seconds. */
        const val MOST_PARTICLES = 20_000
        const val MOST_VALUES = 2_560_000
        const val FEW_STATES = 128
        const val MOST_STATES = 512
    }
}
