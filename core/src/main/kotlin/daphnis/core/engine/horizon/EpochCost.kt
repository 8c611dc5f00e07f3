package daphnis.core.engine.horizon

import kotlin.math.PI
import kotlin.math.sqrt

/**
 * What a step is expected to cost per sphere, in nanoseconds of the machine on which it was fitted; only ratios count.
 *
 * @param filter by which searches dismiss lines
 * @param threads that share the work
 * @param seen by which the model is corrected
 */
internal class EpochCost(
    private val spheres: Int,
    private val frame: EpochFrame,
    private val cells: EpochCells,
    private val filter: LineFilter,
    private val threads: Int,
    private val seen: SeenWork,
) {
    private val radius = frame.memberRadius
    private val dt = frame.duration

    /** Extents along row axis, middle axis and slow axis; a layer without extent is as thick as its spheres. */
    private val length = DoubleArray(AXES) { maxOf(frame.length[it], 2 * radius) }
    private val density = spheres / (length[0] * length[1] * length[2])
    private val collisions = if (seen.collisions >= 0) seen.collisions else seen.crowding * ofGas()

    /** How many times as long a collision takes as in a system that fits the cache. */
    private val remoteness = maxOf(1.0, Math.pow(spheres / CACHED, GROWTH))

    /** Lines that the search for all tests per sphere, with the numbers that were asked for last. */
    var testsAhead = 0.0
        private set

    /** Whether collisions are worth sharing among groups, with the numbers that were asked for last. */
    var sharesCollisions = true
        private set

    // What a search around a sphere looks at.
    private var rows = 0.0
    private var tests = 0.0

    /** Collisions per sphere and step of a gas: Enskog's, with the contact value of Carnahan and Starling. */
    private fun ofGas(): Double {
        val speed = sqrt((0 until AXES).sumOf { cells.speeds.rms[it] * cells.speeds.rms[it] } / AXES)
        val filling = minOf(4 * PI / 3 * radius * radius * radius * density, MOST_FILLING)
        val free = 1 - filling
        val contact = (1 - filling / 2) / (free * free * free)
        return 2 * sqrt(PI) * density * (2 * radius) * (2 * radius) * speed * dt * contact
    }

    /** In epochs with these numbers of a [HorizonTuning]. */
    fun of(steps: Int, windows: Int, classBound: Double, along: Double, across: Double): Double {
        val time = steps * dt / windows
        val own = 2 * radius + frame.inflation
        look(time, along, across) { own + classBound * cells.speeds.rmsAtLeast(it) * time / 2 }
        testsAhead = tests / 2
        val all = filter.perRun * rows + filter.perLine * tests
        val met = collisions * steps / windows
        val ahead = SEARCH + all / 2 + FILED * met
        val around = SEARCH + ROAMERS + FAR * all + FOUND * met
        val searched = (2 * collisions + seen.strays) * around
        val impacts =
            remoteness * (collisions * (COLLISION + LINES) + searched) +
                ROAMER * seen.roamersWithin(steps.toDouble() / windows)
        val byGroups = impacts * GROUPS / threads + seen.entanglement * joining(collisions / windows) * windows
        sharesCollisions = threads > 1 && byGroups < impacts
        val begun = ((EPOCH + ahead) / threads + SORT) * windows / steps
        return PASS / threads + begun + if (sharesCollisions) byGroups else impacts
    }

    /**
     * What it costs per sphere to join what groups have done in a step with so many [collisions] per sphere: clusters
     * grow with collisions, and the more of them lie across borders.
     */
    fun joining(collisions: Double): Double {
        val borders = threads * 2 * radius / maxOf(length[1], length[2])
        val clustering = maxOf(collisions, FEW_COLLISIONS)
        return JOINING * borders * collisions * clustering * clustering
    }

    /** In the serial engine's steps; sets [serialCollision]. */
    fun serial(): Double {
        look(dt, SERIAL_ALONG, SERIAL_ACROSS) { 2 * radius + cells.speeds.fastest[it] * dt }
        val search = if (frame.hasGiants) SEARCH + CLASSES else SEARCH
        val ahead = search + (ROW * rows + TEST * tests) / 2
        val around = search + SERIAL_FAR * (ROW * rows + TEST * tests)
        serialCollision = remoteness * (SERIAL_COLLISION + 2 * around)
        return SERIAL_PASS + ahead + collisions * serialCollision
    }

    /** What a collision costs in the serial engine, with both searches after it. */
    var serialCollision = 0.0
        private set

    /** What a step of all spheres costs in the serial engine. */
    val serialStep: Double = spheres * serial()

    private inline fun look(time: Double, along: Double, across: Double, margin: (k: Int) -> Double) {
        rows = 1.0
        tests = spheres * seen.crowding
        for (k in 0 until AXES) {
            val range = 2 * margin(k)
            val count = maxOf(1.0, Math.floor(length[k] / range * if (k == 0) along else across))
            val width = length[k] / count
            var seen = range + MEAN_WAY * cells.speeds.rms[k] * time + width
            if (!frame.isPeriodic[k]) seen = minOf(seen, length[k])
            if (k > 0) rows *= seen / width
            tests *= seen / length[k]
        }
    }

    companion object {
        /** Nanoseconds: of a collision that is processed anew, and of a piece of a path compared with another. */
        const val COLLISION_ANEW = 1100.0
        const val COMPARISON = 10.0

        /** Of an entry of roamers that a search looks at, and of a pair of lines that may touch. */
        const val ROAMER = 6.0
        const val PAIR = 25.0

        /** Fitted to gases at filling factors of 0.1 and 0.3, 0.05 to 0.5 collisions per sphere, on two threads. */
        private const val JOINING = 2.3e5
        private const val FEW_COLLISIONS = 0.05
        private const val AXES = 3
        private const val MOST_FILLING = 0.6

        /** Mean speed along an axis of a gas, in units of the root mean square. */
        private const val MEAN_WAY = 0.8

        // Nanoseconds: of a search, of a row of cells and of a sphere in one of the serial engine.
        private const val SEARCH = 30.0
        private const val ROW = 8.0
        private const val TEST = 1.6

        /** Of looking for giants, too. */
        private const val CLASSES = 150.0

        /** For searches all over memory, in units of searches one after the other. */
        private const val FAR = 1.4
        private const val SERIAL_FAR = 1.6
        private const val ROAMERS = 20.0
        private const val COLLISION = 120.0
        private const val SERIAL_COLLISION = 250.0

        /** What an epoch does more at a collision: two lines are drawn, and pairs filed. */
        private const val LINES = 60.0

        /**
         * For each collision that a sphere will have in the epoch, or window: of filing it at the start, and of the
         * lines that a search finds, among them those of members that were thrown out of their places.
         */
        private const val FILED = 35.0
        private const val FOUND = 130.0

        /** Spheres of a system that fits the cache, and how the time of a collision grows beyond. */
        private const val CACHED = 2e4
        private const val GROWTH = 0.3

        /** Of the passes over all in a step, and of those at the start of an epoch. */
        private const val PASS = 25.0
        private const val EPOCH = 30.0
        private const val SORT = 10.0
        private const val SERIAL_PASS = 55.0

        /** What groups cost more than one thread before threads share it. */
        private const val GROUPS = 1.15

        /** Cells in the length that a pair can bridge, in the serial engine's grid. */
        private const val SERIAL_ALONG = 4.0
        private const val SERIAL_ACROSS = 1.0
    }
}
