package daphnis.core.step

import daphnis.core.collision.StepRows

/**
 * Ends steps that would go on for ever, by criteria that depend on the trajectory alone, so that every engine which
 * follows the same trajectory ends at the same collision. A sphere that collides again and again while time stands
 * still has collapsed ([StepRows.streak]), and a step may have only a limited number of collisions.
 */
internal class StepLimits {
    private var stepStart = 0.0
    private var mostCollisions = 0L

    /** Begins a step of [spheres] spheres at [stepStart]. */
    fun start(spheres: Int, stepStart: Double) {
        this.stepStart = stepStart
        mostCollisions = mostCollisions(spheres)
    }

    /**
     * Checks spheres [first] and [second], negative for a wall, which have just collided at [time].
     *
     * @throws CollapseException when either has collided more than [MOST_IN_A_ROW] times while time stood still
     */
    fun checkProgress(rows: StepRows, first: Int, second: Int, time: Double) {
        if (rows.streak(first) > MOST_IN_A_ROW || second >= 0 && rows.streak(second) > MOST_IN_A_ROW) {
            throw collapse(rows, first, second, time)
        }
    }

    private fun collapse(rows: StepRows, first: Int, second: Int, time: Double): CollapseException {
        val id = rows.id[first]
        val who = if (second < 0) {
            "sphere $id and a wall"
        } else {
            "spheres ${minOf(id, rows.id[second])} and ${maxOf(id, rows.id[second])}"
        }
        return CollapseException(
            "inelastic collapse at time ${stepStart + time}, of $who: more than $MOST_IN_A_ROW collisions in a row " +
                "while time stands still; set a collapse guard (contact duration, or a higher floor speed)",
        )
    }

    /**
     * Checks how many [collisions] the step has had, including those with walls.
     *
     * @throws IllegalArgumentException when there are too many
     */
    fun checkWork(collisions: Long) {
        require(collisions <= mostCollisions) {
            "the step from time $stepStart has more than $mostCollisions collisions: spheres are jammed, or the step " +
                "is too long; take a smaller dt or a collapse guard"
        }
    }

    companion object {
        /** For one sphere. Real heaps that come to rest at one moment have some thousand. */
        const val MOST_IN_A_ROW = 10_000

        private const val LEAST_WORK = 2_000_000L
        private const val WORK_PER_SPHERE = 1000L

        /** How many collisions a step of [spheres] spheres may have. */
        fun mostCollisions(spheres: Int): Long = LEAST_WORK + WORK_PER_SPHERE * spheres
    }
}

/**
 * Thrown at an inelastic collapse: very many collisions of one sphere while time stands still. A collapse guard
 * prevents it.
 */
public class CollapseException(message: String) : RuntimeException(message)
