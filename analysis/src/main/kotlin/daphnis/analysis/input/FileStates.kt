package daphnis.analysis.input

import daphnis.core.format.FormatException
import daphnis.core.format.Snapshot
import daphnis.core.format.SnapshotFormats
import daphnis.core.input.InputException
import daphnis.core.input.WayOut
import daphnis.core.scenario.BoxDifference
import daphnis.core.scenario.Surroundings
import java.nio.file.Path
import kotlin.math.abs

/**
 * The states of a file of another program, as they can be analysed: of ascending times, each once, in the order of ids,
 * every particle in the box, and with the boxes crossed where the file tells.
 *
 * @param around what a scenario says of space and time; null without one
 * @param timeStep time of a step, for a file without times
 */
internal class FileStates(
    private val path: Path,
    private val around: Surroundings?,
    private val source: String,
    timeStep: Double?,
) {
    private val given = around?.boundary

    /** What a user should know of the file, a line each. */
    val notices = ArrayList<String>()

    /** Whether the file or the caller said the times. */
    val hasTimes: Boolean

    /** Whether every state has velocities: averages over some would be those of others. */
    val hasVelocities: Boolean

    val states: List<Snapshot>

    /** Ids of the particles that are in every state, ascending. */
    val common: IntArray

    init {
        val read = SnapshotFormats.read(path, notices)
        if (read.isEmpty()) throw FormatException("$path: holds no frame")
        for ((k, state) in read.withIndex()) {
            if (state.size == 0) throw FormatException("$path: holds no particle in frame $k")
        }
        hasTimes = read.size == 1 || timeStep != null || knowsTimes(read)
        val once = once(if (timeStep == null) read else timed(read, timeStep))
        common = common(once)
        states = placed(once)
        hasVelocities = knowsVelocities(read)
        states.find { !it.hasRadius }?.let { notices += withoutRadii(it) }
    }

    private fun knowsVelocities(read: List<Snapshot>): Boolean {
        val silent = read.indexOfFirst { !it.hasVelocity }
        if (silent < 0) return true
        val where = if (read.any { it.hasVelocity }) " in frame $silent" else ""
        notices += "$path has no velocities$where: nothing that follows from them is given, such as temperatures"
        return false
    }

    private fun knowsTimes(read: List<Snapshot>): Boolean {
        val silent = read.indexOfFirst { !it.hasTime }
        if (silent < 0) return true
        val speaking = read.indexOfFirst { it.hasTime }
        if (speaking >= 0) throw FormatException("$path: frame $silent has no time, frame $speaking has one")
        if (given?.shear != null || around?.angularSpeed != null) {
            throw InputException(
                "timeStep",
                null,
                "is missing: $path has no times, on which the scenario's frame and images depend",
                isArgument = true,
            )
        }
        notices += "$path has no times: steps are numbered, and nothing per unit of time is given; " +
            WayOut.GIVE_TIME_STEP.words
        return false
    }

    private fun timed(read: List<Snapshot>, timeStep: Double): List<Snapshot> {
        fun refuse(why: String): Nothing = throw InputException("timeStep", null, why, isArgument = true)
        if (!(timeStep > 0 && timeStep.isFinite())) refuse("is $timeStep; it must be > 0")
        val speaking = read.find { it.hasTime }
        if (speaking != null) refuse("is $timeStep; leave it out, since $path has times, such as ${speaking.time}")
        return read.map { it.at(it.step * timeStep) }
    }

    /** A program that goes on after an end often writes the state there twice. */
    private fun once(read: List<Snapshot>): List<Snapshot> {
        val kept = ArrayList<Snapshot>()
        val frames = HashMap<Double, Int>()
        for ((k, state) in read.withIndex()) {
            val last = kept.lastOrNull()
            if (last == null || state.time > last.time) {
                frames[state.time] = k
                kept += state
                continue
            }
            val before = frames[state.time]
            val moment = moment(state)
            if (before == null) throw FormatException("$path: frame $k is of $moment, after ${number(last)}; $ASCEND")
            if (!isSame(read[before], state)) {
                throw FormatException("$path: frames $before and $k are both of $moment and differ; $ASCEND")
            }
            notices += "$path: frame $k is frame $before again, of $moment, and is left out"
        }
        return kept
    }

    private fun moment(state: Snapshot) = "${if (hasTimes) "time" else "step"} ${number(state)}"

    private fun number(state: Snapshot): Number = if (hasTimes) state.time else state.step

    /**
     * Whether two states are the same but for digits that a file may have lost, and boxes by which a particle was moved.
     */
    private fun isSame(a: Snapshot, b: Snapshot): Boolean = a.id.contentEquals(b.id) &&
        isSame(a.lengths, b.lengths, 0.0) &&
        a.periodic.contentEquals(b.periodic) &&
        abs(a.shearOffset - b.shearOffset) <= SAME * extent(a, a.slideAxis) &&
        (0..2).all { isSamePlace(a, b, it) } &&
        maxOf(largest(a.velocity[0]), largest(a.velocity[1]), largest(a.velocity[2])).let { speed ->
            (0..2).all { isSame(a.velocity[it], b.velocity[it], speed) }
        } &&
        isSame(a.radius, b.radius, 0.0) &&
        isSame(a.mass, b.mass, 0.0)

    /** The edge of the box along [axis], or in open space how far particles are apart. */
    private fun extent(a: Snapshot, axis: Int) =
        if (a.lengths[axis] > 0) a.lengths[axis] else a.position[axis].max() - a.position[axis].min()

    private fun largest(of: DoubleArray) = of.maxOf { abs(it) }

    /** Whether places are the same, or whole boxes apart where the box repeats and is upright. */
    private fun isSamePlace(a: Snapshot, b: Snapshot, axis: Int): Boolean {
        val scale = extent(a, axis)
        val isRound = a.periodic[axis] && a.lengths[axis] > 0 && a.shearOffset == 0.0
        return a.id.indices.all { k ->
            val moved = a.position[axis][k] - b.position[axis][k]
            val rest = if (isRound) Math.IEEEremainder(moved, a.lengths[axis]) else moved
            abs(rest) <= SAME * maxOf(scale, abs(a.position[axis][k]))
        }
    }

    /** @param scale of what may have lost digits, where it is more than the number itself */
    private fun isSame(a: DoubleArray, b: DoubleArray, scale: Double) =
        a.indices.all { a[it].isNaN() && b[it].isNaN() || abs(a[it] - b[it]) <= SAME * maxOf(scale, abs(a[it])) }

    private fun common(states: List<Snapshot>): IntArray {
        val first = states[0].id
        val other = states.indexOfFirst { !it.id.contentEquals(first) }
        if (other < 0) return first
        val ids = first.toHashSet()
        for (state in states) ids.retainAll(state.id.toHashSet())
        val new = states[other].id.find { java.util.Arrays.binarySearch(first, it) < 0 }
        val said = if (new != null) {
            "particle $new is at ${moment(states[other])} and not at ${moment(states[0])}"
        } else {
            val gone = first.first { java.util.Arrays.binarySearch(states[other].id, it) < 0 }
            "particle $gone is at ${moment(states[0])} and not at ${moment(states[other])}"
        }
        notices += "$path: $said; where particles are followed, it is the ${ids.size} that are in every state"
        return ids.toIntArray().apply { sort() }
    }

    /** Every particle in the box, which is the scenario's where the file has none. */
    private fun placed(states: List<Snapshot>): List<Snapshot> {
        val canFollow = knowsWho(states)
        val isUnwrapped = canFollow && Unwrapping.isIn(states, common)
        if (isUnwrapped && states.size > 1) {
            notices +=
                "$path: places go on outside the box and are taken as unwrapped: displacements are their differences"
        }
        return states.mapIndexed { k, state ->
            val known = if (isUnwrapped) {
                state.unwrapped()
            } else if (canFollow) {
                state
            } else {
                state.unknownImages()
            }
            if (given != null) {
                val difference = BoxDifference.of(given, state, state.time, "frame $k of $path")
                if (difference != null) throw InputException(source, difference.key, difference.problem)
            }
            given?.let { requireNear(it, state, "$path: frame $k") }
            val hasBox = (0..2).all { given?.repeats(it) != true || state.periodic[it] && !state.lengths[it].isNaN() }
            if (hasBox) known.folded() else known.folded(given)
        }
    }

    /** Whether a particle of one state is that of the same id in another. */
    private fun knowsWho(states: List<Snapshot>): Boolean {
        if (states.size < 2 || states.all { it.hasId }) return true
        val isSameNumber = states.all { it.size == states[0].size }
        if (isSameNumber && SnapshotFormats.of(path).keeps.keepsOrder) return true
        val why = if (isSameNumber) "LAMMPS changes the order of particles" else "the number of particles changes"
        notices += "$path has no ids, and $why: none is followed, so there is no diffusion"
        return false
    }

    private fun withoutRadii(snapshot: Snapshot): String {
        val taken = snapshot.radius.firstOrNull()
        return "$path has no radii: $taken is taken for each; depths, filling factors and occultations are of that"
    }

    private companion object {
        const val ASCEND = "times must ascend"
        const val SAME = 1e-6
    }
}
