@file:JvmName("Warnings")

package daphnis.core.scenario

import java.util.Locale

/**
 * What is allowed but may not give the wanted result: one line each, which names the key and the remedy; empty when
 * there is nothing to report. It refers to the state with which [setup] begins and its first step. The figures behind
 * the bounds are in docs/physics.md.
 */
@JvmName("of")
public fun warnings(setup: ScenarioSetup): List<String> {
    if (setup.population.size == 0) return emptyList()
    val dt = setup.timeStep.next(setup.population)
    return listOfNotNull(
        coarseOrbit(setup, dt),
        coarsePull(setup, dt),
        smallForWakes(setup),
        fastWall(setup, dt),
        coarsePiston(setup, dt),
    )
}

/**
 * Collisions are found on chords, which deviate from the paths by an amount proportional to the step squared; what
 * counts is the shortest of the periods in which paths bend.
 */
private fun coarseOrbit(setup: ScenarioSetup, dt: Double): String? {
    val orbits = setup.frequencies ?: return null
    val vertical = orbits.verticalFactor
    val steps = 2 * Math.PI / (orbits.omega * dt)
    val ofPeriod = steps / maxOf(1.0, vertical)
    // Round-off of a step given as part of an orbit is not a reason to warn.
    if (ofPeriod >= FEWEST_STEPS * (1 - ROUNDING)) return null
    return line(
        "timeStep: %.3g steps per %s; chords deviate from the epicycles by %.1g of an epicycle within a step, " +
            "and forces act once per step; take %.0f or more%s",
        ofPeriod,
        if (vertical > 1) line("vertical period (1/%.4g of an orbit)", vertical) else "orbit",
        (2 * Math.PI / ofPeriod).let { it * it / 8 },
        Math.ceil(FEWEST_STEPS * maxOf(1.0, vertical) * (1 - ROUNDING)),
        if (vertical > 1) " per orbit" else "",
    )
}

/** Kicks shift the frequency of an orbit by a part (rate · step)²/24. */
private fun coarsePull(setup: ScenarioSetup, dt: Double): String? {
    val pull = setup.fastestPull() ?: return null
    val kicks = 2 * Math.PI / (pull.rate * dt)
    if (kicks >= FEWEST_KICKS * (1 - ROUNDING)) return null
    return line(
        "timeStep: %.3g steps per period of %s, the shortest that gravity makes, and it acts once per step; " +
            "take steps of %.3g or less",
        kicks,
        pull.what,
        2 * Math.PI / (pull.rate * FEWEST_KICKS),
    )
}

/** A patch with self-gravity that is shorter than one unstable wave has no room for wakes. */
private fun smallForWakes(setup: ScenarioSetup): String? {
    // Waves along x alone make no wakes.
    if (setup.scenario.forces.none { it.gathers }) return null
    val wavelength = criticalWavelength(setup) ?: return null
    val box = setup.boundary.box
    val shortest = (0..1).filter { setup.boundary.hasImages(it) }.minByOrNull { box.length(it) } ?: return null
    val ratio = box.length(shortest) / wavelength
    if (ratio >= 1) return null
    return line(
        "box: the edge along %s is %.2g critical wavelengths (4π² G Σ/κ² = %.4g) long, so it has no room for one " +
            "self-gravity wake; Daisaka, Tanaka & Ida (2001) take 4 or more",
        "xy"[shortest],
        ratio,
        wavelength,
    )
}

/** Toomre's 4π² G Σ/κ² of the particles of [setup]; null without Hill's frame or self-gravity. */
private fun criticalWavelength(setup: ScenarioSetup): Double? {
    val scenario = setup.scenario
    val kappa = setup.frequencies?.kappa ?: return null
    val g = scenario.selfGravity ?: return null
    val p = setup.population
    val mass = (0 until p.size).sumOf { if (scenario.isBody(p.id[it])) 0.0 else p.mass[it] }
    val box = setup.boundary.box
    return 4 * Math.PI * Math.PI * g * mass / (box.length(0) * box.length(1)) / (kappa * kappa)
}

private fun line(format: String, vararg values: Any): String = String.format(Locale.ROOT, format, *values)

private const val FEWEST_STEPS = 100.0

/** Steps per period of a pull: fewer than this, and kicks shift its frequency by more than 7 parts in 10⁴. */
private const val FEWEST_KICKS = 50.0
private const val ROUNDING = 1e-9
