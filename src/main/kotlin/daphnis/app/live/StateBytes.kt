package daphnis.app.live

import daphnis.analysis.insitu.State
import daphnis.analysis.plot.PlotScale
import daphnis.analysis.table.UnitNames
import daphnis.app.describe.spheres
import daphnis.core.boundary.ImageShear
import daphnis.core.space.Space
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.Locale
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * States as the page draws them. The length of the head in bytes, an int; the head, JSON; columns of floats with x, y,
 * z from the head's `origin` and the radius, all in units of length, the speed against the mean flow in units of [scale],
 * and the mass; a column of bytes with the numbers of materials, modulo 256. The lowest byte of a number comes first.
 * Bodies, of which the head says how many, come before particles.
 *
 * @param most particles that are shown; of more, those whose ids a whole number divides, so that they are the same in
 *   every state while there are as many
 */
internal class StateBytes(private val scale: PlotScale, private val most: Int = MOST) {
    /** [state] within [walls], with its [number] in the run. Any thread may call; the state must not change meanwhile. */
    fun of(state: State, walls: SeenWalls, number: Long): ByteArray {
        val p = state.population
        val shown = shown(state)
        val bodies = shown.indexOfFirst { state.isParticle(it) }.let { if (it < 0) shown.size else it }
        val spans = List(AXES) { span(state, walls, it, shown) }
        val origin = DoubleArray(AXES) { spans[it].middle }
        val head = head(state, walls, number, shown.size, bodies, spans).toByteArray()
        val buffer = ByteBuffer.allocate(Int.SIZE_BYTES + head.size + shown.size * BYTES_A_SPHERE)
        buffer.order(ByteOrder.LITTLE_ENDIAN).putInt(head.size).put(head)
        for (axis in 0 until AXES) {
            val place = p.position(axis)
            for (k in shown) buffer.putFloat((place[k] - origin[axis]).toFloat())
        }
        for (k in shown) buffer.putFloat(p.radius[k].toFloat())
        for (k in shown) buffer.putFloat((speed(state, k) / scale.speed).toFloat())
        for (k in shown) buffer.putFloat(p.mass[k].toFloat())
        for (k in shown) buffer.put(if (p.hasMaterials) p.material[k].toInt().toByte() else 0)
        return buffer.array()
    }

    private fun speed(state: State, k: Int): Double {
        val x = state.againstFlow(k, 0)
        val y = state.againstFlow(k, 1)
        val z = state.againstFlow(k, 2)
        return sqrt(x * x + y * y + z * z)
    }

    /** Indices: all bodies, then particles. */
    private fun shown(state: State): IntArray {
        val p = state.population
        val stride = stride(state)
        val indices = IntArray(p.size)
        var count = 0
        for (k in 0 until p.size) if (!state.isParticle(k)) indices[count++] = k
        for (k in 0 until p.size) {
            if (state.isParticle(k) &&
                (stride == 1 || p.id[k] % stride == 0)
            ) {
                indices[count++] = k
            }
        }
        return indices.copyOf(count)
    }

    private fun stride(state: State) = maxOf(1, (state.population.size + most - 1) / most)

    /** What there is to see along an axis. @property isClosed whether the box or a wall ends there */
    private class Span(val low: Double, val high: Double, val isClosed: Boolean) {
        val middle get() = low + (high - low) / 2
    }

    /** The room, or where it is open all spheres but the outermost in a thousand at each end. */
    private fun span(state: State, walls: SeenWalls, axis: Int, shown: IntArray): Span {
        if (axis == 2 && state.dimensions == 2) return Span(0.0, 0.0, false)
        walls.extent(axis)?.let { return Span(it.start, it.endInclusive, true) }
        if (shown.isEmpty()) return Span(-1.0, 1.0, false)
        val p = state.population
        val stride = shown.size / MOST_LOOKED_AT + 1
        val places = DoubleArray((shown.size + stride - 1) / stride) { p.position(axis)[shown[it * stride]] }
        places.sort()
        val rare = (places.size * RARE).toInt()
        val margin = shown.maxOf { p.radius[it] }
        return Span(places[rare] - margin, places[places.size - 1 - rare] + margin, false)
    }

