package daphnis.analysis.occultation

import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.exp
import kotlin.math.sin
import kotlin.math.sqrt
import kotlin.math.tan

/** How a wake is cut across. */
public enum class WakeSection {
    /** Hedman et al. 2007, AJ 133, 2624. */
    ELLIPSE,

    /** Colwell, Esposito & Sremčević 2006, GRL 33, L07201. */
    RECTANGLE,
}

/**
 * Self-gravity wakes as opaque, straight, equal bars at equal distances, with a haze in the gaps between them. What
 * comes through along the elevation B and the azimuth A is (1 − w f) exp(−τ_G/sin B), or nothing where w f > 1. Here
 * w = 1/(1 + S/W) is the share of the bars, of the width W with gaps S between them, and with c = H/W cot B
 * |cos(A − φ)|, for rays whose direction lies at A − φ from that across the bars, f is (1 + c²)^½ for elliptic bars and
 * 1 + c for rectangular ones.
 *
 * @property gapDepth τ_G, normal optical depth of the haze in the gaps
 * @property barShare w
 * @property heightOverWidth H/W of the bars
 * @property pitch φ, angle in radians between the orbit (y) and the bars, trailing positive, as that of
 *   [daphnis.analysis.correlation.WavePattern]; the angle of the bars from the radial direction is 90° less this
 */
public class WakeModel @JvmOverloads constructor(
    public val gapDepth: Double,
    public val barShare: Double,
    public val heightOverWidth: Double,
    public val pitch: Double,
    public val section: WakeSection = WakeSection.ELLIPSE,
) {
    /** S/W, the width of the gaps over that of the bars. */
    public val gapOverWidth: Double get() = 1 / barShare - 1

    /** Share of the light that comes through along [line]. */
    public fun transmission(line: LineOfSight): Double {
        val light = DoubleArray(1)
        WakeRays(listOf(line)).light(this, light)
        return light[0]
    }
}

/** What all models have in common along [lines], worked out once. */
internal class WakeRays(private val lines: List<LineOfSight>) {
    private val cotangent = DoubleArray(lines.size) {
        if (lines[it].elevation == PI / 2) 0.0 else 1 / tan(lines[it].elevation)
    }
    private val slant = DoubleArray(lines.size) { 1 / sin(lines[it].elevation) }
    private val towardX = DoubleArray(lines.size) { cos(lines[it].azimuth) }
    private val towardY = DoubleArray(lines.size) { sin(lines[it].azimuth) }

    /** Writes what [model] lets through along each line into [light]. */
    fun light(model: WakeModel, light: DoubleArray) {
        val (acrossX, acrossY) = cos(model.pitch) to sin(model.pitch)
        var before = Double.NaN
        var haze = 0.0
        for (k in lines.indices) {
            // Lines of one elevation follow one another.
            if (slant[k] != before) haze = exp(-model.gapDepth * slant[k])
            before = slant[k]
            val aside = model.heightOverWidth * cotangent[k] * abs(towardX[k] * acrossX + towardY[k] * acrossY)
            val wider = if (model.section == WakeSection.ELLIPSE) sqrt(1 + aside * aside) else 1 + aside
            light[k] = maxOf(0.0, 1 - model.barShare * wider) * haze
        }
    }
}
