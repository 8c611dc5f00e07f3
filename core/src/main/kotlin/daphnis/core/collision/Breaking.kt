package daphnis.core.collision

import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.merging.BreakRule
import daphnis.core.merging.Pieces
import daphnis.core.population.Bonds

/**
 * What an impact does to spheres that break in it. It only marks them, in their lists of [Bonds], and takes the energy of
 * their pieces; they go on whole until the end of the step, where [Pieces] takes their places. Keeps nothing.
 */
internal class Breaking(val rule: BreakRule) {
    /** Whether the sphere in [slot] has broken in this step. */
    fun isBroken(rows: StepRows, slot: Int): Boolean = Bonds.state(rows.bonds[slot], rows.id[slot]) == Pieces.BROKEN

    /**
     * Breaks the spheres in the slots [first] and [second] of [rows], whose impact is described in [outcome], if the rule
     * says so. The energy that is taken for pieces goes to [CollisionOutcome.kept].
     */
    fun take(rows: StepRows, first: Int, second: Int, outcome: CollisionOutcome) {
        outcome.kept = 0.0
        val speed = outcome.impactSpeed
        if (speed <= rule.speed) return
        val one = canBreak(rows, first)
        val other = canBreak(rows, second)
        val m1 = rows.mass[first]
        val m2 = rows.mass[second]
        val energy = (if (one) rule.energy(m1) else 0.0) + (if (other) rule.energy(m2) else 0.0)
        if (energy > 0.5 * (m1 * m2 / (m1 + m2)) * speed * speed) return
        if (one) mark(rows, first)
        if (other) mark(rows, second)
        outcome.kept = energy
    }

    private fun canBreak(rows: StepRows, slot: Int) =
        rule.canBreak(rows.state[slot * STRIDE + RADIUS]) && !isBroken(rows, slot)

    private fun mark(rows: StepRows, slot: Int) {
        rows.bonds[slot] = Bonds.with(rows.bonds[slot], rows.id[slot], Pieces.BROKEN)
    }
}
