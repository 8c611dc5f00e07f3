package daphnis.analysis.report

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
 */
public class AnalysisOptions @JvmOverloads constructor(
    public val from: Double? = null,
    public val slabs: Int = 0,
    public val groups: Int = 0,
    public val elevation: Double = 28.0,
    public val frames: Int = 40,
    public val azimuth: Double = 0.0,
    public val occultation: OccultationOptions = OccultationOptions(),
)

/** Told how far a long analysis has come. */
public fun interface AnalysisProgress {
    /** [done] of [all] parts are done, [what] comes next. */
    public fun next(done: Int, all: Int, what: String)
}
