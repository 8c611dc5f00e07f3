package daphnis.core.force.mesh

/** What one thread needs to transform and to multiply planes. */
internal class MeshWorker(private val planes: Int) {
    val a = ComplexRows()
    val b = ComplexRows()

    /** By planes apart. */
    val kernel = DoubleArray(planes)
    private val re = DoubleArray(planes)
    private val im = DoubleArray(planes)
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

    /** Σ over planes of the kernel times [scale]. */
    fun convolve(scale: Double) {
        for (z in 0 until planes) {
            var sumRe = 0.0
            var sumIm = 0.0
            for (other in 0 until planes) {
                val weight = kernel[Math.abs(z - other)]
                sumRe += weight * re[other]
                sumIm += weight * im[other]
            }
            outRe[z] = scale * sumRe
            outIm[z] = scale * sumIm
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
