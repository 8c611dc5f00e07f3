package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.ShearedPeriodic
import daphnis.core.population.Population
import daphnis.core.setup.EqualSizes
import daphnis.core.setup.Lattice
import daphnis.core.setup.LatticePlacement
import daphnis.core.setup.ListedSizes
import daphnis.core.setup.LogNormalSizes
import daphnis.core.setup.PlacementException
import daphnis.core.setup.PowerLawSizes
import daphnis.core.setup.RandomPlacement
import daphnis.core.setup.SeededRandom
import daphnis.core.setup.SizeDistribution
import daphnis.core.setup.fillingFactor

/** Makes the population that a scenario starts from. Sizes, places and velocities draw from streams of their own, so that changing one leaves the others. */
internal class InitialState(private val scenario: Scenario, private val box: Box, private val boundary: BoundaryConditions, private val check: ValueCheck) {
    /** What a user should know about the state made, a line each. */
    val notices = ArrayList<String>()

    fun population(): Population {
        val placement = scenario.placement
        if (placement is PlacementSpec.File) return FileState(scenario, placement, check).population(notices)
        val spec = scenario.particles ?: check.fail("particles", "is missing; it is needed unless the placement is a file")
        val radii = radii(spec)
        val bodies = Bodies(scenario.bodies, spec.density, check)
        val positions = try {
            if (placement is PlacementSpec.Lattice) {
                check.must("bodies", scenario.bodies.isEmpty()) { "need random placement, which goes around them" }
                LatticePlacement(lattice(placement)).place(radii, box, walled(), stream(PLACES))
            } else {
                RandomPlacement(obstacles = bodies.obstacles, threads = scenario.engine.threadsAtStart).place(radii, box, walled(), stream(PLACES))
            }
        } catch (e: PlacementException) {
            val (key, value) = spec.amount()
            check.fail("particles.$key", "is $value; ${e.message}")
        }
        val masses = masses(spec, radii)
        val velocities = InitialVelocities(scenario, boundary, check).draw(masses, positions, stream(VELOCITIES))
        val flow = boundary.meanFlow
        return Population(
            positions.x + bodies.position(0),
            positions.y + bodies.position(1),
            positions.z + bodies.position(2),
            velocities[0] + bodies.velocity(0, flow),
            velocities[1] + bodies.velocity(1, flow),
            velocities[2] + bodies.velocity(2, flow),
            radii + bodies.radius,
            masses + bodies.mass,
        )
    }

    private fun ParticlesSpec.amount(): Pair<String, Number> = when {
        fillingFactor != null -> "fillingFactor" to fillingFactor
        opticalDepth != null -> "opticalDepth" to opticalDepth
        surfaceDensity != null -> "surfaceDensity" to surfaceDensity
        else -> "count" to (count ?: 0)
    }

    private fun stream(purpose: Long) = SeededRandom(scenario.seed * STREAMS + purpose)

    private fun lattice(spec: PlacementSpec.Lattice) = if (spec.lattice == LatticeName.CUBIC) Lattice.SIMPLE_CUBIC else Lattice.FACE_CENTRED_CUBIC

    /** Where there are no images a sphere is put wholly inside. The paper's sheared box has images to wrap to, though none to touch. */
    private fun walled(): BooleanArray = BooleanArray(3) { boundary !is ShearedPeriodic && boundary.contactFaces(it) != ContactFaces.PERIODIC }

    private fun radii(spec: ParticlesSpec): DoubleArray {
        val given = listOfNotNull(spec.count, spec.fillingFactor, spec.opticalDepth, spec.surfaceDensity).size
        check.must("particles", given == 1) { "needs exactly one of count, fillingFactor, opticalDepth and surfaceDensity" }
        val sizes = sizes(spec.sizes)
        spec.count?.let { count ->
            check.that("particles.count", count, count in 1..MOST_PARTICLES) { "must be in 1..$MOST_PARTICLES" }
            checkMemory("particles.count", count.toDouble())
            val radii = sizes.radii(count, stream(SIZES))
            val filling = fillingFactor(radii, box)
            check.that("particles.count", count, filling < CLOSEST_PACKING) { "gives a filling factor of $filling; it must be below $CLOSEST_PACKING" }
            return radii
        }
        val area = box.length(0) * box.length(1)
        spec.opticalDepth?.let { depth ->
            check.positive("particles.opticalDepth", depth)
            return fill(sizes, depth * area, "particles.opticalDepth", depth) { Math.PI * it * it }
        }
        spec.surfaceDensity?.let { density ->
            check.positive("particles.surfaceDensity", density)
            check.positive("particles.density", spec.density)
            spec.mass?.let { check.positive("particles.mass", it) }
            return fill(sizes, density * area, "particles.surfaceDensity", density) { spec.mass ?: (spec.density * volume(it)) }
        }
        val filling = spec.fillingFactor!!
        check.that("particles.fillingFactor", filling, filling > 0 && filling < CLOSEST_PACKING) { "must be in (0, $CLOSEST_PACKING), the closest packing" }
        return fill(sizes, filling * box.volume, "particles.fillingFactor", filling) { volume(it) }
    }

    /** As many spheres as bring the sum of [measure] closest to [wanted], in the order they are drawn. */
    private fun fill(sizes: SizeDistribution, wanted: Double, key: String, value: Double, measure: (Double) -> Double): DoubleArray {
        if (sizes is EqualSizes) {
            val count = Math.rint(wanted / measure(sizes.radius))
            check.that(key, value, count >= 1) { "is less than one sphere in this box" }
            checkMemory(key, count)
            return DoubleArray(count.toInt()) { sizes.radius }
        }
        val random = stream(SIZES)
        var radii = DoubleArray(1024)
        var count = 0
        var sum = 0.0
        while (true) {
            val r = sizes.draw(random)
            if (sum + measure(r) / 2 > wanted) break
            if (count == radii.size) {
                checkMemory(key, 2.0 * count)
                radii = radii.copyOf(2 * count)
            }
            radii[count++] = r
            sum += measure(r)
        }
        check.that(key, value, count >= 1) { "is less than one sphere in this box" }
        return radii.copyOf(count)
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

    private fun checkMemory(key: String, count: Double) {
        check.that(key, count, count <= MOST_PARTICLES) { "spheres are too many; it must be at most $MOST_PARTICLES" }
        val needed = count * ScenarioSetup.BYTES_PER_SPHERE
        val heap = Runtime.getRuntime().maxMemory()
        check.that(key, count.toLong(), needed < heap) {
            "spheres need about ${"%.1f".format(java.util.Locale.ROOT, needed / (1 shl 30))} GiB, the JVM has ${heap shr 20} MiB; raise it with -Xmx"
        }
    }

    private fun masses(spec: ParticlesSpec, radii: DoubleArray): DoubleArray {
        check.positive("particles.density", spec.density)
        spec.mass?.let { mass ->
            check.positive("particles.mass", mass)
            return DoubleArray(radii.size) { mass }
        }
        for (r in radii) {
            val mass = spec.density * volume(r)
            check.that("particles.density", spec.density, mass > 0 && mass.isFinite()) { "gives a sphere of radius $r the mass $mass" }
        }
        return DoubleArray(radii.size) { spec.density * volume(radii[it]) }
    }

    private fun volume(radius: Double) = 4.0 / 3.0 * Math.PI * radius * radius * radius

    private companion object {
        const val STREAMS = 4L
        const val SIZES = 0L
        const val PLACES = 1L
        const val VELOCITIES = 2L
        const val CLOSEST_PACKING = 0.7405
        const val MOST_PARTICLES = 200_000_000
    }
}