    private fun head(
        state: State,
        walls: SeenWalls,
        number: Long,
        count: Int,
        bodies: Int,
        spans: List<Span>,
    ): String {
        fun numbers(of: (Span) -> Double) = JsonArray(spans.map { JsonPrimitive(of(it)) })
        val tree = buildJsonObject {
            put("number", JsonPrimitive(number))
            put("time", JsonPrimitive(timeText(state.time)))
            put("timeNumber", JsonPrimitive(state.time / scale.time))
            put("about", JsonPrimitive(about(state, walls, count, spans)))
            put("count", JsonPrimitive(count))
            put("bodies", JsonPrimitive(bodies))
            put("dimensions", JsonPrimitive(state.dimensions))
            put("origin", numbers { it.middle })
            put("halves", numbers { (it.high - it.low) / 2 })
            put("lines", JsonArray(lines(walls, spans)))
            put("flow", JsonPrimitive(flow(state)))
            put("every", JsonPrimitive(stride(state)))
            put("repeats", JsonArray(List(AXES - 1) { JsonPrimitive(state.boundary.repeats(it)) }))
            put("shear", state.boundary.shear?.let { shear(it, state.time) } ?: JsonNull)
            put("materials", JsonArray(state.population.materials.map { JsonPrimitive(it) }))
            put(
                "units",
                buildJsonObject {
                    put("length", JsonPrimitive(UnitNames.raised(scale.units.length)))
                    put("speed", JsonPrimitive(UnitNames.raised(scale.speedName)))
                    put("surfaceDensity", JsonPrimitive(UnitNames.raised(scale.units.surfaceDensity)))
                },
            )
        }
        val text = tree.toString()
        // Columns of floats begin at a multiple of their size.
        return text + " ".repeat((ALIGNED - text.toByteArray().size % ALIGNED) % ALIGNED)
    }

    /** The image one box further along `normal` is displaced by `offset` along `slide`. */
    private fun shear(shear: ImageShear, time: Double) = buildJsonObject {
        put("normal", JsonPrimitive(shear.normalAxis))
        put("slide", JsonPrimitive(shear.slideAxis))
        put("offset", JsonPrimitive(shear.offset(time)))
    }

    /** Places from the middle, three numbers each, of pieces of straight lines with two ends. */
    private fun lines(walls: SeenWalls, spans: List<Span>): List<JsonElement> {
        val low = DoubleArray(AXES) { spans[it].low }
        val high = DoubleArray(AXES) { spans[it].high }
        return WallLines(walls, low, high).pieces().flatMap { end ->
            List(AXES) { JsonPrimitive((end[it] - spans[it].middle).toFloat()) }
        }
    }

    private fun timeText(time: Double): String =
        "t = " + UnitNames.amount(short(time / scale.time), UnitNames.raised(scale.timeName))

    private fun about(state: State, walls: SeenWalls, count: Int, spans: List<Span>): String {
        val size = state.population.size
        val all = spheres(size, Space.of(state.dimensions))
        val edges = spans.take(state.dimensions).joinToString(" × ") {
            if (it.isClosed) short(it.high - it.low) else "open"
        }
        val length = UnitNames.raised(scale.units.length)
        val unit = if (spans.any { it.isClosed }) " $length" else ""
        val isBox = (0 until state.dimensions).all { walls.isFace(it) || walls.extent(it) == null }
        val named = walls.inWords { UnitNames.amount(short(it), length) }
        return listOfNotNull(
            if (count < size) "$count of $all" else all,
            (if (isBox) "box" else "room") + " $edges$unit",
            named.joinToString(", ").ifEmpty { null },
            flow(state)?.let { "speeds are against the mean flow $it" },
        ).joinToString(" · ")
    }

    /** The mean flow that is taken out of speeds; null where there is none. */
    private fun flow(state: State): String? = state.boundary.meanFlow?.let {
        val across = "xyz"[it.normalAxis]
        val spread = if (abs(it.spread) <= ROUNDING * abs(it.rate)) "" else "v_$across = ${short(it.spread)} $across, "
        "${spread}v_${"xyz"[it.flowAxis]} = ${short(
            it.rate,
        )} $across (${if (spread.isEmpty()) "rate" else "rates"} in " +
            "${scale.units.rate})"
    }

    /** To four digits; a length of five is no power of ten yet. */
    private fun short(number: Double): String =
        String.format(Locale.ROOT, if (abs(number) in LEAST_WHOLE..MOST_WHOLE) "%.0f" else "%.4g", number)

    companion object {
        /** 50 MB; what a browser draws as points. */
        const val MOST = 2_000_000
        private const val AXES = 3
        private const val LEAST_WHOLE = 9999.5
        private const val MOST_WHOLE = 1e7
        private const val ROUNDING = 1e-12
        private const val ALIGNED = 4
        private const val BYTES_A_SPHERE = 6 * Float.SIZE_BYTES + 1
        private const val RARE = 1e-3
        private const val MOST_LOOKED_AT = 50_000
    }
}
