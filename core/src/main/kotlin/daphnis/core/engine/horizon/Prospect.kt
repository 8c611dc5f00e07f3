package daphnis.core.engine.horizon

import daphnis.core.step.CollisionStep
import java.util.concurrent.atomic.AtomicLong

/**
 * Whether so much work is to come that it pays to have the JVM compile epochs, and what threads share. That takes it
 * seconds, in which the serial engine has ended a short run.
 *
 * Work is counted in spheres that the serial engine carries through a step; a collision is worth several. What has been
 * done in this JVM counts like what is to come: of many short runs the later ones are long.
 *
 * @param done that work, of steps whose run is not very long
 */
internal class Prospect(private val done: AtomicLong = IN_THIS_JVM) {
    private var collisions = 0L
    private var work = Long.MAX_VALUE

    /** Whether epochs pay, once and for all. */
    var isLong = false
        private set

    /** Whether two threads pay, of which one would otherwise be left to the compilers. */
    val isVeryLong: Boolean get() = work >= VERY_LONG

    /** Told of each [step] before it is taken. */
    fun look(step: CollisionStep) {
        val steps = step.toCome.toDouble() + 1
        work = (done.get() + steps * worth(step)).toLong()
        if (work >= LONG) isLong = true
    }

    /** Told of each [step] that has been taken, with so many [collisions]. */
    fun passed(step: CollisionStep, collisions: Long) {
        this.collisions = collisions
        if (work < VERY_LONG) done.addAndGet(worth(step))
    }

    private fun worth(step: CollisionStep) = step.population.size + COLLISION * collisions

    internal companion object {
        val IN_THIS_JVM = AtomicLong()

        /** 2 µs for a collision, .15 µs for a sphere. */
        private const val COLLISION = 13

        /** Some 3 s of the serial engine, when it has been compiled, and some 20 s. */
        const val LONG = 18_000_000L
        const val VERY_LONG = 130_000_000L
    }
}
