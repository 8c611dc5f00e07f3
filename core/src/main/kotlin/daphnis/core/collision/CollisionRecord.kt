package daphnis.core.collision

import daphnis.core.growth.GrowingTable

/**
 * The collisions of one step in the order (time, rank, lower id, higher id), as a structure of arrays of [size]
 * entries. Filled by the engine when it is asked for; valid until the next step. Among collisions at one time, each
 * comes after those that led to it: its [rank] is one more than that of any collision which one of its spheres had
 * before at that time. The order belongs to the trajectory, so it is the same for every engine.
 *
 * `separation` points from the sphere with the lower id to the one with the higher id.
 *
 * Collisions with walls are recorded only where a wall moves or is thermal. Then [lower] is the partner number of the
 * wall, which is negative ([WallContact.partner]), `separation` is the normal into the room times the radius, and
 * [surfaceDissipation] is all the energy that the sphere lost, below 0 where the wall gave some.
 */
public class CollisionRecord() : GrowingTable() {
    /** The collisions that came in a message: [data] has [WIDTH] numbers for each entry of the others. */
    internal constructor(
        time: DoubleArray,
        rank: IntArray,
        lower: IntArray,
        higher: IntArray,
        data: DoubleArray,
    ) : this() {
        reserve(time.size)
        this.time = time
        this.rank = rank
        this.lower = lower
        this.higher = higher
        this.data = data
        size = time.size
    }

    /** Time from the start of the step. */
    public var time: DoubleArray = DoubleArray(0)
        private set

    /** Place among the collisions at the same time that led to one another, from 1; see [StepRows.rank]. */
    public var rank: IntArray = IntArray(0)
        private set

    /** Lower id. */
    public var lower: IntArray = IntArray(0)
        private set

    /** Higher id. */
    public var higher: IntArray = IntArray(0)
        private set

    /**
     * Impact speed, coefficient, impulse, separation x y z, tangential impulse x y z, surface dissipation, energy
     * handed over, what happened at an edge: twelve numbers per collision, tangential impulse and surface dissipation 0
     * for smooth spheres that meet.
     */
    public var data: DoubleArray = DoubleArray(0)
        private set

    override fun resize(room: Int) {
        time = time.copyOf(room)
        rank = rank.copyOf(room)
        lower = lower.copyOf(room)
        higher = higher.copyOf(room)
        data = data.copyOf(room * WIDTH)
    }

    /** Whether collision [k] is one with a wall. */
    public fun isWall(k: Int): Boolean = lower[k] < 0

    /**
     * Whether [k] is no collision but an event at an edge of an interaction ([daphnis.core.potential.PairInteraction]).
     * Then [impactSpeed] is below 0 where the two recede, [impulse] where they attract, [coefficient] where they pass the
     * edge, and [surfaceDissipation] is the energy of motion that is lost and not potential energy after it.
     */
    public fun isEdge(k: Int): Boolean = edge(k) != 0

    /** What happened in [k]: 0 where surfaces met; at an edge 1 inward, 2 outward, 3 turned back. */
    public fun edge(k: Int): Int = data[k * WIDTH + EDGE].toInt()

    public fun impactSpeed(k: Int): Double = data[k * WIDTH]

    public fun coefficient(k: Int): Double = data[k * WIDTH + 1]

    /**
     * Momentum that the sphere with the higher id received along the normal, ≥ 0 in collisions. The other received the
     * opposite.
     */
    public fun impulse(k: Int): Double = data[k * WIDTH + 2]

    /** Component [axis] of the vector between the centres. */
    public fun separation(k: Int, axis: Int): Double = data[k * WIDTH + 3 + axis]

    /**
     * Component [axis] of the momentum that the sphere with the higher id received along its surface, perpendicular to
     * the separation; the other received the opposite. In Hill's frame axes are those at the moment of contact. 0 for
     * smooth spheres.
     */
    public fun tangentialImpulse(k: Int, axis: Int): Double = data[k * WIDTH + 6 + axis]

    /**
     * Energy of motion and of spins that roughness took, ½ μ q/(1 + q) (1 − β²) g² ([daphnis.core.surface.Roughness]);
     * restitution took ½ · [impulse] · (1 − [coefficient]) · [impactSpeed] beside it. Zero or more, and 0 for smooth
     * spheres.
     */
    public fun surfaceDissipation(k: Int): Double = data[k * WIDTH + 9]

