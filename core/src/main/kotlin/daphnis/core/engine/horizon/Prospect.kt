package daphnis.core.engine.horizon

import daphnis.core.step.CollisionStep
import java.util.concurrent.atomic.AtomicLong
import kotlin.math.sqrt

/**
 * Whether so much work is to come that it pays to have the JVM compile epochs, and what threads share. That takes it
 * seconds, in which the serial engine has ended a short run.
 *
 * Work is counted in spheres that the serial engine carries through a step; a collision is worth several. What has been
 * done in this JVM counts like what is to come: the sum is the same in each step of a run, and of many short runs the
 * later ones are long. Once a run is long, it remains so.
 *
 * @param done that work
 */
internal class Prospect(private val done: AtomicLong = IN_THIS_JVM) {
    private var collisions = 0L

    /** Whether epochs pay. */
    var isLong = false
        private set

    /** Whether two threads pay, of which one would otherwise be left to the compilers. */
    var isVeryLong = false
        private set

    /** Told of each [step] before it is taken. */
    fun look(step: CollisionStep) {
        if (isVeryLong) return
        val work = done.get() + (step.toCome.toDouble() + 1) * worth(step)
        isVeryLong = work >= VERY_LONG
        isLong = isLong || work >= LONG || isFar(step)
    }

    /** Told of each [step] that has been taken, with so many [collisions]. */
    fun passed(step: CollisionStep, collisions: Long) {
        this.collisions = collisions
        done.addAndGet(worth(step))
    }

    private fun worth(step: CollisionStep) = step.population.size + COLLISION * collisions

    /** Whether spheres fly so far in [step] that the serial engine's search for what they meet is long. */
    private fun isFar(step: CollisionStep): Boolean {
        val p = step.population
        var fastest = 0.0
        var radii = 0.0
        for (i in 0 until p.size) {
            fastest = maxOf(fastest, p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i] + p.vz[i] * p.vz[i])
            radii += p.radius[i]
        }
        return sqrt(fastest) * step.duration * p.size > FAR * radii
    }

    internal companion object {
        /** A test that is of epochs in a short run says that much has been done. */
        val IN_THIS_JVM = AtomicLong(java.lang.Long.getLong("daphnis.workDone", 0))

        /** 2 µs for a collision, .15 µs for a sphere. */
        private const val COLLISION = 13

        /** In radii. */
        private const val FAR = 8.0

        /** Some 3 s of the serial engine, when it has been compiled, and some 20 s. */
        const val LONG = 18_000_000L
        const val VERY_LONG = 130_000_000L
    }
}
