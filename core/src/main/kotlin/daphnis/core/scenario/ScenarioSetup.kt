package daphnis.core.scenario

import daphnis.core.CarriedState
import daphnis.core.FixedTimeStep
import daphnis.core.FreePathTimeStep
import daphnis.core.StoppingTimeStep
import daphnis.core.Stops
import daphnis.core.TimeStep
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.at
import daphnis.core.collision.CollapseGuard
import daphnis.core.collision.GuardSpec
import daphnis.core.collision.PairStates
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.force.Force
import daphnis.core.force.ForcePlace
import daphnis.core.force.PairEnergy
import daphnis.core.force.Pull
import daphnis.core.format.Snapshot
import daphnis.core.input.InputException
import daphnis.core.input.Quantities
import daphnis.core.input.ValueCheck
import daphnis.core.measure
import daphnis.core.merging.BreakRule
import daphnis.core.merging.MergeRule
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.ThreadHandler
import daphnis.core.population.Population
import daphnis.core.potential.PairInteractions
import daphnis.core.source.Sources
import daphnis.core.surface.ContactLaw
import daphnis.core.surface.Roughness
import daphnis.core.swap.SwapRule
import kotlin.math.sqrt

/**
 * The objects of a simulation that a [Scenario] describes, made and checked.
 *
 * Everything here is a pure function of the scenario (and of the particle file it may name), so a scenario gives the
 * same initial state on every machine.
 *
 * @property frequencies of orbits in the frame; null without a frame
 * @property notices what a user should know about the initial state, one line each
 */
