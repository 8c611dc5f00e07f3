package daphnis.core.engine.horizon

import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep

/**
 * Looks ahead over several steps at once, on one thread: it searches for neighbours once in an [Epoch], where the
 * serial engine searches in every step. In a dilute system the search is most of the work.
 *
 * It takes the same collisions in the same order and fails at the same collision as the serial engine, with the same
 * words. Where lines cannot be used ([EpochFrame.begin]), where a sphere is suddenly too fast for the bounds of the
 * step, and where an epoch would not pay, the serial engine takes the step.
 *
 * @param fewest the least number of spheres with which epochs are made; 0 makes them wherever lines can be used
 * @param tuning how epochs are laid out; null for what should be quickest
 */
public class HorizonEngine @JvmOverloads constructor(
    private val fewest: Int = WORTH_SPHERES,
    private val tuning: HorizonTuning? = null,
) : CollisionEngine {

    override val name: String get() = "horizon"
    override val threads: Int get() = 1
    private val gate = ClosableLoop(InlineLoop, CollisionEngine.CLOSED)
    override val loop: RangeLoop get() = gate

    private val prepared = PreparedStep()
    private val serial = SerialEngine(prepared = prepared)
    private val epoch = Epoch(prepared)

    /** Epochs begun, and steps taken in them, since the start; all other steps were the serial engine's. */
    public val epochs: Long get() = epoch.begun
    public var epochSteps: Long = 0
        private set

    /** Spheres that were found off their lines, at the starts of steps, since the start. */
    internal val strays: Long get() = epoch.strays

    override fun advance(step: CollisionStep) {
        gate.requireOpen()
        val size = step.population.size
        if (size < maxOf(fewest, 1) || tuning == null && epoch.rests()) {
            epoch.drop()
        } else {
            prepared.measure(step)
            if (epoch.carry(step, tuning)) {
                epochSteps++
                return
            }
        }
        val before = step.counters.collisions
        serial.advance(step)
        if (size > 0) epoch.observe((step.counters.collisions - before).toDouble() / size)
    }

    override fun close() {
        gate.close()
    }

    private companion object {
        const val WORTH_SPHERES = 256
    }
}
