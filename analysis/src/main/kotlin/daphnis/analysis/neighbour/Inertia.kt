package daphnis.analysis.neighbour

/** The tensor of inertia I of bodies about a point, and their angular momentum L about it. */
internal class Inertia {
    /** Σ m x², Σ m y², Σ m z², Σ m yz, Σ m zx, Σ m xy. */
    private val moments = DoubleArray(6)

    /** The part of I that is the same about all axes. */
    private var round = 0.0
    private val momentum = DoubleArray(3)

    /** A point of [mass] at [r] with the velocity [v]. */
    fun add(mass: Double, r: DoubleArray, v: DoubleArray) {
        for (a in 0..2) {
            val b = (a + 1) % 3
            val c = (a + 2) % 3
            moments[a] += mass * r[a] * r[a]
            moments[3 + a] += mass * r[b] * r[c]
            momentum[a] += mass * (r[b] * v[c] - r[c] * v[b])
        }
    }

    /** A sphere with the [moment] of inertia m about its centre that turns. */
    fun spin(moment: Double, wx: Double, wy: Double, wz: Double) {
        round += moment
        momentum[0] += moment * wx
        momentum[1] += moment * wy
        momentum[2] += moment * wz
    }

    operator fun plus(other: Inertia) = Inertia().also { sum ->
        for (k in moments.indices) sum.moments[k] = moments[k] + other.moments[k]
        for (k in 0..2) sum.momentum[k] = momentum[k] + other.momentum[k]
        sum.round = round + other.round
    }

    /** I about axis [a]. */
    private fun about(a: Int) = moments[(a + 1) % 3] + moments[(a + 2) % 3] + round

    /** About how many axes the bodies can turn: fewer where all are in a row, or at the point itself. */
    fun rotations(isPlane: Boolean): Int = when {
        about(0) + about(1) + about(2) == 0.0 -> 0
        isPlane -> 1
        isRow() -> 2
        else -> 3
    }

    /** The least ω for which I ω is as near L as can be. */
    fun rotation(isPlane: Boolean): DoubleArray {
        val half = (about(0) + about(1) + about(2)) / 2
        return when {
            half == 0.0 -> DoubleArray(3)
            isPlane -> doubleArrayOf(0.0, 0.0, momentum[2] / about(2))
            // L is across the row, and I is the same about all axes across it.
            isRow() -> DoubleArray(3) { momentum[it] / half }
            else -> solved()
        }
    }

    private fun isRow(): Boolean {
        val half = (about(0) + about(1) + about(2)) / 2
        return determinant() <= THIN * half * half * half
    }

    /** Entry of I. */
    private fun entry(a: Int, b: Int) = if (a == b) about(a) else -moments[3 + (3 - a - b)]

    private fun cofactor(a: Int, b: Int): Double {
        val (i, j) = (a + 1) % 3 to (a + 2) % 3
        val (k, l) = (b + 1) % 3 to (b + 2) % 3
        return entry(i, k) * entry(j, l) - entry(i, l) * entry(j, k)
    }

    private fun determinant() = (0..2).sumOf { entry(0, it) * cofactor(0, it) }

    private fun solved(): DoubleArray {
        val whole = determinant()
        return DoubleArray(3) { a -> (0..2).sumOf { cofactor(it, a) * momentum[it] } / whole }
    }

    private companion object {
        /** Of the least moment of inertia over the others, below which bodies are in a row. */
        const val THIN = 1e-9
    }
}