    /**
     * Kinetic energy that the impulse along the normal brought from the sphere with the lower id to that with the
     * higher one: [impulse] times the velocity of their centre of mass along the normal. It is all that they exchange
     * if the impact is elastic and both are smooth. Velocities are those in the box, without the slide of images. 0 for
     * walls, and where [add] was not told of velocities.
     */
    public fun handedOver(k: Int): Double = data[k * WIDTH + HANDED_OVER]

    /** Appends a collision between the places [first] and [second] of [rows], whose velocities are those after it. */
    public fun add(time: Double, rows: StepRows, first: Int, second: Int, outcome: CollisionOutcome) {
        add(time, rows.id[first], rows.id[second], outcome)
        val p = (size - 1) * WIDTH
        val dx = data[p + 3]
        val dy = data[p + 4]
        val dz = data[p + 5]
        val m1 = rows.mass[first]
        val m2 = rows.mass[second]
        val state = rows.state
        val v1 = first * StepRows.STRIDE + StepRows.VX
        val v2 = second * StepRows.STRIDE + StepRows.VX
        val momentum = (m1 * state[v1] + m2 * state[v2]) * dx + (m1 * state[v1 + 1] + m2 * state[v2 + 1]) * dy +
            (m1 * state[v1 + 2] + m2 * state[v2 + 2]) * dz
        data[p + HANDED_OVER] = outcome.impulse / Math.sqrt(dx * dx + dy * dy + dz * dz) * (momentum / (m1 + m2))
    }

    /** Appends a collision between the spheres with ids [first] and [second], as described by [outcome]. */
    public fun add(time: Double, first: Int, second: Int, outcome: CollisionOutcome) {
        val k = append()
        val swap = first > second
        this.time[k] = time
        rank[k] = outcome.rank
        lower[k] = if (swap) second else first
        higher[k] = if (swap) first else second
        val p = k * WIDTH
        val sign = if (swap) -1.0 else 1.0
        data[p] = outcome.impactSpeed
        data[p + 1] = outcome.coefficient
        data[p + 2] = outcome.impulse
        // 0.0 for zeros of either sign, whichever sphere was named first.
        data[p + 3] = sign * outcome.separationX + 0.0
        data[p + 4] = sign * outcome.separationY + 0.0
        data[p + 5] = sign * outcome.separationZ + 0.0
        data[p + 6] = sign * outcome.slideX + 0.0
        data[p + 7] = sign * outcome.slideY + 0.0
        data[p + 8] = sign * outcome.slideZ + 0.0
        data[p + 9] = outcome.rubbed
        data[p + HANDED_OVER] = 0.0
        data[p + EDGE] = outcome.edge.toDouble()
    }

    /** Appends entries [from] until [to] of [other]. */
    public fun addAll(other: CollisionRecord, from: Int, to: Int) {
        ensure(size + to - from)
        other.time.copyInto(time, size, from, to)
        other.rank.copyInto(rank, size, from, to)
        other.lower.copyInto(lower, size, from, to)
        other.higher.copyInto(higher, size, from, to)
        other.data.copyInto(data, size * WIDTH, from * WIDTH, to * WIDTH)
        size += to - from
    }

    /**
     * Puts the entries in order. Engines call it at the end of the step, since they may process simultaneous collisions
     * in a different order.
     */
    public fun sort() {
        var k = 1
        while (k < size && !isBefore(k, k - 1)) k++
        if (k >= size) return
        val order = (0 until size).sortedWith { a, b ->
            if (isBefore(a, b)) {
                -1
            } else if (isBefore(b, a)) {
                1
            } else {
                0
            }
        }
        val old = CollisionRecord().also { it.addAll(this, 0, size) }
        size = 0
        for (e in order) addAll(old, e, e + 1)
    }

    private fun isBefore(a: Int, b: Int): Boolean {
        if (time[a] != time[b]) return time[a] < time[b]
        if (rank[a] != rank[b]) return rank[a] < rank[b]
        if (lower[a] != lower[b]) return lower[a] < lower[b]
        return higher[a] < higher[b]
    }

    internal companion object {
        /** Numbers in [data] for each collision. */
        const val WIDTH = 12
        private const val HANDED_OVER = 10
        private const val EDGE = 11
    }
}
