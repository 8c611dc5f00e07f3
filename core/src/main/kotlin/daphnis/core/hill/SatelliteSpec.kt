package daphnis.core.hill

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.force.Force
import daphnis.core.force.ForcePlace
import daphnis.core.force.ForceSpec
import daphnis.core.force.Pull
import daphnis.core.force.orbitalRate
import daphnis.core.input.Described
import daphnis.core.input.Quantities
import daphnis.core.input.Quantities.Companion.number
import daphnis.core.input.UnitsSpec
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import kotlinx.serialization.EncodeDefault
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlin.math.abs

/**
 * A moon on an epicyclic orbit in Hill's frame. The ring feels its gravity; the moon feels that of the ring if it
 * [feelsRing].
 *
 * @property massRatio mass over that of the planet; exactly one of this and [mass]
 * @property x radial position of its guiding centre
 * @property y azimuthal position of its guiding centre at [epoch]
 * @property e amplitude of its epicycle in units of length: eccentricity times semi-major axis
 * @property phase φ at [epoch] in radians; pericentre at 0
 * @property softening length ε in 1/(r² + ε²)
 * @property radius particles that touch it are removed; 0 for a point
 * @property constant G in the scenario's units, with [mass]; from its units when left out
 * @property inclination amplitude of its vertical swing in units of length: inclination times semi-major axis
 * @property node phase of that swing at [epoch] in radians, from the ascending node
 * @property returns whether it comes back after each synodic period
 * @property feelsRing whether the spheres pull it as it pulls them; else it keeps its orbit
 * @property epoch time of the elements
 */