public class ScenarioSetup private constructor(
    public val scenario: ResolvedScenario,
    public val population: Population,
    public val boundary: BoundaryConditions,
    /** ε, of which β is [roughness]. */
    public val restitution: ContactLaw,
    public val guard: CollapseGuard,
    public val forces: List<Force>,
    public val timeStep: TimeStep,
    public val frequencies: OrbitalFrequencies?,
    public val notices: List<String>,
    /** Of the spheres; null for smooth ones. */
    public val roughness: Roughness?,
    private val places: List<ForcePlace>,
    /** What spheres do to one another besides impacts; null for nothing. */
    public val interactions: PairInteractions?,
    /** Which impacts merge spheres; null for none. */
    public val mergeRule: MergeRule?,
    /** Which impacts break spheres; null for none. */
    public val breakRule: BreakRule?,
    /** How spheres swap places; null for spheres that do not. */
    public val swapRule: SwapRule?,
    /** Where spheres come and leave; null for nowhere. */
    public val sources: Sources?,
) {
    /** What a run of this carries from step to step besides the spheres. */
    internal val carried: CarriedState = CarriedState(boundary, forces)

    /** Angular speed of the frame in radians per unit of time; null without a frame. */
    public val angularSpeed: Double? get() = frequencies?.omega

    /** Moment of inertia of the spheres over mass · radius². */
    public val momentFactor: Double get() = scenario.momentFactor

    /** The forces of the scenario for a reader, as they act at the start. */
    public fun forcesInWords(say: Quantities): List<String> =
        scenario.forces.mapIndexed { k, it -> it.inWords(places[k], population, say) }

    /** The fastest orbit that a force makes room for at the start; null where nothing attracts. */
    internal fun fastestPull(): Pull? = scenario.forces.mapIndexedNotNull { k, it ->
        it.fastestPull(places[k], population)
    }.filter { it.rate > 0 }.maxByOrNull { it.rate }

    /**
     * The collisions of a simulation of this, computed by [engine].
     *
     * @param recordCollisions see [CollisionForcing]; with a piston they are recorded in any case
     * @param law another one in place of the scenario's restitution
     * @param roughness another one in place of the scenario's; null for that of [law]
     */
    @JvmOverloads
    public fun collisions(
        engine: CollisionEngine = SerialEngine(),
        recordCollisions: Boolean = false,
        law: ContactLaw = restitution,
        roughness: Roughness? = this.roughness,
    ): CollisionForcing {
        val records = recordCollisions || !boundary.walls.areKnownAhead
        return CollisionForcing(
            law, guard, engine, records, scenario.search, roughness, momentFactor, interactions, mergeRule,
            breakRule, swapRule,
        )
    }

    /** Length of the first step of a run. */
    public fun firstStep(): Double {
        val longest = timeStep.next(population)
        return if (timeStep is StoppingTimeStep) timeStep.stops.duration(scenario.startTime, longest) else longest
    }

    /**
     * The time step for a simulation in memory, which goes on for as long as its owner says: steps that are chosen
     * neither end at the end of the scenario nor are shortened by it. All others are those of [timeStep].
     */
    public fun endlessTimeStep(): TimeStep {
        if (timeStep !is FreePathTimeStep) return timeStep
        // What has come to rest says no length, and what starts at rest does not even say a unit.
        val first = timeStep.path / timeStep.measure(population, InlineLoop)
        val longest = if (first.isFinite()) first * SLOWEST else 1.0
        val stops = Stops(timeStep.stops.intervals)
        return FreePathTimeStep(timeStep.path, minOf(longest, FreePath.longest(boundary)), timeStep.flow, stops)
    }

    public companion object {
        /**
         * Memory that a sphere needs in population, packed rows, grid and queue: the most measured
         * (docs/performance.md) plus a margin.
         */
        public const val BYTES_PER_SPHERE: Double = 340.0

        /**
         * Makes and checks everything.
         *
         * @param source what to call the scenario in messages
         * @param state the population to continue with, or null for the initial state that the scenario describes
         *   @throws InputException for anything that is wrong
         */
        @JvmStatic
        @JvmOverloads
        public fun of(scenario: Scenario, source: String, state: Population? = null): ScenarioSetup =
            of(scenario, source, state, null)

        /**
         * Checks what [of] checks, except for what needs the places of spheres that are placed at random: whether all
         * find a place, and whether none goes too far in a step whose length follows from speeds. It takes as long as
         * drawing sizes and velocities, and for a particle file as long as [of].
         *
         * @param source what to call the scenario in messages
         * @throws InputException for anything that is wrong
         */
        @JvmStatic
        public fun check(scenario: Scenario, source: String) {
            make(scenario, source, null, null, isPlaced = !scenario.placement.isDrawn)
        }

        /** @param start the state to start from, in place of one from the file of the placement */
        internal fun of(scenario: Scenario, source: String, state: Population?, start: Snapshot?): ScenarioSetup =
            make(scenario, source, state, start, isPlaced = true)

        private fun make(
            scenario: Scenario,
            source: String,
            state: Population?,
            start: Snapshot?,
            isPlaced: Boolean,
        ): ScenarioSetup {
            val check = ValueCheck(source)
            val around = Surroundings.of(scenario, source)
            checkRun(scenario, check)
            val output = OutputTimesCheck(scenario, around, check).settled()
            FreePath.check(scenario, around.boundary, check)
            val materials = Materials(scenario, check, state?.materials.orEmpty())
            val laws = ContactLaws(scenario, materials, check)
            val atStart = around.boundary.at(scenario.startTime)
            val initial = InitialState(scenario, around.box, atStart, check, materials, start)
            val population = state ?: initial.population(isPlaced)
            // The ids of bodies in a run of this file do not hold for a new initial state, unless it is of that run.
            val isMade = state == null && scenario.placement.file == null
            val bodies = if (isMade) scenario.copy(firstBody = null) else scenario
            val firstBody = bodies.firstBody(population.size)
            fun forces() = ForceSetup(scenario, around.frequencies, around.boundary, firstBody, check)
            val forceSetup = forces()
            val boundary = forceSetup.boundary
            val guardSpec = (scenario.guard ?: defaultGuard(scenario)).settled(rmsSpeed(population), check)
            val timeStepSpec = around.timeStep.settled(around, population)
            val settled = scenario.copy(
                placement = scenario.placement.settled(boundary.space),
                sources = scenario.settledSources,
            )
            val resolved = ResolvedScenario(settled, around.end, guardSpec, timeStepSpec, firstBody, output)
            val timeStep = timeStepSpec.timeStep(resolved, boundary, GrowthSetup(scenario, check).longest(), check)
            val first = timeStep.next(population)
            checkSteps(resolved, first, check)
            scenario.sources.forEachIndexed { k, it -> it.checkStep("sources[$k]", first, check) }
            check.must("swaps", scenario.swaps == null || boundary.meanFlow == null) { "need a boundary without shear" }
            scenario.swaps?.checkDraws("swaps", population.size, first, around.end, check)
            if (state == null) GrowthSetup(scenario, check).checkStart(population, around.box, first, around.end)
            val then = boundary.at(scenario.startTime)
            val sources = SourceSetup(scenario, around, boundary, materials, check).sources
            val startCheck = StartCheck(
                scenario,
                population,
                then,
                forceSetup.places,
                check,
                around.end,
                laws.interactions,
                sources?.largest ?: 0.0,
            )
            if (state == null) startCheck.check(timeStep, isPlaced) else startCheck.checkRooms()
            if (state == null && (isPlaced || timeStep is FixedTimeStep)) {
                val likeThem = forces().forces
                FirstKick(scenario, likeThem, then, check).check(population, timeStep.next(population), isPlaced)
            }
            val guard = guardSpec.guard(check)
            return ScenarioSetup(
                resolved, population, boundary, laws.restitution, guard,
                forceSetup.forces + listOfNotNull(laws.interactions?.let { PairEnergy(PairStates(it)) }), timeStep,
                around.frequencies, initial.notices, laws.roughness, forceSetup.places,
                laws.interactions, laws.mergeRule, laws.breakRule, laws.swapRule, sources,
            )
        }

        private fun checkRun(scenario: Scenario, check: ValueCheck) {
            check.that("engine.threads", scenario.engine.threads, scenario.engine.threads in 0..ThreadHandler.MOST) {
                "must be in 1..${ThreadHandler.MOST}, or 0 for one per core"
            }
        }

        /**
         * What has ε < 1 at the lowest speeds can collapse, so it gets a guard far below any speed that matters; other
         * laws are elastic there. So can what bounces between surfaces.
         */
        private fun defaultGuard(scenario: Scenario): GuardSpec {
            val laws = scenario.contacts.mapNotNull { it.restitution } + scenario.restitution
            val mayCollapse = scenario.boundary.mayCollapse || laws.any { it.atRest < 1 }
            return if (mayCollapse) GuardSpec.FloorSpeed(relative = DEFAULT_FLOOR) else GuardSpec.None()
        }

        /** Steps are counted, and each must advance the time. */
        private fun checkSteps(scenario: ResolvedScenario, first: Double, check: ValueCheck) {
            val (key, value, longest) = scenario.timeStep.longest(first)
            val start = scenario.startTime
            val steps = (scenario.end - start) / longest
            check.that(key, value, steps <= MOST_STEPS) {
                "makes $steps steps to the end at time ${scenario.end}; there can be $MOST_STEPS"
            }
            check.that(key, value, start + longest > start) {
                "makes steps that are lost in the rounding of the time, $start, at which the run starts"
            }
        }

        private fun rmsSpeed(population: Population): Double {
            var sum = 0.0
            for (place in 0 until population.places) {
                val k = population.indexAt(place)
                if (k < 0) continue
                sum +=
                    population.vx[k] * population.vx[k] + population.vy[k] * population.vy[k] +
                    population.vz[k] * population.vz[k]
            }
            return if (population.size == 0) 0.0 else sqrt(sum / population.size)
        }

        /** 2⁵³: up to this number the times after a number of steps and after one more differ. */
        private const val MOST_STEPS = 9.007199254740992e15
        private const val DEFAULT_FLOOR = 1e-6

        /** By how much chosen steps may grow, in a simulation without an end. */
        private const val SLOWEST = 1e9
    }
}
