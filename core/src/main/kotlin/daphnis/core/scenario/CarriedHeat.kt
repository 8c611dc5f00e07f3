package daphnis.core.scenario

/**
 * Whether a run sums what heat the spheres carry: only where it writes `transport.csv`, and a gas of spheres is at
 * rest and elastic, so that its conductivity follows.
 */
internal val ScenarioSetup.carriesHeat: Boolean
    get() = scenario.restitutionAtRest == 1.0 &&
        (0..2).all { boundary.repeats(it) } &&
        (scenario.output.transportEvery != 0 || scenario.output.transportInterval != null)
