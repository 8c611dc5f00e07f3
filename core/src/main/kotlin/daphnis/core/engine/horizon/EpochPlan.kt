package daphnis.core.engine.horizon

/**
 * Chooses how long epochs are, how fine their cells, and whether they pay at all, from the work that is expected: a
 * model of how many lines and rows of cells a search looks at, corrected by what the last epoch has measured. The clock
 * is not asked here, but may decide how many threads are planned for ([daphnis.core.engine.QuickerWay]).
 *
 * A longer epoch shares its search for all among more steps. But that search, and those after collisions, look farther,
 * and spheres on curved paths leave their lines.
 */
internal class EpochPlan {
    private val seen = SeenWork()
    private var expectedTests = 0.0

    /** Which of [DEVIATIONS] spheres are allowed. */
    private var level = 0

    /** The most steps of an epoch without too many spheres off their lines, and epochs since this was found. */
    private var mostSteps = LONGEST
    private var calm = 0

    /** Of the present epoch, or of the last that was thought of. */
    private var cost: EpochCost? = null

    /** Whether the collisions of the epoch are to be shared among groups. */
    var sharesCollisions = true
        private set

    /** Whether the present epoch is expected to be so much quicker than the serial engine that it is not compared. */
    var isFarAhead = false
        private set

    /** The best layout that has been considered, and what it is expected to cost. */
    private var best: HorizonTuning? = null
    private var least = 0.0

    /** Steps to come that are left to the other engine without asking, and how many when an epoch does not pay. */
    private var rest = 0
    private var nextRest = 1

    /** Steps of the present epoch, or a part of a step where it has windows. */
    private var span = 1.0

    /** How many steps are to be left to the other engine when an epoch is abandoned. */
    private var nextRetreat = RETREAT

    /** Whether the next step is to be left to the other engine without asking. */
    fun rests(): Boolean {
        if (rest == 0) return false
        rest--
        return true
    }

    /**
     * The layout of an epoch that starts now.
     *
     * @return null when an epoch is not expected to be quicker than another engine
     */
    fun choose(spheres: Int, frame: EpochFrame, cells: EpochCells, filter: LineFilter, threads: Int): HorizonTuning? {
        val deviation = DEVIATIONS[level]
        val bound = if (cells.speeds.fastShare > MANY_FAST) WIDE_BOUND else CLASS_BOUND
        val cost = EpochCost(spheres, frame, cells, filter, threads, seen)
        this.cost = cost
        least = WORTH * cost.serial()
        best = null
        // Only groups that share collisions can tell whether they are less entangled now.
        if (!sharesCollisions) seen.entanglement = maxOf(CALMING * seen.entanglement, LEAST_ENTANGLEMENT)
        sharesCollisions = false
        var isPossible = false
        for (steps in STEPS) {
            // In a longer time spheres would go too far for lines.
            if (steps > mostSteps || !frame.begin(HorizonTuning(steps, bound, deviation))) break
            consider(cost, HorizonTuning(steps, bound, deviation))
            isPossible = true
        }
        if (isPossible && (best?.steps ?: 1) == 1) considerWindows(cost, HorizonTuning(1, bound, deviation))
        isFarAhead = best != null && cost.serial() > FAR_AHEAD * least
        return best?.let { begins(it) } ?: refused()
    }

    /**
     * The layout [fixed], in which an epoch is to start now, unless that is expected to be far more work than the steps
     * of another engine are. Where epochs are wanted [always], that is seen on the way only.
     *
     * @return null when it is
     */
    fun admit(
        fixed: HorizonTuning,
        spheres: Int,
        frame: EpochFrame,
        cells: EpochCells,
        filter: LineFilter,
        threads: Int,
        always: Boolean,
    ): HorizonTuning? {
        val cost = EpochCost(spheres, frame, cells, filter, threads, seen)
        this.cost = cost
        if (!frame.begin(fixed)) return null
        val expected = cost.of(fixed.steps, fixed.windows, fixed.classBound, fixed.cellsAlong, fixed.cellsAcross)
        expectedTests = cost.testsAhead
        sharesCollisions = true
        return if (always || expected <= MOST * cost.serial()) begins(fixed) else refused()
    }

    /**
     * Lays out an epoch of [spheres] in [space] that starts now: as [fixed], or, where that is null, as should be
     * quickest. Where epochs are wanted [always], any are.
     *
     * @return null when there is to be none
     */
    fun layOut(
        fixed: HorizonTuning?,
        spheres: Int,
        space: EpochSpace,
        filter: LineFilter,
        threads: Int,
        always: Boolean,
    ): HorizonTuning? {
        val tuning = if (fixed == null) {
            choose(spheres, space.frame, space.cells, filter, threads)
        } else {
            admit(fixed, spheres, space.frame, space.cells, filter, threads, always)
        }
        if (tuning == null || !space.frame.begin(tuning)) return null
        space.limits.begin(tuning, checkNotNull(cost), isPatient = always)
        return tuning
    }

    /**
     * Told that an epoch has been given up on the way since it was too much work, with so many entries of [roamers]
     * looked at per sphere and step.
     */
    fun abandoned(roamers: Double) {
        seen.sawRoamers(maxOf(seen.roamersWithin(span), roamers), span)
        rest = nextRetreat
        nextRetreat = minOf(2 * nextRetreat, LONG_REST)
    }

