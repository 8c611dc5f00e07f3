package daphnis.analysis.report

import daphnis.core.input.InputException

/**
 * What an analysis is asked for.
 *
 * @property from averages begin at this time, at most that of the last state; null for three eighths of the run, when
 * it is hoped to be steady
 * @property slabs of azimuth for streamlines; [groups] in each; 0 to choose by the number of particles
 * @property elevation of the rays above the x-y plane in degrees, in 0.1..90
 * @property frames states that are averaged at most, evenly spread
 * @property azimuth direction in which the rays climb, from x toward y, in degrees
 * @property occultation what else is computed of the light through the patch
 * @property clusterRatio spheres up to so many sums of their radii apart are in one cluster, in 1..100; null for those
 *   that attract each other, and no clusters of others
 * @property brightness what is computed of the light that the patch reflects; null for nothing
 * @throws InputException for a [clusterRatio] that is not in these bounds, or a [brightness] at an [elevation] at which
 *   light and eye cannot stand so
 */
public class AnalysisOptions @JvmOverloads constructor(
    public val from: Double? = null,
    public val slabs: Int = 0,
    public val groups: Int = 0,
    public val elevation: Double = 28.0,
    public val frames: Int = 40,
    public val azimuth: Double = 0.0,
    public val occultation: OccultationOptions = OccultationOptions(),
    public val clusterRatio: Double? = null,
    public val brightness: BrightnessOptions? = null,
) {
    init {
        brightness?.check(this)
        if (clusterRatio != null && clusterRatio !in 1.0..FARTHEST) {
            val right = "it must be in 1..${FARTHEST.toInt()} sums of radii"
            throw InputException("clusterRatio", null, "is $clusterRatio; $right", isArgument = true)
        }
    }
}

/** The largest ratio that asks for clusters, as of an interaction. */
private const val FARTHEST = 100.0

/** Told how far a long analysis has come. */
public fun interface AnalysisProgress {
    /** [done] of [all] parts are done, [what] comes next. */
    public fun next(done: Int, all: Int, what: String)
}
