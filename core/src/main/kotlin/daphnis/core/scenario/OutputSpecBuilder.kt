package daphnis.core.scenario

/** The keys of an [OutputSpec] by name, from [OutputSpec.builder]; those that are not given have their defaults. */
public class OutputSpecBuilder internal constructor() {
    private val usual = OutputSpec()
    private var series = usual.seriesEvery
    private var snapshots = usual.snapshotEvery
    private var checkpoints = usual.checkpointEvery
    private var collisionLog = usual.collisionLog
    private var transport = usual.transportEvery
    private var seriesInterval: Double? = null
    private var snapshotInterval: Double? = null
    private var checkpointInterval: Double? = null
    private var transportInterval: Double? = null
    private var bodies = usual.bodiesEvery
    private var bodiesInterval: Double? = null
    private var unit: IntervalUnit? = null
    private var modesEvery = usual.modesEvery
    private var modes = usual.modes
    private var modesInterval: Double? = null

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

    /** Time between rows of `series.csv`, in place of steps; the unit of this and other times is [intervalUnit]. */
    public fun seriesInterval(time: Double): OutputSpecBuilder = apply { seriesInterval = time }

    /** Time between snapshots. */
    public fun snapshotInterval(time: Double): OutputSpecBuilder = apply { snapshotInterval = time }

    /** Time between checkpoints. */
    public fun checkpointInterval(time: Double): OutputSpecBuilder = apply { checkpointInterval = time }

    /** Time between rows of `transport.csv`. */
    public fun transportInterval(time: Double): OutputSpecBuilder = apply { transportInterval = time }

    /** Steps between states in `modes.csv`; 0 for none. */
    public fun modesEvery(steps: Int): OutputSpecBuilder = apply { modesEvery = steps }

    /** Time between states in `modes.csv`. */
    public fun modesInterval(time: Double): OutputSpecBuilder = apply { modesInterval = time }

    /** How many modes `modes.csv` has, beside mode 0. */
    public fun modes(count: Int): OutputSpecBuilder = apply { modes = count }

    /** Steps between rows of `bodies.csv`; 0 for none. */
    public fun bodiesEvery(steps: Int): OutputSpecBuilder = apply { bodies = steps }

    /** Time between rows of `bodies.csv`. */
    public fun bodiesInterval(time: Double): OutputSpecBuilder = apply { bodiesInterval = time }

    /** The unit of times; that of the scenario if this is not called. */
    public fun intervalUnit(unit: IntervalUnit): OutputSpecBuilder = apply { this.unit = unit }

    /** The keys together. */
    public fun build(): OutputSpec = OutputSpec(
        series,
        snapshots,
        checkpoints,
        collisionLog,
        transport,
        seriesInterval,
        snapshotInterval,
        checkpointInterval,
        transportInterval,
        unit,
        modesEvery,
        modes,
        modesInterval,
        bodies,
        bodiesInterval,
    )
}
