package daphnis.core.force.mesh

/** Complex numbers in rows, real and imaginary parts apart. */
internal class ComplexRows {
    var re = DoubleArray(0)
        private set
    var im = DoubleArray(0)
        private set

    /** Room for so many numbers; what was there may be lost. */
    fun ensure(count: Int) {
        if (im.size >= count) return
        re = DoubleArray(count)
        im = DoubleArray(count)
    }
}

/**
 * Fourier transforms of many rows at once: of [length] rows of equal width, along the rows' number, Σ x_j e^(−2πi
 * jk/n). All columns take the same steps, so a column has the same bits whatever is beside it, and the inner loops run
 * along memory (Stockham's sorted form: Van Loan 1992, Computational Frameworks for the FFT, section 1.7). Not
 * normalised: there and back multiplies by [length]. Shared by threads.
 *
 * @param length a product of twos and threes
 */
internal class BatchTransform(val length: Int) {
    private val radices: IntArray
    private val cosines = DoubleArray(length) { StrictMath.cos(2 * Math.PI * it / length) }
    private val sines = DoubleArray(length) { -StrictMath.sin(2 * Math.PI * it / length) }

    init {
        val found = ArrayList<Int>()
        var rest = length
        for (radix in intArrayOf(4, 3, 2)) {
            while (rest % radix == 0) {
                found.add(radix)
                rest /= radix
            }
        }
        require(length > 0 && rest == 1) { "length is $length; it must be a product of twos and threes" }
        radices = found.toIntArray()
    }

    /** Transforms [rows], each [width] numbers; uses [spare] and returns the one of the two with the result. */
    fun forward(rows: ComplexRows, spare: ComplexRows, width: Int): ComplexRows {
        spare.ensure(length * width)
        var from = rows
        var to = spare
        var left = length
        var stride = width
        for (radix in radices) {
            stage(radix, left, stride, from.re, from.im, to.re, to.im)
            left /= radix
            stride *= radix
            from = to.also { to = from }
        }
        return from
    }

    /** The same with +i. */
    fun backward(rows: ComplexRows, spare: ComplexRows, width: Int): ComplexRows {
        spare.ensure(length * width)
        var from = rows
        var to = spare
        var left = length
        var stride = width
        for (radix in radices) {
            stage(radix, left, stride, from.im, from.re, to.im, to.re)
            left /= radix
            stride *= radix
            from = to.also { to = from }
        }
        return from
    }

    private fun stage(
        radix: Int,
        left: Int,
        stride: Int,
        xr: DoubleArray,
        xi: DoubleArray,
        yr: DoubleArray,
        yi: DoubleArray,
    ) {
        val parts = left / radix
        val turn = length / left
        for (p in 0 until parts) {
            val from = stride * p
            val to = stride * radix * p
            val jump = stride * parts
            when (radix) {
                4 -> four(p * turn, from, jump, to, stride, xr, xi, yr, yi)
                3 -> three(p * turn, from, jump, to, stride, xr, xi, yr, yi)
                else -> two(p * turn, from, jump, to, stride, xr, xi, yr, yi)
            }
        }
    }

    private fun two(
        w: Int,
        from: Int,
        jump: Int,
        to: Int,
        count: Int,
        xr: DoubleArray,
        xi: DoubleArray,
        yr: DoubleArray,
        yi: DoubleArray,
    ) {
        val wr = cosines[w]
        val wi = sines[w]
        for (q in 0 until count) {
            val ar = xr[from + q]
            val ai = xi[from + q]
            val br = xr[from + jump + q]
            val bi = xi[from + jump + q]
            yr[to + q] = ar + br
            yi[to + q] = ai + bi
            yr[to + count + q] = (ar - br) * wr - (ai - bi) * wi
            yi[to + count + q] = (ar - br) * wi + (ai - bi) * wr
        }
    }

    private fun three(
        w: Int,
        from: Int,
        jump: Int,
        to: Int,
        count: Int,
        xr: DoubleArray,
        xi: DoubleArray,
        yr: DoubleArray,
        yi: DoubleArray,
    ) {
        val w1r = cosines[w]
        val w1i = sines[w]
        val w2r = cosines[2 * w]
        val w2i = sines[2 * w]
        for (q in 0 until count) {
            val ar = xr[from + q]
            val ai = xi[from + q]
            val br = xr[from + jump + q]
            val bi = xi[from + jump + q]
            val cr = xr[from + 2 * jump + q]
            val ci = xi[from + 2 * jump + q]
            val sr = br + cr
            val si = bi + ci
            val tr = ar - 0.5 * sr
            val ti = ai - 0.5 * si
            // −i (b − c) √3/2
            val ur = HALF_ROOT_3 * (bi - ci)
            val ui = HALF_ROOT_3 * (cr - br)
            yr[to + q] = ar + sr
            yi[to + q] = ai + si
            yr[to + count + q] = (tr + ur) * w1r - (ti + ui) * w1i
            yi[to + count + q] = (tr + ur) * w1i + (ti + ui) * w1r
            yr[to + 2 * count + q] = (tr - ur) * w2r - (ti - ui) * w2i
            yi[to + 2 * count + q] = (tr - ur) * w2i + (ti - ui) * w2r
        }
    }

    private fun four(
        w: Int,
        from: Int,
        jump: Int,
        to: Int,
        count: Int,
        xr: DoubleArray,
        xi: DoubleArray,
        yr: DoubleArray,
        yi: DoubleArray,
    ) {
        val w1r = cosines[w]
        val w1i = sines[w]
        val w2r = cosines[2 * w]
        val w2i = sines[2 * w]
        val w3r = cosines[3 * w]
        val w3i = sines[3 * w]
        for (q in 0 until count) {
            val ar = xr[from + q] + xr[from + 2 * jump + q]
            val ai = xi[from + q] + xi[from + 2 * jump + q]
            val br = xr[from + q] - xr[from + 2 * jump + q]
            val bi = xi[from + q] - xi[from + 2 * jump + q]
            val cr = xr[from + jump + q] + xr[from + 3 * jump + q]
            val ci = xi[from + jump + q] + xi[from + 3 * jump + q]
            // −i (x₁ − x₃)
            val dr = xi[from + jump + q] - xi[from + 3 * jump + q]
            val di = xr[from + 3 * jump + q] - xr[from + jump + q]
            yr[to + q] = ar + cr
            yi[to + q] = ai + ci
            yr[to + count + q] = (br + dr) * w1r - (bi + di) * w1i
            yi[to + count + q] = (br + dr) * w1i + (bi + di) * w1r
            yr[to + 2 * count + q] = (ar - cr) * w2r - (ai - ci) * w2i
            yi[to + 2 * count + q] = (ar - cr) * w2i + (ai - ci) * w2r
            yr[to + 3 * count + q] = (br - dr) * w3r - (bi - di) * w3i
            yi[to + 3 * count + q] = (br - dr) * w3i + (bi - di) * w3r
        }
    }

    companion object {
        private const val HALF_ROOT_3 = 0.86602540378443864676

        /** The least even product of twos and threes that is at least [wanted]. */
        fun lengthFrom(wanted: Double): Int {
            var best = 2
            while (best < wanted) best *= 2
            var threes = 3
            while (threes < best) {
                var length = 2 * threes
                while (length < wanted) length *= 2
                if (length < best) best = length
                threes *= 3
            }
            return best
        }
    }
}