@OptIn(ExperimentalSerializationApi::class)
@Serializable
@SerialName("satellite")
@Described("a moon, on a prescribed epicycle or moved by the ring; there may be several")
public class SatelliteSpec @JvmOverloads constructor(
    @Described("mass over that of the planet; of this and `mass` exactly one; needs `units.lengthInMetres`")
    public val massRatio: Double? = null,
    @Described("in units of mass")
    public val mass: Double? = null,
    @Described("of its guiding centre, a length")
    override val x: Double,
    @Described("of its guiding centre at `epoch`, a length")
    public val y: Double,
    @Described("amplitude of the epicycle, a length; default 0")
    override val e: Double = 0.0,
    @Described("at `epoch` in radians; 0 is pericentre; default 0")
    public val phase: Double = 0.0,
    @Described("ε in 1/(r² + ε²), a length; default 0")
    public val softening: Double = 0.0,
    @Described("particles which touch the satellite are removed; 0, a point, for one that feels the ring; default 0")
    public val radius: Double = 0.0,
    @Described("G in the scenario's units, with `mass`; default from `units.lengthInMetres`")
    override val constant: Double? = null,
    @Described("amplitude of its swing across the plane, a length; default 0")
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val inclination: Double = 0.0,
    @Described("phase of that swing at `epoch` in radians; 0 is the ascending node; default 0")
    @EncodeDefault(EncodeDefault.Mode.NEVER) public val node: Double = 0.0,
    @Described("whether it passes again after every synodic period; default false")
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val returns: Boolean = false,
    @Described("whether the ring moves it: it takes up what it gives to all spheres; default false")
    @EncodeDefault(EncodeDefault.Mode.NEVER) public val feelsRing: Boolean = false,
    @Described("time of these elements; default 0")
    @EncodeDefault(EncodeDefault.Mode.NEVER) override val epoch: Double = 0.0,
) : ForceSpec,
    Moon {
    /** Without [inclination] the vertical phase is 0. */
    override val orbit: Epicycle
        get() = Epicycle(x, y, e, phase, inclination, if (inclination == 0.0) 0.0 else node - Math.PI / 2)

    /** The elements of [orbit] and [epoch]. */
    override val carried: List<Double>? get() = if (feelsRing) orbit.elements().asList() + epoch else null
    override val keysOfCarried: Set<String> get() = KEYS_OF_ORBIT

    /** It was given the same orbit. */
    override fun goesOnAs(other: ForceSpec): Boolean =
        other is SatelliteSpec && other.epoch == epoch && other.orbit.elements().contentEquals(orbit.elements())

    override fun beginningWith(state: List<Double>): ForceSpec {
        val orbit = Epicycle.ofElements(state.toDoubleArray())
        val node = if (orbit.i == 0.0) 0.0 else orbit.verticalPhase + Math.PI / 2
        return SatelliteSpec(
            massRatio, mass, orbit.guidingX, orbit.guidingY, orbit.e, orbit.phase, softening, radius, constant,
            orbit.i, node, returns, feelsRing, state[Epicycle.ELEMENTS],
        )
    }

    override fun massRatio(units: UnitsSpec, gravitationalParameter: Double): Double? {
        val constant = constant ?: units.gravitationalConstant ?: return null
        return massRatio ?: mass?.let { it * constant / gravitationalParameter }
    }

    override fun force(place: ForcePlace): Force {
        val check = place.check
        val key = place.key
        val orbits = place.orbits ?: check.fail(key, "is a satellite; it needs a frame of type hill")
        check.must(key, (massRatio == null) != (mass == null)) { "needs exactly one of massRatio and mass" }
        val strength = if (mass != null) {
            check.positive("$key.mass", mass)
            mass * place.constant(constant)
        } else {
            check.positive("$key.massRatio", massRatio!!)
            check.must("$key.constant", constant == null) {
                "goes with mass; the pull of a massRatio follows from the planet"
            }
            massRatio * (place.planet ?: check.fail(LENGTH, "is missing; the mass ratio of a satellite needs it"))
        }
        check.must(key, strength.isFinite()) { "has a mass that makes its gravity $strength; it must be finite" }
        check.atLeast0("$key.softening", softening)
        check.atLeast0("$key.e", e)
        check.atLeast0("$key.radius", radius, "0 for a point")
        check.atLeast0("$key.inclination", inclination)
        for ((name, value) in listOf("x" to x, "y" to y, "e" to e, "inclination" to inclination, "epoch" to epoch)) {
            check.that("$key.$name", value, abs(value) <= FARTHEST) { "must be a finite number" }
        }
        for ((name, value) in listOf("phase" to phase, "node" to node)) {
            check.that("$key.$name", value, value.isFinite()) { "must be a finite number" }
        }
        return Satellite(strength, orbit, orbits, softening, circumference(place), inertia(place, strength), epoch)
    }

    /** The mass of one of so much gravity; infinite for one that feels nothing. */
    private fun inertia(place: ForcePlace, strength: Double): Double {
        if (!feelsRing) return Double.POSITIVE_INFINITY
        val key = "${place.key}.feelsRing"
        place.check.must(key, radius == 0.0) { "is of a satellite without radius, onto which nothing falls" }
        place.check.must(key, place.orbits!!.nu > 0) { "needs a force towards the midplane; verticalFactor is 0" }
        val constant = constant ?: place.units.gravitationalConstant
        place.check.must(key, constant != 0.0) { "needs a constant of gravity that is not 0" }
        return mass ?: (strength / place.constant(constant))
    }

    /** Of the orbit along which it comes back; infinite when it does not. */
    private fun circumference(place: ForcePlace): Double {
        if (!returns) return Double.POSITIVE_INFINITY
        val distance = place.distance
            ?: place.check.fail(LENGTH, "is missing; ${place.key} returns along an orbit whose length it needs")
        val circumference = 2 * Math.PI * distance
        place.check.must("${place.key}.returns", place.boundary.box.length(1) < circumference) {
            "needs a patch that is shorter than the orbit, $circumference"
        }
        return circumference
    }

    override fun boundary(place: ForcePlace, made: Force): BoundaryConditions =
        if (radius > 0) SatelliteSurface(place.boundary, made as Satellite, radius) else place.boundary

    override fun checkStart(place: ForcePlace, population: Population, duration: Double) {
        val orbits = place.orbits ?: return
        checkBodies(place, population, orbits)
        if (radius == 0.0) return
        // A sphere that falls onto a moon is detected from its position at the end of a step, so none may pass through
        // the moon within one step.
        val box = place.boundary.box
        val farthest = maxOf(abs(x - box.lower(0)), abs(x - box.upper(0))) + 2 * e
        val way = (abs(orbits.shearRate) * farthest + orbits.nu * inclination) * duration
        place.check.that("${place.key}.radius", radius, way < 2 * radius) {
            "is small compared with the $way that particles drift past it in a step; " +
                "take a smaller dt, or 0 for a point"
        }
    }

    /**
     * It begins on its orbit whatever is in its way, so that may not cross the plane of the patch, or lie in it, within a body
     * of the scenario: that would be thrown far away, or removed as ring matter is. Bodies are the last spheres of [p],
     * on the free paths of their first velocities.
     */
    private fun checkBodies(place: ForcePlace, p: Population, orbits: OrbitalFrequencies) {
        for (b in 0 until place.bodies) {
            val k = p.size - place.bodies + b
            val body = Epicycle.of(p.x[k], p.y[k], p.z[k], p.vx[k], p.vy[k], p.vz[k], orbits)
            val reach = radius + p.radius[k] + e + body.e
            // A body that swings through a face goes on at the other side.
            val length = place.boundary.box.length(0)
            val images = if (place.boundary.repeats(0)) listOf(-length, 0.0, length) else listOf(0.0)
            for (at in images.map { body.guidingX + it }) {
                place.check.that("${place.key}.x", x, abs(x - at) > reach) {
                    "on its way the satellite crosses the plane within bodies[$b], whose orbit is at $at; " +
                        "it must be farther than $reach from there"
                }
            }
        }
    }

    override fun inWords(place: ForcePlace, population: Population, say: Quantities): String {
        val orbits = place.orbits!!
        val g = constant ?: place.units.gravitationalConstant
        val mass = mass ?: place.planet?.let { gm -> g?.let { massRatio!! * gm / it } }
        return listOfNotNull(
            "satellite of ${mass?.let { say.mass(it) } ?: "mass ratio ${number(massRatio!!)}"}",
            if (radius > 0) "radius ${say.length(radius)}" else "a point",
            "${say.length(abs(x))} ${if (x < 0) "inside" else "outside"} the middle of the box",
            "e a = ${say.length(e)}",
            "wakes ${say.length(2 * Math.PI * orbits.shearFactor / orbits.radialFactor * abs(x))} long",
            if (feelsRing) "feels the ring" else null,
            if (inclination > 0) "i a = ${say.length(inclination)}" else null,
            place.distance?.takeIf { returns }?.let { orbitsBetweenPassages(it, orbits) }?.let {
                // And how many of its wakes go round the planet until then.
                "returns every ${number(it)} orbits, ${number(it * orbits.radialFactor)} epicycles"
            },
            mass?.let { m -> g?.let { "Hill radius ${say.length(orbits.hillRadius(it * m))}" } },
        ).joinToString(", ")
    }

    override fun fastestPull(place: ForcePlace, population: Population): Pull? {
        val smallest = place.particles(population).minOfOrNull { population.radius[it] } ?: return null
        val box = place.boundary.box
        // Radially between the box and what it swings over; 0 where it swings into the box.
        val gap = maxOf(0.0, abs(x - (box.lowerX + box.upperX) / 2) - box.length(0) / 2 - e)
        val strength = when {
            mass != null -> (constant ?: place.units.gravitationalConstant)?.let { it * mass }
            else -> place.planet?.let { it * (massRatio ?: 0.0) }
        }
        return strength?.let {
            val rate = orbitalRate(it, maxOf(radius + smallest, gap), softening)
            Pull(rate, "an orbit as near to the satellite as spheres come")
        }
    }
}

/** Squares of it and what comes of them are numbers. */
private const val FARTHEST = 1e100
private val KEYS_OF_ORBIT = setOf("x", "y", "e", "phase", "inclination", "node", "epoch")
private const val LENGTH = "units.lengthInMetres"
