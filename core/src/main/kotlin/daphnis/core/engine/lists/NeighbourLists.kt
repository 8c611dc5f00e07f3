package daphnis.core.engine.lists

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.search.CellAxes.Companion.AXES
import daphnis.core.space.Images
import kotlin.math.abs

/**
 * For each sphere the spheres that it can touch while neither leaves its shell. A shell is a ball of [ListSpace.shell]
 * around the **reference** of a sphere, the place where it was when its list was made. Two spheres are in one another's
 * lists, each with the image of the other as seen from it, if and only if their references are nearer than the sum of
 * their radii and two shells. A sphere that leaves its shell gets a new reference, see [refresh], and no other list is
 * made anew.
 *
 * An entry is the other sphere, negative ([AT_IMAGE]) where it is at an image other than 0, which [codes] has then.
 */
internal class NeighbourLists(private val rows: StepRows, private val space: ListSpace, private val images: Images) {
    /** Row [sphere] · [stride]: the number of entries, and then the entries. */
    var entries = IntArray(0)
        private set

    /** The image of an entry that is [AT_IMAGE]. */
    var codes = IntArray(0)
        private set

    /** Numbers in a row. */
    var stride = LEAST_STRIDE
        private set

    /** Four numbers per sphere: reference x, y, z, and radius. */
    var reference = DoubleArray(0)
        private set
    private val cells = ListCells()
    private var cellOf = IntArray(0)
    private var isFull = false

    /** The spheres that are in the list that is made have the present [mark]. */
    private var marks = IntArray(0)
    private var mark = 0

    /** Whether there is no room for an entry, or a sphere is too far away: what is known of the step is void. */
    var isLost = false
        private set

    /** Lists made anew one by one since the start. */
    var refreshed = 0L
        private set

    /**
     * Makes all lists from the rows, at the start of a step.
     *
     * @return false when there cannot be lists
     */
    fun build(): Boolean {
        val n = rows.size
        while (true) {
            reserve(n)
            isLost = false
            cells.begin(space.total)
            for (i in 0 until n) {
                setReference(i, 0.0)
                entries[i * stride] = 0
                addNear(i)
                enter(i)
            }
            if (!isLost) return true
            if (!widen()) return false
        }
    }

    /** Makes rows larger that were too small. @return whether there is more room now */
    fun widen(): Boolean {
        val grows = isFull && stride < MOST_STRIDE
        if (grows) stride *= 2
        isFull = false
        return cells.widen() || grows
    }

    private fun reserve(n: Int) {
        if (entries.size < n * stride) {
            codes = IntArray(n * stride)
            entries = IntArray(n * stride)
        }
        if (marks.size < n) {
            cellOf = IntArray(n)
            reference = DoubleArray(4 * n)
            marks = IntArray(n)
        }
        marks.fill(0, 0, n)
        mark = 0
    }

    /** Whether the sphere [i] is in its shell at the place ([x], [y], [z]), with room for rounding. */
    fun isInShell(i: Int, x: Double, y: Double, z: Double): Boolean {
        val ex = x - reference[4 * i]
        val ey = y - reference[4 * i + 1]
        val ez = z - reference[4 * i + 2]
        return ex * ex + ey * ey + ez * ez <= space.shell * space.shell
    }

    /** Gives the sphere [i] a new reference, where it is at [time], and a new list. */
    fun refresh(i: Int, time: Double) {
        refreshed++
        setReference(i, time)
        leave(i)
        enter(i)
        mark++
        val a = reference
        var k = i * stride + entries[i * stride]
        while (k > i * stride) {
            val e = entries[k]
            val j = e and SPHERE
            var dx = a[4 * j] - a[4 * i]
            var dy = a[4 * j + 1] - a[4 * i + 1]
            var dz = a[4 * j + 2] - a[4 * i + 2]
            if (e < 0) {
                dx += images.shift(codes[k], 0)
                dy += images.shift(codes[k], 1)
                dz += images.shift(codes[k], 2)
            }
            val s = a[4 * i + 3] + a[4 * j + 3] + space.reach
            if (dx * dx + dy * dy + dz * dz <= s * s) {
                marks[j] = mark
            } else {
                drop(i, k)
                drop(j, entryOf(j, i))
            }
            k--
        }
        addNear(i)
    }

    private fun setReference(i: Int, time: Double) {
        val state = rows.state
        val p = i * STRIDE
        val elapsed = time - state[p + TIME]
        for (axis in 0 until AXES) {
            val at = state[p + axis] + state[p + VX + axis] * elapsed
            reference[4 * i + axis] = at
            if (space.isTooFar(at, axis)) isLost = true
        }
        reference[4 * i + 3] = state[p + RADIUS]
    }

