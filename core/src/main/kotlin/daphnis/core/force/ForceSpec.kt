package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.input.Quantities
import daphnis.core.population.Population

/**
 * A force as a scenario describes it: what others ask of a force is asked here, and nobody asks which force it is. Only
 * [force] and [inWords] must be said; what else is said here is that of a force between each sphere and something
 * outside, which costs next to nothing.
 */
public interface ForceSpec {
    /** Whether it acts on discs in a plane as well. */
    public val actsOnDiscs: Boolean get() = false

    /** Whether it can keep spheres moving that lose their energy in collisions. */
    public val heats: Boolean get() = true

    /** Whether it acts as well where the box changes with time and images with it. */
    public val allowsChangingBox: Boolean get() = false

    /** Whether it is between all pairs of spheres, so that it does no work on them as a whole. */
    public val isAmongAll: Boolean get() = false

    /** Whether it gathers spheres in clumps, in which they collide much more often. */
    public val gathers: Boolean get() = false

    /** The acceleration along x, y, z, length/time², of a force that gives all spheres the same at all times; else null. */
    public val acceleration: List<Double>? get() = null

    /** G in the scenario's units, of gravity that says it; else null. */
    public val constant: Double? get() = null

    /** The noise with which it heats every sphere; null without. */
    public val noise: WhiteHeating? get() = null

    /** What its force carries from step to step, as at the start; null for nothing. */
    public val carried: List<Double>? get() = null

    /** Keys that say what [carried] is: a run that goes on from a state of another one takes it from there. */
    public val keysOfCarried: Set<String> get() = emptySet()

    /** Whether this is what [other] was in another run, from a state of which a run goes on, so that it goes on too. */
    public fun goesOnAs(other: ForceSpec): Boolean = false

    /** The same which begins with [state], which the force of another run carried. */
    public fun beginningWith(state: List<Double>): ForceSpec = this

    /**
     * The force, with its values checked.
     *
     * @throws daphnis.core.input.InputException for values that are wrong
     */
    public fun force(place: ForcePlace): Force

    /** The boundary conditions with what [made], which is its [force], adds to those of [place]. */
    public fun boundary(place: ForcePlace, made: Force): BoundaryConditions = place.boundary

    /**
     * Checks that it can act on [population], with which a run begins with a step of [duration].
     *
     * @throws daphnis.core.input.InputException when it cannot
     */
    public fun checkStart(place: ForcePlace, population: Population, duration: Double): Unit = Unit

    /** A description for a reader, of what acts on [population] at the start. */
    public fun inWords(place: ForcePlace, population: Population, say: Quantities): String

    /** The fastest orbit that it makes room for in [population]; null where it attracts nothing. */
    public fun fastestPull(place: ForcePlace, population: Population): Pull? = null

    /** Seconds that one of so many [spheres] costs in a step, as measured (docs/performance.md). */
    public fun seconds(spheres: Int): Double = 0.0
}

/** The angular frequency [rate] of the orbit around, or of, [what]. */
public class Pull(public val rate: Double, public val what: String)

/**
 * White noise that accelerates each sphere by itself.
 *
 * @property drag γ, per unit of time
 * @param ofMass ξ² of a sphere by its mass, (length/time)² per unit of time
 */
public class WhiteHeating(public val drag: Double, private val ofMass: (mass: Double) -> Double) {
    /** ξ² of a sphere of [mass]. */
    public fun intensity(mass: Double): Double = ofMass(mass)
}
