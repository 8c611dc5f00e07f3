package daphnis.core.force.mesh

/** What one thread needs to transform and to multiply planes. */
internal class MeshWorker(private val planes: Int) {
    val a = ComplexRows()
    val b = ComplexRows()

    /** By planes apart. */
    val kernel = DoubleArray(planes)
    private val re = DoubleArray(planes)
    private val im = DoubleArray(planes)
    private val sumRe = DoubleArray(planes / 2)
    private val sumIm = DoubleArray(planes / 2)
    private val outRe = DoubleArray(planes)
    private val outIm = DoubleArray(planes)

    /** Parts the planes of a wave, at [p] in [rows], by its partner −k at [q]. */
    fun unpack(rows: ComplexRows, p: Int, q: Int) {
        for (pair in 0 until planes / 2) {
            val fr = rows.re[p + pair]
            val fi = rows.im[p + pair]
            val gr = rows.re[q + pair]
            val gi = -rows.im[q + pair]
            re[2 * pair] = 0.5 * (fr + gr)
            im[2 * pair] = 0.5 * (fi + gi)
            re[2 * pair + 1] = 0.5 * (fi - gi)
            im[2 * pair + 1] = 0.5 * (gr - fr)
        }
    }

    /**
     * Σ over planes of the kernel times [scale]. The kernel is the same up and down, so sums of planes as far above the
     * middle as below, and differences, go by themselves, with half the products.
     */
    fun convolve(scale: Double) {
        val half = planes / 2
        for (z in 0 until half) {
            val mirror = planes - 1 - z
            sumRe[z] = re[z] + re[mirror]
            sumIm[z] = im[z] + im[mirror]
            re[z] -= re[mirror]
            im[z] -= im[mirror]
        }
        for (z in 0 until half) {
            var evenRe = 0.0
            var evenIm = 0.0
            var oddRe = 0.0
            var oddIm = 0.0
            for (other in 0 until half) {
                val near = kernel[Math.abs(z - other)]
                val far = kernel[planes - 1 - z - other]
                evenRe += (near + far) * sumRe[other]
                evenIm += (near + far) * sumIm[other]
                oddRe += (near - far) * re[other]
                oddIm += (near - far) * im[other]
            }
            val mirror = planes - 1 - z
            outRe[z] = 0.5 * scale * (evenRe + oddRe)
            outIm[z] = 0.5 * scale * (evenIm + oddIm)
            outRe[mirror] = 0.5 * scale * (evenRe - oddRe)
            outIm[mirror] = 0.5 * scale * (evenIm - oddIm)
        }
    }

    /** Makes the waves at [p] and [q] none. */
    fun clear(rows: ComplexRows, p: Int, q: Int) {
        for (pair in 0 until planes / 2) {
            rows.re[p + pair] = 0.0
            rows.im[p + pair] = 0.0
            rows.re[q + pair] = 0.0
            rows.im[q + pair] = 0.0
        }
    }

    /** Σ over pairs of planes of the kernel times the one and the other's conjugate. */
    fun product(): Double {
        var sum = 0.0
        for (z in 0 until planes) {
            for (other in 0 until planes) {
                sum += kernel[Math.abs(z - other)] * (re[z] * re[other] + im[z] * im[other])
            }
        }
        return sum
    }

    fun pack(rows: ComplexRows, p: Int, q: Int) {
        for (pair in 0 until planes / 2) {
            val ar = outRe[2 * pair]
            val ai = outIm[2 * pair]
            val br = outRe[2 * pair + 1]
            val bi = outIm[2 * pair + 1]
            rows.re[p + pair] = ar - bi
            rows.im[p + pair] = ai + br
            rows.re[q + pair] = ar + bi
            rows.im[q + pair] = br - ai
        }
    }
}