    /** The sphere [i] has been put elsewhere by so many periods along x, y, z. */
    fun wrap(i: Int, x: Int, y: Int, z: Int) {
        reference[4 * i] += x * images.period(0)
        reference[4 * i + 1] += y * images.period(1)
        reference[4 * i + 2] += z * images.period(2)
        for (k in i * stride + 1..i * stride + entries[i * stride]) {
            val j = entries[k] and SPHERE
            val old = if (entries[k] < 0) codes[k] else 0
            val code = Images.code(
                Images.component(old, 0) + x,
                Images.component(old, 1) + y,
                Images.component(old, 2) + z,
            )
            write(k, j, code)
            write(entryOf(j, i), i, Images.negated(code))
        }
    }

    private fun write(k: Int, j: Int, code: Int) {
        entries[k] = if (code == 0) j else j or AT_IMAGE
        codes[k] = code
    }

    private fun entryOf(i: Int, j: Int): Int {
        var k = i * stride + 1
        while ((entries[k] and SPHERE) != j) k++
        return k
    }

    private fun drop(i: Int, k: Int) {
        val last = i * stride + entries[i * stride]--
        entries[k] = entries[last]
        codes[k] = codes[last]
    }

    private fun add(i: Int, j: Int, code: Int) {
        val count = entries[i * stride] + 1
        entries[i * stride] = count
        write(i * stride + count, j, code)
    }

    private fun hasRoom(i: Int) = entries[i * stride] < stride - 1

    private fun enter(i: Int) {
        val c = cell(cellAlong(i, 0), cellAlong(i, 1), cellAlong(i, 2))
        cellOf[i] = c
        if (!cells.add(c, i)) isLost = true
    }

    private fun leave(i: Int) {
        cells.remove(cellOf[i], i)
    }

    private fun cellAlong(i: Int, axis: Int) = space.cellOfImage(reference[4 * i + axis], axis)

    private fun cell(x: Int, y: Int, z: Int) = (z * space.count[1] + y) * space.count[0] + x

    /** Puts the sphere [i] and those near it that are in cells and not marked into one another's lists. */
    private fun addNear(i: Int) {
        val x = cellAlong(i, 0)
        val y = cellAlong(i, 1)
        val z = cellAlong(i, 2)
        for (dz in -1..1) {
            val cz = beside(z, dz, 2)
            if (cz < 0) continue
            for (dy in -1..1) {
                val cy = beside(y, dy, 1)
                if (cy < 0) continue
                for (dx in -1..1) {
                    val cx = beside(x, dx, 0)
                    if (cx >= 0) addNear(i, cell(cx, cy, cz))
                }
            }
        }
    }

    /** The cell number [c] + [d] along [axis]; −1 when there is none. */
    private fun beside(c: Int, d: Int, axis: Int): Int {
        val n = space.count[axis]
        val at = c + d
        if (at in 0 until n) return at
        return if (space.isPeriodic[axis]) at - d * n else -1
    }

    private fun addNear(i: Int, cell: Int) {
        val a = reference
        val p = 4 * i
        val s = a[p + 3] + space.reach
        val from = cells.first(cell)
        for (k in from until from + cells.count(cell)) {
            val j = cells.spheres[k]
            val q = 4 * j
            val dx = a[q] - a[p]
            val dy = a[q + 1] - a[p + 1]
            val dz = a[q + 2] - a[p + 2]
            val bx = boxes(dx, 0)
            val by = boxes(dy, 1)
            val bz = boxes(dz, 2)
            val ex = dx - bx * space.length[0]
            val ey = dy - by * space.length[1]
            val ez = dz - bz * space.length[2]
            val most = s + a[q + 3]
            if (ex * ex + ey * ey + ez * ez <= most * most && j != i && (mark == 0 || marks[j] != mark)) {
                if (hasRoom(i) && hasRoom(j)) {
                    val code = Images.code(-bx, -by, -bz)
                    add(i, j, code)
                    add(j, i, Images.negated(code))
                } else {
                    isFull = true
                    isLost = true
                }
            }
        }
    }

    /** How many boxes the distance [d] along [axis] is longer than that to the nearest image. */
    private fun boxes(d: Double, axis: Int): Int {
        if (!space.isPeriodic[axis]) return 0
        val length = space.length[axis]
        return if (abs(d) <= 0.5 * length) 0 else Math.rint(d / length).toInt()
    }

    companion object {
        const val AT_IMAGE: Int = 1 shl 31

        /** The part of an entry that is a sphere. */
        const val SPHERE: Int = Int.MAX_VALUE
        private const val LEAST_STRIDE = 32
        private const val MOST_STRIDE = 256
    }
}
