package daphnis.core.scenario

import daphnis.core.boundary.Box
import daphnis.core.format.SnapshotCheck
import daphnis.core.initial.EqualSizes
import daphnis.core.initial.ListedSizes
import daphnis.core.initial.LogNormalSizes
import daphnis.core.initial.PowerLawSizes
import daphnis.core.initial.SeededRandom
import daphnis.core.initial.SizeDistribution
import daphnis.core.initial.fillingFactor
import kotlin.math.ceil

/**
 * The radii of a scenario: as many as it says, or as many as give the filling, optical depth or surface density that it
 * says. Spheres that fit into no box are refused before memory is considered, so that the answer is the same on every
 * machine.
 */
internal class DrawnRadii(
    private val spec: ParticlesSpec,
    private val box: Box,
    private val check: ValueCheck,
    private val stream: () -> SeededRandom,
) {
    private val sizes = sizes(spec.sizes)
    private val least: Double
    private val most: Double

    init {
        val (least, most) = when (val s = spec.sizes) {
            is SizesSpec.Equal -> s.radius to s.radius
            is SizesSpec.PowerLaw -> s.minimum to s.maximum
            is SizesSpec.LogNormal -> s.minimum to s.maximum
            is SizesSpec.Listed -> s.radii.min() to s.radii.max()
        }
        for (r in listOf(least, most)) {
            check.must("particles.sizes", r in SnapshotCheck.LEAST..SnapshotCheck.MOST) {
                "a radius is $r; it must be > 0, ${SnapshotCheck.LEAST} to ${SnapshotCheck.MOST}"
            }
        }
        this.least = least
        this.most = most
    }

    fun draw(): DoubleArray {
        val given = listOfNotNull(spec.count, spec.fillingFactor, spec.opticalDepth, spec.surfaceDensity).size
        check.must("particles", given == 1) {
            "needs exactly one of count, fillingFactor, opticalDepth and surfaceDensity"
        }
        spec.count?.let { return counted(it) }
        val area = box.length(0) * box.length(1)
        spec.opticalDepth?.let { depth ->
            check.positive("particles.opticalDepth", depth)
            return filled(depth * area, "particles.opticalDepth", depth) { Math.PI * it * it }
        }
        spec.surfaceDensity?.let { density ->
            check.positive("particles.surfaceDensity", density)
            check.positive("particles.density", spec.density)
            spec.mass?.let { check.positive("particles.mass", it) }
            return filled(density * area, "particles.surfaceDensity", density) {
                spec.mass ?: (spec.density * volume(it))
            }
        }
        val filling = spec.fillingFactor!!
        check.that("particles.fillingFactor", filling, filling > 0 && filling < CLOSEST_PACKING) {
            "must be in (0, $CLOSEST_PACKING), the closest packing"
        }
        return filled(filling * box.volume, "particles.fillingFactor", filling) { volume(it) }
    }

    private fun counted(count: Int): DoubleArray {
        val key = "particles.count"
        check.that(key, count, count in 1..MOST_PARTICLES) { "must be in 1..$MOST_PARTICLES" }
        checkFilling(key, count, count * volume(least), "at least ")
        if (!isRoomFor(count.toDouble())) {
            val random = stream()
            var volume = 0.0
            val sample = minOf(count, SAMPLE)
            for (k in 0 until sample) volume += volume(sizes.draw(random))
            checkFilling(key, count, volume / sample * count, "about ")
        }
        checkMemory(key, count.toDouble())
        val radii = sizes.radii(count, stream())
        checkFilling(key, count, fillingFactor(radii, box) * box.volume)
        return radii
    }

    /** As many spheres as bring the sum of [measure] closest to [wanted], in the order in which they are drawn. */
    private fun filled(wanted: Double, key: String, value: Double, measure: (Double) -> Double): DoubleArray {
        if (sizes is EqualSizes) {
            val count = Math.rint(wanted / measure(sizes.radius))
            check.that(key, value, count >= 1) { "is less than one sphere in this box" }
            checkFilling(key, value, count * volume(sizes.radius))
            checkCount(key, value, count)
            checkMemory(key, count)
            return DoubleArray(count.toInt()) { sizes.radius }
        }
        // Volume per measure grows with the radius, or is the same for all.
        checkFilling(key, value, wanted * volume(least) / measure(least), "at least ")
        checkCount(key, value, wanted / measure(most))
        val random = stream()
        var radii = DoubleArray(FEW)
        var count = 0
        var sum = 0.0
        var volume = 0.0
        while (true) {
            val r = sizes.draw(random)
            if (sum + measure(r) / 2 > wanted) break
            if (count == SAMPLE) foresee(key, value, count, volume, sum / wanted, margin = 2.0)
            if (count == radii.size) {
                if (!isRoomFor(2.0 * count)) foresee(key, value, count, volume, sum / wanted, margin = 1.0)
                checkMemory(key, 2.0 * count)
                radii = radii.copyOf(2 * count)
            }
            radii[count++] = r
            sum += measure(r)
            volume += volume(r)
            if (volume >= CLOSEST_PACKING * box.volume) checkFilling(key, value, volume, "at least ")
        }
        check.that(key, value, count >= 1) { "is less than one sphere in this box" }
        return radii.copyOf(count)
    }

    /**
     * Refuses a total that is too large by a factor of [margin] when it is extrapolated from the [part] drawn so far.
     */
    private fun foresee(key: String, value: Double, count: Int, volume: Double, part: Double, margin: Double) {
        if (volume / part >= margin * CLOSEST_PACKING * box.volume) checkFilling(key, value, volume / part, "about ")
        if (count / part > margin * MOST_PARTICLES) checkCount(key, value, count / part)
    }

    private fun sizes(spec: SizesSpec): SizeDistribution = try {
        when (spec) {
            is SizesSpec.Equal -> EqualSizes(spec.radius)
            is SizesSpec.PowerLaw -> PowerLawSizes(spec.minimum, spec.maximum, spec.exponent)
            is SizesSpec.LogNormal -> LogNormalSizes(spec.median, spec.sigma, spec.minimum, spec.maximum)
            is SizesSpec.Listed -> ListedSizes(spec.radii.toDoubleArray())
        }
    } catch (e: IllegalArgumentException) {
        check.fail("particles.sizes", e.message.orEmpty())
    }

    private fun checkFilling(key: String, value: Number, volume: Double, bound: String = "") {
        val filling = volume / box.volume
        check.that(key, value, filling < CLOSEST_PACKING) {
            "gives a filling factor of ${if (least == most) "" else bound}$filling; it must be below $CLOSEST_PACKING"
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

    private fun volume(radius: Double) = 4.0 / 3.0 * Math.PI * radius * radius * radius

    private companion object {
        const val CLOSEST_PACKING = 0.7405
        const val MOST_PARTICLES = 200_000_000
        const val FEW = 1024

        /** Number of radii from which the rest is extrapolated when drawing all would take long. */
        const val SAMPLE = 1 shl 20
    }
}
