package daphnis.core.scenario

import daphnis.core.boundary.Box
import daphnis.core.initial.EqualSizes
import daphnis.core.initial.SeededRandom
import daphnis.core.input.ValueCheck
import kotlin.math.ceil

/** Radii of spheres, and the number of the kind of each. */
internal class Drawn(val radii: DoubleArray, val kinds: IntArray)

/**
 * The radii of a scenario: as many as it says, or as many as give the filling, optical depth or surface density that it
 * says. Spheres that fit into no box are refused before memory is considered, so that the answer is the same on every
 * machine.
 *
 * Of several [kinds] each has its share of the number to within one sphere. Their spheres are in an order that is drawn
 * too, so that they are mixed on a lattice and in the order of ids.
 *
 * @param room volume in which they are, or area in the plane
 * @param areProportions whether spheres will have other radii in these proportions, which need not fit
 */
internal class DrawnRadii(
    private val spec: ParticlesSpec,
    private val kinds: List<SphereKind>,
    private val box: Box,
    private val check: ValueCheck,
    private val areProportions: Boolean,
    private val room: Double = box.volume,
    private val stream: () -> SeededRandom,
) {
    private val space = box.space
    private val isOneSize = kinds.all { it.least == kinds[0].least && it.most == it.least }

    fun draw(): Drawn {
        val amounts = listOf(
            "count" to spec.count,
            "fillingFactor" to spec.fillingFactor,
            "opticalDepth" to spec.opticalDepth,
            "surfaceDensity" to spec.surfaceDensity,
        )
        val given = amounts.filter { it.second != null }.map { it.first }
        spec.materials?.mapNotNull { it.count }?.takeIf { it.isNotEmpty() }?.let { counts ->
            check.must("particles", given.isEmpty()) {
                "needs none of count, fillingFactor, opticalDepth and surfaceDensity, since its materials have counts"
            }
            return counted("particles.materials", counts)
        }
        check.must("particles", given.size == 1) {
            val has = if (given.isEmpty()) "none" else given.joinToString(" and ")
            "needs exactly one of count, fillingFactor, opticalDepth and surfaceDensity; it has $has"
        }
        spec.count?.let { count ->
            check.that("particles.count", count, count in 1..MOST_PARTICLES) { "must be in 1..$MOST_PARTICLES" }
            return counted("particles.count", shared(count))
        }
        val area = box.length(0) * box.length(1)
        spec.opticalDepth?.let { depth ->
            check.positive("particles.opticalDepth", depth)
            return filled(depth * area, "particles.opticalDepth", depth) { _, r -> Math.PI * r * r }
        }
        spec.surfaceDensity?.let { density ->
            check.positive("particles.surfaceDensity", density)
            for (kind in kinds) kind.checkMass()
            return filled(density * area, "particles.surfaceDensity", density) { kind, r -> kind.weight(r) }
        }
        val filling = spec.fillingFactor!!
        check.that("particles.fillingFactor", filling, filling > 0 && filling < space.closestPacking) {
            "must be in (0, ${space.closestPacking}), the closest packing"
        }
        return filled(filling * room, "particles.fillingFactor", filling) { _, r -> space.volume(r) }
    }

    /** How many of [count] spheres are of each kind: what rounding down leaves goes to those of the largest rests. */
    private fun shared(count: Int): List<Int> {
        val exact = kinds.map { it.share * count }
        val counts = exact.map { it.toInt() }.toMutableList()
        val byRest = kinds.indices.sortedByDescending { exact[it] - counts[it] }
        for (k in 0 until count - counts.sum()) counts[byRest[k % kinds.size]]++
        return counts
    }

    /** @param counts by kind */
    private fun counted(key: String, counts: List<Int>): Drawn {
        val sum = counts.sumOf { it.toLong() }
        check.that(key, sum, sum <= MOST_PARTICLES) { "must be in 1..$MOST_PARTICLES" }
        val count = sum.toInt()
        checkFilling(key, count, kinds.indices.sumOf { counts[it] * space.volume(kinds[it].least) }, "at least ")
        if (!isRoomFor(count.toDouble())) {
            val random = stream()
            var all = 0.0
            for ((k, kind) in kinds.withIndex()) {
                val sample = minOf(counts[k], SAMPLE / kinds.size)
                var volume = 0.0
                for (n in 0 until sample) volume += space.volume(kind.sizes.draw(random))
                if (sample > 0) all += volume / sample * counts[k]
            }
            checkFilling(key, count, all, "about ")
        }
        checkMemory(key, count.toDouble())
        val random = stream()
        val radii = kinds.indices.map { kinds[it].sizes.radii(counts[it], random) }
        val all = radii.singleOrNull() ?: DoubleArray(count).also { all ->
            radii.fold(0) { at, its -> at + its.size.also { _ -> its.copyInto(all, at) } }
        }
        checkFilling(key, count, all.sumOf { space.volume(it) })
        val of = IntArray(count)
        counts.foldIndexed(0) { k, at, its -> (at + its).also { of.fill(k, at, it) } }
        return mixed(all, of, random)
    }

    /** As many spheres as bring the sum of [measure] closest to [wanted], in the order in which they are drawn. */
    private fun filled(
        wanted: Double,
        key: String,
        value: Double,
        measure: (kind: SphereKind, radius: Double) -> Double,
    ): Drawn {
        val only = kinds.singleOrNull()?.sizes
        if (only is EqualSizes) {
            val count = Math.rint(wanted / measure(kinds[0], only.radius))
            check.that(key, value, count >= 1) { "is less than one sphere in this box" }
            checkFilling(key, value, count * space.volume(only.radius))
            checkCount(key, value, count)
            checkMemory(key, count)
            return Drawn(DoubleArray(count.toInt()) { only.radius }, IntArray(count.toInt()))
        }
        // Volume per measure grows with the radius, or is the same for all.
        val least = kinds.minOf { space.volume(it.least) / measure(it, it.least) }
        checkFilling(key, value, wanted * least, "at least ")
        checkCount(key, value, wanted / kinds.maxOf { measure(it, it.most) })
        val random = stream()
        var radii = DoubleArray(FEW)
        val taken = IntArray(kinds.size)
        var count = 0
        var sum = 0.0
        var volume = 0.0
        while (true) {
            val kind = next(taken, count)
            val r = kinds[kind].sizes.draw(random)
            val its = measure(kinds[kind], r)
            if (sum + its / 2 > wanted) break
            if (count == SAMPLE) foresee(key, value, count, volume, sum / wanted, margin = 2.0)
            if (count == radii.size) {
                if (!isRoomFor(2.0 * count)) foresee(key, value, count, volume, sum / wanted, margin = 1.0)
                checkMemory(key, 2.0 * count)
                radii = radii.copyOf(2 * count)
            }
            radii[count++] = r
            taken[kind]++
            sum += its
            volume += space.volume(r)
            if (volume >= space.closestPacking * room) checkFilling(key, value, volume, "at least ")
        }
        check.that(key, value, count >= 1) { "is less than one sphere in this box" }
        taken.fill(0)
        val of = IntArray(count) { k -> next(taken, k).also { taken[it]++ } }
        return mixed(radii.copyOf(count), of, random)
    }

    /** The kind that is farthest behind its share, of which so many have been [taken], in all [count]. */
    private fun next(taken: IntArray, count: Int): Int {
        var next = 0
        for (k in 1 until taken.size) {
            val lead = kinds[k].share * (count + 1) - taken[k]
            if (lead > kinds[next].share * (count + 1) - taken[next]) next = k
        }
        return next
    }

    /** The same spheres in any order, each as likely as all others. Of one kind they are in one already. */
    private fun mixed(radii: DoubleArray, of: IntArray, random: SeededRandom): Drawn {
        if (kinds.size > 1) {
            for (k in radii.size - 1 downTo 1) {
                val other = random.nextInt(k + 1)
                radii[k] = radii[other].also { radii[other] = radii[k] }
                of[k] = of[other].also { of[other] = of[k] }
            }
        }
        return Drawn(radii, of)
    }

    /**
     * Refuses a total that is too large by a factor of [margin] when it is extrapolated from the [part] drawn so far.
     */
    private fun foresee(key: String, value: Double, count: Int, volume: Double, part: Double, margin: Double) {
        if (volume / part >=
            margin * space.closestPacking * room
        ) {
            checkFilling(key, value, volume / part, "about ")
        }
        if (count / part > margin * MOST_PARTICLES) checkCount(key, value, count / part)
    }

    private fun checkFilling(key: String, value: Number, volume: Double, bound: String = "") {
        if (areProportions) return
        val filling = volume / room
        val name = if (space.isPlane) "an area fraction" else "a filling factor"
        check.that(key, value, filling < space.closestPacking) {
            "gives $name of ${if (isOneSize) "" else bound}$filling; it must be below ${space.closestPacking}"
        }
    }

    private fun checkCount(key: String, value: Double, count: Double) {
        check.that(key, value, count <= MOST_PARTICLES) { "gives $count spheres; there can be $MOST_PARTICLES" }
    }

    private fun needed(count: Double) = count * ScenarioSetup.BYTES_PER_SPHERE

    private fun isRoomFor(count: Double): Boolean = needed(count) < Runtime.getRuntime().maxMemory()

    private fun checkMemory(key: String, count: Double) {
        val heap = Runtime.getRuntime().maxMemory()
        val mebibytes = ceil(needed(count) / (1 shl 20)).toLong()
        check.that(key, count.toLong(), isRoomFor(count)) {
            "spheres need about $mebibytes MiB, the JVM has ${heap shr 20} MiB; raise it with -Xmx"
        }
    }

    private companion object {
        const val MOST_PARTICLES = 200_000_000
        const val FEW = 1024

        /** Number of radii from which the rest is extrapolated when drawing all would take long. */
        const val SAMPLE = 1 shl 20
    }
}
