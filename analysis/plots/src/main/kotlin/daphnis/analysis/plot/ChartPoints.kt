package daphnis.analysis.plot

/** The points of [curves] without those that are not finite or that a logarithmic axis cannot show. */
internal class ChartPoints(curves: List<Curve>, logX: Boolean, logY: Boolean) {
    val x = ArrayList<Double>()
    val y = ArrayList<Double>()
    val low = ArrayList<Double>()
    val high = ArrayList<Double>()
    private val name = ArrayList<String>()

    init {
        for (curve in curves) {
            for (k in curve.x.indices) {
                if (!curve.y[k].isFinite() || logY && curve.y[k] <= 0 || logX && curve.x[k] <= 0) continue
                val e = curve.error?.get(k)?.takeIf { it.isFinite() } ?: 0.0
                x += curve.x[k]
                y += curve.y[k]
                low += if (logY && curve.y[k] - e <= 0) curve.y[k] else curve.y[k] - e
                high += curve.y[k] + e
                name += curve.name
            }
        }
    }

    /** As columns for lets-plot. */
    val columns: Map<String, List<Any>> get() = mapOf(
        "x" to x,
        "y" to y,
        "low" to low,
        "high" to high,
        "curve" to name,
    )
}
