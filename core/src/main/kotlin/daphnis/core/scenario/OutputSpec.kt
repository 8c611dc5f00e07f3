package daphnis.core.scenario

import daphnis.core.input.Described
import daphnis.core.wave.ModeSums
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.intOrNull
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive

/**
 * How often to write: a number of steps (`…Every`), 0 for never (checkpoints: only at the start and the end), or in its
 * place an interval of time (`…Interval`), at whose multiples the output is due, counted from time 0. Each key belongs
 * to a [daphnis.core.run.PeriodicOutput].
 *
 * @property transportEvery rows of `transport.csv`: second moments of velocities, scale height, and the momentum that
 *   collisions carried
 *
 * @property modesEvery rows of `modes.csv`: Fourier modes of surface density and velocities
 * @property modes how many of these, beside mode 0
 * @property bodiesEvery rows of `bodies.csv`: places and orbits of the scenario's bodies, and what pushed them
 * @property intervalUnit of all intervals; null for the scenario's unit of time
 */
@Serializable
public class OutputSpec @JvmOverloads constructor(
    @Described("steps per row of `series.csv`; 0 is never, as of all `…Every`; default 1")
    public val seriesEvery: Int = SERIES,
    @Described("steps per snapshot; the final state is always written; default 0")
    public val snapshotEvery: Int = 0,
    @Described("steps per checkpoint; there is always one at the start and one at the end; default 100")
    public val checkpointEvery: Int = CHECKPOINTS,
    @Described("whether `collisions.csv` is written; default false")
    public val collisionLog: Boolean = false,
    @Described("steps per row of `transport.csv`, from which viscosities follow; default 0")
    public val transportEvery: Int = 0,
    @Described("time between rows of `series.csv`, in place of `seriesEvery`; default none")
    public val seriesInterval: Double? = null,
    @Described("time between snapshots, in place of `snapshotEvery`; default none")
    public val snapshotInterval: Double? = null,
    @Described("time between checkpoints, in place of `checkpointEvery`; default none")
    public val checkpointInterval: Double? = null,
    @Described("time between rows of `transport.csv`, in place of `transportEvery`; default none")
    public val transportInterval: Double? = null,
    @Described("unit of all intervals: `time`, the scenario's, or `orbit`, which needs a frame; default `time`")
    public val intervalUnit: IntervalUnit? = null,
    @Described("steps per state in `modes.csv`: waves along x, where the box has to repeat; default 0")
    public val modesEvery: Int = 0,
    @Described("how many modes, 1 to 64: the last one has the wavelength of the box over this; default 8")
    public val modes: Int = MODES,
    @Described("time between states in `modes.csv`, in place of `modesEvery`; default none")
    public val modesInterval: Double? = null,
    @Described(
        "steps per rows of `bodies.csv`, one for each of the `bodies` and each satellite that feels the ring: its " +
            "orbit and what pushed it; default 0",
    )
    public val bodiesEvery: Int = 0,
    @Described("time between rows of `bodies.csv`, in place of `bodiesEvery`; default none")
    public val bodiesInterval: Double? = null,
) {
    /** Every number of steps, by its key. */
    internal fun steps(): Map<String, Int> {
        val tree = EVERY_KEY.encodeToJsonElement(serializer(), this).jsonObject
        return buildMap {
            for ((key, value) in tree) {
                if (key.endsWith(EVERY)) value.jsonPrimitive.intOrNull?.let { put(key, it) }
            }
        }
    }

    /** Every interval that is given, in [intervalUnit], by its key. */
    internal fun intervals(): Map<String, Double> = buildMap {
        seriesInterval?.let { put(SERIES_INTERVAL, it) }
        snapshotInterval?.let { put(SNAPSHOT_INTERVAL, it) }
        checkpointInterval?.let { put(CHECKPOINT_INTERVAL, it) }
        transportInterval?.let { put(TRANSPORT_INTERVAL, it) }
        modesInterval?.let { put(MODES_INTERVAL, it) }
        bodiesInterval?.let { put(BODIES_INTERVAL, it) }
    }

    /** What is wrong with the values: keys with a sentence. */
    internal fun problems(): List<Pair<String, String>> = buildList {
        for ((key, steps) in steps()) if (steps < 0) add(key to "is $steps; must be at least 0 (0 for never)")
        if (modes !in 1..ModeSums.MOST_MODES) {
            add(MODES_KEY to "is $modes; must be at least 1 and at most ${ModeSums.MOST_MODES}")
        }
        val defaults = OutputSpec().steps()
        for ((key, interval) in intervals()) {
            if (!(interval > 0) || interval.isInfinite()) add(key to "is $interval; must be > 0")
            val every = counterpart(key)
            val steps = steps()[every]
            if (steps != 0 && steps != defaults[every]) add(key to "is given together with $every; $ONE_OF_TWO")
        }
    }

    /**
     * The intervals at which a step has to end where its length is free. A checkpoint is no state that anybody wants.
     */
    internal fun stops(): List<Double> =
        listOfNotNull(seriesInterval, snapshotInterval, transportInterval, modesInterval, bodiesInterval)

    /**
     * The same with intervals in units of time, of which an orbit has [orbit], and 0 steps for an output with an
     * interval. So a file says both without asking for both.
     */
    internal fun settled(orbit: Double?): OutputSpec {
        val unit = if (intervalUnit == IntervalUnit.ORBIT) orbit else null
        fun time(interval: Double?) = if (unit == null) interval else interval?.times(unit)
        return OutputSpec(
            if (seriesInterval == null) seriesEvery else 0,
            if (snapshotInterval == null) snapshotEvery else 0,
            if (checkpointInterval == null) checkpointEvery else 0,
            collisionLog,
            if (transportInterval == null) transportEvery else 0,
            time(seriesInterval),
            time(snapshotInterval),
            time(checkpointInterval),
            time(transportInterval),
            if (unit == null) intervalUnit else null,
            if (modesInterval == null) modesEvery else 0,
            modes,
            time(modesInterval),
            if (bodiesInterval == null) bodiesEvery else 0,
            time(bodiesInterval),
        )
    }

    public companion object {
        internal const val SERIES = 1
        internal const val CHECKPOINTS = 100
        internal const val MODES = 8
        internal const val EVERY = "Every"
        internal const val INTERVAL = "Interval"
        internal const val ONE_OF_TWO = "one of the two is enough"
        private const val SERIES_INTERVAL = "series$INTERVAL"
        private const val SNAPSHOT_INTERVAL = "snapshot$INTERVAL"
        private const val CHECKPOINT_INTERVAL = "checkpoint$INTERVAL"
        private const val TRANSPORT_INTERVAL = "transport$INTERVAL"
        private const val MODES_INTERVAL = "modes$INTERVAL"
        private const val MODES_KEY = "modes"
        private const val BODIES_INTERVAL = "bodies$INTERVAL"

        /** Names the keys one by one. */
        @JvmStatic
        public fun builder(): OutputSpecBuilder = OutputSpecBuilder()

        /** The key for a number of steps in place of an interval, and the other way round; null for another key. */
        internal fun counterpart(key: String): String? = when {
            key.endsWith(INTERVAL) -> key.removeSuffix(INTERVAL) + EVERY
            key.endsWith(EVERY) -> key.removeSuffix(EVERY) + INTERVAL
            else -> null
        }
    }
}

/** The unit of intervals of outputs. */
@Serializable
public enum class IntervalUnit {
    /** The scenario's unit of time. */
    @SerialName("time")
    TIME,

    /** An orbit of the frame. */
    @SerialName("orbit")
    ORBIT,
}

private val EVERY_KEY = Json { encodeDefaults = true }
