package daphnis.analysis.diffusion

import daphnis.core.format.Snapshot
import daphnis.core.orbit.OrbitalFrequencies

/** A coordinate of particles that is followed over time: one in which they may diffuse, or a velocity. */
public sealed interface Coordinate {
    /** Its name in tables. */
    public val name: String

    /** Whether a snapshot must say how often particles crossed the box. */
    public val needsImages: Boolean get() = true

    /** The unwrapped coordinate of the particle at [index] of [snapshot], whose images must be known if it needs them. */
    public fun of(snapshot: Snapshot, index: Int): Double

    /** Position along [axis] (0 = x, 1 = y, 2 = z): of a periodic axis along which nothing flows. */
    public class Position(internal val axis: Int) : Coordinate {
        override val name: String = "xyz"[axis].toString()

        override fun of(snapshot: Snapshot, index: Int): Double =
            snapshot.position[axis][index] + crossed(snapshot, axis, index)
    }

    /**
     * Guiding centre X of orbits with these [frequencies] in Hill's frame; like x, it grows by L_x per box outward.
     */
    public class GuidingCentre(private val frequencies: OrbitalFrequencies) : Coordinate {
        /** Around a point mass, in a frame of angular speed [omega]. */
        public constructor(omega: Double) : this(OrbitalFrequencies(omega))

        override val name: String = "X"

        override fun of(snapshot: Snapshot, index: Int): Double =
            frequencies.guidingX(snapshot.position[0][index], snapshot.velocity[1][index]) +
                crossed(snapshot, 0, index)
    }

    /** Velocity along [axis] (0 = x, 1 = y, 2 = z), along which nothing flows. */
    public class Velocity(private val axis: Int) : Coordinate {
        override val name: String = "v" + "xyz"[axis]
        override val needsImages: Boolean get() = false

        override fun of(snapshot: Snapshot, index: Int): Double = snapshot.velocity[axis][index]
    }

    private companion object {
        fun crossed(snapshot: Snapshot, axis: Int, index: Int): Double {
            val image =
                checkNotNull(snapshot.image) {
                    "the state at time ${snapshot.time} does not say how often particles crossed the box"
                }
            val own = if (snapshot.periodic[axis]) image[axis][index] * snapshot.lengths[axis] else 0.0
            if (axis != snapshot.slideAxis || snapshot.shearOffset == 0.0) return own
            return own + image[snapshot.normalAxis][index] * snapshot.shearOffset
        }
    }
}

/**
 * Coordinates of particles at many times, unwrapped and relative to their centre of mass, so that a common drift is no
 * displacement. Nor is what moves with the edges of a box that changes: along a periodic axis a displacement is that of
 * the place in edges of the box, times the mean edge of both times. Keeps 8 bytes for each particle, coordinate and time,
 * and 16 more for each particle and coordinate.
 *
 * @param ids of the particles, ascending; they must be in every snapshot
 */
public class Trajectories(public val coordinates: List<Coordinate>, private val ids: IntArray) {
    private val times = ArrayList<Double>()
    private val rows = ArrayList<Array<DoubleArray>>()

    /** Masses in the first state: where spheres swap places, a centre of those of each state would jump. */
    private var weights: DoubleArray? = null

    /** By coordinate: places in the last state, its edge, and what changes of the edge have moved since the first. */
    private val places = arrayOfNulls<DoubleArray>(coordinates.size)
    private val edges = DoubleArray(coordinates.size)
    private val moved = Array(coordinates.size) { DoubleArray(ids.size) }

    /** Number of particles. */
    public val particles: Int get() = ids.size

    /** Number of times. */
    public val size: Int get() = times.size

    init {
        require(ids.isNotEmpty()) { "no particle to follow" }
    }

    /** Time [k]. */
    public fun time(k: Int): Double = times[k]

    /** The [coordinate]-th coordinate of all particles at time [k], in the order of ids. */
    public fun at(k: Int, coordinate: Int): DoubleArray = rows[k][coordinate]

    /**
     * Adds one more state, later than the previous ones.
     *
     * @throws IllegalArgumentException when it is not later, has no images but needs them, or lacks a particle
     */
    public fun add(snapshot: Snapshot) {
        require(times.isEmpty() || snapshot.time > times.last()) {
            "a state at time ${snapshot.time} after one at ${times.last()}; times must ascend"
        }
        require(snapshot.image != null || coordinates.none { it.needsImages }) {
            "the state at time ${snapshot.time} does not say how often particles crossed the box"
        }
        val indices = IntArray(ids.size)
        for (k in ids.indices) {
            indices[k] = java.util.Arrays.binarySearch(snapshot.id, ids[k])
            require(indices[k] >= 0) { "particle ${ids[k]} is missing at time ${snapshot.time}" }
        }
        val weights = weights ?: DoubleArray(ids.size) { snapshot.mass[indices[it]] }.also { weights = it }
        val mass = weights.sum()
        times += snapshot.time
        rows += Array(coordinates.size) { c ->
            val values = DoubleArray(indices.size) { coordinates[c].of(snapshot, indices[it]) }
            withoutBox(c, snapshot, values)
            var centre = 0.0
            for (k in indices.indices) centre += weights[k] * values[k]
            for (k in values.indices) values[k] -= centre / mass
            values
        }
    }

    /** Takes out of [values], places along coordinate [c], what changes of the edge along it have moved. */
    private fun withoutBox(c: Int, snapshot: Snapshot, values: DoubleArray) {
        val axis = (coordinates[c] as? Coordinate.Position)?.axis ?: return
        val edge = if (snapshot.periodic[axis]) snapshot.lengths[axis] else Double.NaN
        val before = places[c]
        if (before != null && edge > 0 && edges[c] > 0 && edge != edges[c]) {
            val mean = (edge + edges[c]) / 2
            for (k in values.indices) {
                val own = (values[k] / edge - before[k] / edges[c]) * mean
                moved[c][k] += values[k] - before[k] - own
            }
        }
        places[c] = values.copyOf()
        edges[c] = edge
        for (k in values.indices) values[k] -= moved[c][k]
    }
}
