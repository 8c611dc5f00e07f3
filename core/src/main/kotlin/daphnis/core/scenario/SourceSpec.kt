package daphnis.core.scenario

import daphnis.core.initial.SizesSpec
import daphnis.core.input.Described
import daphnis.core.input.Quantities
import daphnis.core.input.ValueCheck
import daphnis.core.source.Inflow
import daphnis.core.source.Outflow
import daphnis.core.source.Reservoir
import daphnis.core.source.Source
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlin.math.sqrt

/** Where spheres come or leave, as a scenario describes it; `toString` is the name. */
@Serializable
public sealed interface SourceSpec {
    /** Whether spheres leave here. */
    public val takes: Boolean get() = true

    /** Whether spheres come here. */
    public val brings: Boolean get() = true

    /** The same with what it brings as spheres of [particles], where it does not say what these are. */
    public fun settled(particles: ParticlesSpec?): SourceSpec = this

    /** The source at [place], with its values checked. @throws daphnis.core.input.InputException for what is wrong */
    public fun source(place: SourcePlace): Source

    /** Checks that it can act in steps of [duration]; [key] is its own. */
    public fun checkStep(key: String, duration: Double, check: ValueCheck): Unit = Unit

    /** A description for a reader, with its numbers. */
    public fun inWords(say: Quantities): String

    /** See [Outflow]. */
    @Serializable
    @SerialName("outflow")
    @Described("takes away the spheres whose centres are in its region")
    public class OutflowSpec @JvmOverloads constructor(
        @Described("where; default all of the box, or of space where it is open")
        public val region: RegionSpec = RegionSpec(),
    ) : SourceSpec {
        override val brings: Boolean get() = false

        override fun source(place: SourcePlace): Source = Outflow(place.box(region, brings = false))

        override fun toString(): String = "outflow"

        override fun inWords(say: Quantities): String = "outflow${region.inWords(say)}"
    }

    /**
     * See [Inflow].
     *
     * @property sigma standard deviation of each component of the velocity
     * @property through name of the face through which they come; null where they come in the whole region
     */
    @Serializable
    @SerialName("inflow")
    @Described("brings spheres at random times")
    public class InflowSpec @JvmOverloads constructor(
        @Described("spheres per unit of time on average, > 0")
        public val rate: Double,
        @Described("where they come; default all of the box")
        public val region: RegionSpec = RegionSpec(),
        @Described("mean velocity; default [0, 0, 0]")
        public val velocity: List<Double> = listOf(0.0, 0.0, 0.0),
        @Described("standard deviation of each component around it; default 0")
        public val sigma: Double = 0.0,
        @Described(
            "a face, `lowerX` to `upperZ`: spheres come through it at any time within the step, as a gas beyond " +
                "it sends them; default none: they come in the whole region",
        )
        public val through: String? = null,
        @Described("what comes; default as the scenario's particles")
        public val particles: SupplySpec = SupplySpec(),
    ) : SourceSpec {
        override val takes: Boolean get() = false

        override fun settled(particles: ParticlesSpec?): InflowSpec =
            InflowSpec(rate, region, velocity, sigma, through, this.particles.settled(particles))

        override fun source(place: SourcePlace): Source {
            val check = place.check
            val key = place.key
            place.requireRoomToCome()
            check.positive("$key.rate", rate)
            val expected = rate * place.duration
            check.that("$key.rate", rate, expected <= MOST) {
                "brings $expected spheres to the end of the run, and there are ids for ${Int.MAX_VALUE}"
            }
            check.that("$key.velocity", velocity, velocity.size == 3) { "must be three numbers" }
            velocity.forEachIndexed { k, v -> check.speed("$key.velocity[$k]", v) }
            check.inSpace("$key.velocity", velocity, place.space)
            check.that("$key.sigma", sigma, sigma in 0.0..MOST_SIGMA) { "must be at least 0, and $MOST_SIGMA at most" }
            val face = through?.let { place.face(it, velocity, sigma, region) } ?: -1
            return Inflow(place.box(region, brings = true), rate, velocity, sigma, place.supply(particles), face)
        }

        override fun checkStep(key: String, duration: Double, check: ValueCheck) {
            check.that("$key.rate", rate, rate * duration <= Inflow.MOST_AT_ONCE) {
                "brings ${rate * duration} spheres in a step of $duration; ${Inflow.MOST_AT_ONCE} are possible"
            }
        }

        override fun toString(): String = "inflow"

        override fun inWords(say: Quantities): String {
            val stream = if (velocity.any { it != 0.0 }) {
                " at (${velocity.joinToString(" ") { say.speed(it) }})"
            } else {
                ""
            }
            val spread = if (sigma == 0.0) "" else ", velocity dispersion ${say.speed(sigma)}"
            return "inflow of ${say.rate(rate)}${through?.let { " through $it" }.orEmpty()}${region.inWords(say)}" +
                stream + spread
        }

        private companion object {
            /** Of the ids, with room for what is by chance more than expected. */
            const val MOST = 2e9
        }
    }