    private fun begins(tuning: HorizonTuning): HorizonTuning {
        span = tuning.steps.toDouble() / tuning.windows
        nextRest = 1
        return tuning
    }

    private fun refused(): Nothing? {
        // What is known of the first steps is a guess, and soon they are over.
        rest = nextRest
        nextRest = minOf(2 * nextRest, REST)
        seen.calm(CALMING)
        return null
    }

    /** A step is cut more finely as long as that is expected to be quicker. */
    private fun considerWindows(cost: EpochCost, step: HorizonTuning) {
        var before = Double.POSITIVE_INFINITY
        for (windows in WINDOWS) {
            val expected = consider(cost, step.inWindows(windows))
            if (expected > before) return
            before = expected
        }
    }

    /** Takes epochs of [tuning], in cells of some width, if they are better than the [best]. @return expected cost */
    private fun consider(cost: EpochCost, tuning: HorizonTuning): Double {
        var leastHere = Double.POSITIVE_INFINITY
        for (across in CELLS_ACROSS) {
            for (along in CELLS_ALONG) {
                val expected = cost.of(tuning.steps, tuning.windows, tuning.classBound, along, across)
                leastHere = minOf(leastHere, expected)
                if (expected < least) {
                    least = expected
                    best = tuning.inCells(along, across)
                    expectedTests = cost.testsAhead
                    sharesCollisions = cost.sharesCollisions
                }
            }
        }
        return leastHere
    }

    /** Told that a step of the serial engine had so many [collisions] per sphere. */
    fun observe(collisions: Double) {
        seen.collisions = collisions
    }

    /** Told that all have been searched for, with [tests] lines tested per sphere. */
    fun searched(tests: Double) {
        if (expectedTests <= 0) return
        seen.crowding = (seen.crowding * tests / expectedTests).coerceIn(LEAST_CROWDING, MOST_CROWDING)
        // The next window is expected to be as this one was.
        expectedTests = tests
    }

    /**
     * Told that groups have shared the [collisions] of a step, and that [anew] were processed anew to join what they
     * have done, for which [compared] pieces of paths were compared; all per sphere.
     */
    fun joined(collisions: Double, anew: Double, compared: Double) {
        val expected = cost?.joining(collisions) ?: return
        if (expected <= 0) return
        val measured = EpochCost.COLLISION_ANEW * anew + EpochCost.COMPARISON * compared
        val least = maxOf(CALMING * seen.entanglement, LEAST_ENTANGLEMENT)
        seen.entanglement = (measured / expected).coerceIn(least, MOST_ENTANGLEMENT)
    }

    /**
     * Told that an epoch has ended after [steps] steps with so many [collisions], [strays] and entries of [roamers]
     * looked at, all per sphere and step.
     *
     * @param isBroken whether it ended early, since too many spheres had left their lines
     */
    fun ended(steps: Int, collisions: Double, strays: Double, roamers: Double, isBroken: Boolean) {
        seen.sawRoamers(roamers, span)
        seen.collisions = collisions
        nextRetreat = RETREAT
        seen.strays = if (isBroken) 0.0 else strays
        if (isBroken || strays > MOST_STRAYS) {
            calm = 0
            if (level < DEVIATIONS.size - 1) {
                level++
            } else if (mostSteps > 1) {
                mostSteps = maxOf(1, minOf(mostSteps, steps) - 1)
            }
        } else if (++calm == PATIENCE) {
            // What made spheres stray may be over.
            calm = 0
            if (mostSteps < LONGEST) mostSteps++
        }
    }

    private companion object {
        val STEPS = intArrayOf(1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 24, 32, 48, 64)
        val WINDOWS = intArrayOf(2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128)
        val CELLS_ACROSS = doubleArrayOf(0.5, 0.7, 1.0, 1.4, 2.0, 2.8)
        val CELLS_ALONG = doubleArrayOf(1.0, 2.0, 4.0)
        const val LONGEST = 64
        const val CLASS_BOUND = 3.0

        /** The same where more than that part of the spheres would be beyond it; of a gas .8 % are. */
        const val WIDE_BOUND = 5.0
        const val MANY_FAST = 0.02

        /** In units of the largest radius of a member: for free flight, for weak forces, for curved paths. */
        val DEVIATIONS = doubleArrayOf(0.0, 0.06, 0.15)

        /** Strays per sphere and step with which an epoch is as it should be. */
        const val MOST_STRAYS = 0.03

        /** Expected cost, in units of that of the serial engine, below which an epoch is begun. */
        const val WORTH = 0.88
        const val REST = 16

        /** Times the expected cost. */
        const val FAR_AHEAD = 3.0

        /** The same for an epoch of a fixed layout. */
        const val MOST = 2.0

        /** Steps left to the other engine when an epoch is given up: first, and at most. */
        const val RETREAT = 4
        const val LONG_REST = 64
        const val PATIENCE = 32
        const val LEAST_CROWDING = 0.2
        const val MOST_CROWDING = 100.0
        const val LEAST_ENTANGLEMENT = 0.2
        const val MOST_ENTANGLEMENT = 1e6

        /** The part to which what was bad for an epoch, or for groups, may fall in a step, or while it is not tried. */
        const val CALMING = 0.95
    }
}
