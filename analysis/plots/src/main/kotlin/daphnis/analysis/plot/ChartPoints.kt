package daphnis.analysis.plot

/** The points of [curve] without those that are not finite or that a logarithmic axis cannot show. */
internal class ChartPoints(curve: Curve, logX: Boolean, logY: Boolean) {
    val x = ArrayList<Double>()
    val y = ArrayList<Double>()

    /** Where the bar at a point begins; the point itself where it has none. [high] is where it ends. */
    val low = ArrayList<Double>()
    val high = ArrayList<Double>()

    init {
        for (k in curve.x.indices) {
            if (!curve.y[k].isFinite() || !curve.x[k].isFinite()) continue
            if (logY && curve.y[k] <= 0 || logX && curve.x[k] <= 0) continue
            val e = curve.error?.get(k)?.takeIf { it.isFinite() } ?: 0.0
            x += curve.x[k]
            y += curve.y[k]
            low += if (logY && curve.y[k] - e <= 0) curve.y[k] else curve.y[k] - e
            high += curve.y[k] + e
        }
    }
}