    /** See [Reservoir]. */
    @Serializable
    @SerialName("reservoir")
    @Described("brings and takes spheres as a large gas of elastic spheres in contact would")
    public class ReservoirSpec @JvmOverloads constructor(
        @Described("of that gas, < 0.49")
        public val fillingFactor: Double,
        @Described("of that gas, > 0, mass · speed²")
        public val temperature: Double,
        @Described("where it is in contact; default all of the box")
        public val region: RegionSpec = RegionSpec(),
        @Described("moves that are tried in a step; default as many as the region is to hold spheres")
        public val trials: Int? = null,
        @Described("what comes, of equal radii; default as the scenario's particles")
        public val particles: SupplySpec = SupplySpec(),
    ) : SourceSpec {
        override fun settled(particles: ParticlesSpec?): ReservoirSpec =
            ReservoirSpec(fillingFactor, temperature, region, trials, this.particles.settled(particles))

        override fun source(place: SourcePlace): Source {
            val check = place.check
            val key = place.key
            place.requireRoomToCome()
            place.requireGas()
            val filling = fillingFactor
            check.that("$key.fillingFactor", filling, filling > 0 && filling < Reservoir.MOST_FILLING) {
                "must be in (0, ${Reservoir.MOST_FILLING}), that of a fluid"
            }
            check.positive("$key.temperature", temperature)
            val speed = particles.mass?.let { sqrt(temperature / it) } ?: 0.0
            check.that("$key.temperature", temperature, speed <= MOST_SIGMA) {
                "makes speeds of $speed; $MOST_SIGMA is possible"
            }
            trials?.let { check.that("$key.trials", it, it in 1..MOST_TRIALS) { "must be in 1..$MOST_TRIALS" } }
            val supply = place.supply(particles)
            check.must("$key.particles.sizes", particles.sizes?.radius != null) {
                "must be those of equal spheres, whose chemical potential is known"
            }
            return Reservoir(place.box(region, brings = true), filling, temperature, supply, trials ?: 0).also {
                check.that("$key.fillingFactor", filling, it.expected <= MOST_TRIALS) {
                    "makes ${it.expected} spheres in the region; $MOST_TRIALS are possible"
                }
            }
        }

        override fun toString(): String = "reservoir"

        override fun inWords(say: Quantities): String =
            "reservoir${region.inWords(say)} with a filling factor of ${Quantities.number(fillingFactor)} at a " +
                "temperature of ${say.energy(temperature)}" + trials?.let { ", $it trials per step" }.orEmpty()

        private companion object {
            const val MOST_TRIALS = 10_000_000
        }
    }
}

/**
 * What spheres are like that come. What is left out is as that of the scenario's particles, or of the [material] among
 * them.
 *
 * @property density mass per volume, unless [mass] is given
 * @property material name of one of the materials of the scenario; the first where it has any and none is named
 */
@Serializable
public class SupplySpec @JvmOverloads constructor(
    @Described("distribution of radii, drawn; default those of the scenario's particles")
    public val sizes: SizesSpec? = null,
    @Described("mass per volume; default that of the scenario's particles")
    public val density: Double? = null,
    @Described("in place of `density`; default that of the scenario's particles")
    public val mass: Double? = null,
    @Described("one of the scenario's; default the first, where there are any")
    public val material: String? = null,
) {
    /** The same with all that is left out. */
    internal fun settled(particles: ParticlesSpec?): SupplySpec {
        val like = particles?.materials?.let { all -> all.find { it.name == material } ?: all[0] }
        val isSaid = density != null || mass != null
        return SupplySpec(
            sizes ?: if (like == null) particles?.sizes else like.sizes,
            density ?: if (isSaid) {
                null
            } else if (like == null) {
                particles?.density
            } else {
                like.density
            },
            mass ?: if (isSaid) {
                null
            } else if (like == null) {
                particles?.mass
            } else {
                like.mass
            },
            material,
        )
    }
}

/** A part of space: from where to where along each axis; along what is left out, all of it. */
@Serializable
public class RegionSpec @JvmOverloads constructor(
    @Described("[from, to]; default all of the box, or of space where it is open")
    public val x: List<Double>? = null,
    @Described("[from, to]; default all of the box, or of space where it is open")
    public val y: List<Double>? = null,
    @Described("[from, to]; default all of the box, or of space where it is open")
    public val z: List<Double>? = null,
) {
    /** By axis. */
    internal val ranges: List<List<Double>?> get() = listOf(x, y, z)

    internal fun inWords(say: Quantities): String {
        val told = ranges.mapIndexedNotNull { axis, range ->
            range?.let { "${"xyz"[axis]} from ${say.length(it[0])} to ${say.length(it[1])}" }
        }
        return if (told.isEmpty()) "" else told.joinToString(", ", " in ")
    }
}

/** The greatest standard deviation of a velocity, of which none that is drawn is ten times as large. */
private const val MOST_SIGMA = ValueCheck.MOST / 10
