package daphnis.core.scenario

/** The keys of an [OutputSpec] by name, from [OutputSpec.builder]; those that are not given have their defaults. */
public class OutputSpecBuilder internal constructor() {
    private val usual = OutputSpec()
    private var series = usual.seriesEvery
    private var snapshots = usual.snapshotEvery
    private var checkpoints = usual.checkpointEvery
    private var collisionLog = usual.collisionLog
    private var transport = usual.transportEvery

    /** Steps between rows of `series.csv`. */
    public fun seriesEvery(steps: Int): OutputSpecBuilder = apply { series = steps }

    /** Steps between snapshots; 0 for none. */
    public fun snapshotEvery(steps: Int): OutputSpecBuilder = apply { snapshots = steps }

    /** Steps between checkpoints; 0 for one at the start and one at the end. */
    public fun checkpointEvery(steps: Int): OutputSpecBuilder = apply { checkpoints = steps }

    /** Writes every collision into `collisions.csv`. */
    public fun collisionLog(): OutputSpecBuilder = apply { collisionLog = true }

    /** Steps between rows of `transport.csv`; 0 for none. */
    public fun transportEvery(steps: Int): OutputSpecBuilder = apply { transport = steps }

    /** The keys together. */
    public fun build(): OutputSpec = OutputSpec(series, snapshots, checkpoints, collisionLog, transport)
}
