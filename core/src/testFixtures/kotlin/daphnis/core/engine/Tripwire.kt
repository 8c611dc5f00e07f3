package daphnis.core.engine

import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.TimeStep
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.PerSphereBoundary
import daphnis.core.collision.CollapseGuard
import daphnis.core.force.Drift
import daphnis.core.force.Force
import daphnis.core.force.Kick
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.surface.Restitution
import java.util.concurrent.atomic.AtomicInteger

/** Counts the calls of the functions that a user gives to a simulation, from any thread, and throws at one of them. */
class Tripwire {
    private val calls = AtomicInteger()

    @Volatile
    private var at = NEVER

    @Volatile
    private var counts: (String) -> Boolean = { true }

    @Volatile
    private var failure: Throwable? = null

    /** Where it has thrown since it was armed, or null. */
    @Volatile
    var tripped: String? = null
        private set

    /** From now on throws [failure] at call [at], counted from 0, of those at places that [counts] accepts. */
    fun arm(at: Int, failure: Throwable, counts: (String) -> Boolean) {
        calls.set(0)
        tripped = null
        this.counts = counts
        this.failure = failure
        this.at = at
    }

    fun disarm() {
        at = NEVER
        tripped = null
    }

    /** A call of the function that [place] names. */
    fun pass(place: String) {
        if (at == NEVER || !counts(place) || calls.getAndIncrement() != at) return
        tripped = place
        throw failure!!
    }

    private companion object {
        const val NEVER = -1
    }
}

/** [inner] with a wire before and behind each of its acts. */
open class WiredForce(private val inner: Force, private val wire: Tripwire) : Force by inner {
    private val name = inner.javaClass.simpleName

    override fun beforeDrift(population: Population, start: Double, duration: Double) {
        wire.pass("before $name.beforeDrift")
        inner.beforeDrift(population, start, duration)
        wire.pass("behind $name.beforeDrift")
    }

    override fun afterDrift(population: Population, end: Double, duration: Double) {
        wire.pass("before $name.afterDrift")
        inner.afterDrift(population, end, duration)
        wire.pass("behind $name.afterDrift")
    }
}

/** A [WiredForce] of a [Drift]. */
class WiredDrift(inner: Drift, wire: Tripwire) :
    WiredForce(inner, wire),
    Drift

/** A weak spring to the origin, in pieces of the engine's loop, with a wire within each piece. */
class WiredSpring(private val wire: Tripwire) : Kick {
    private var loop: RangeLoop = InlineLoop

    override fun useLoop(loop: RangeLoop) {
        this.loop = loop
    }

    override fun kick(population: Population, time: Double, duration: Double) {
        loop.run(population.size, PIECE) { _, from, to ->
            for (k in from until to) {
                if (k == (from + to) / 2) wire.pass("in a loop of a force")
                population.vx[k] -= STIFFNESS * duration * population.x[k]
                population.vz[k] -= STIFFNESS * duration * population.z[k]
            }
        }
    }

    private companion object {
        const val PIECE = 16
        const val STIFFNESS = 1e-3
    }
}

/** [inner] with a wire before and behind its act. */
class WiredBoundary(private val inner: BoundaryConditions, private val wire: Tripwire) : BoundaryConditions by inner {
    override fun endStep(population: Population, time: Double) {
        wire.pass("before endStep")
        inner.endStep(population, time)
        wire.pass("behind endStep")
    }
}

/** [inner] with a wire before and behind each piece. */
class WiredPieces(private val inner: PerSphereBoundary, private val wire: Tripwire) : PerSphereBoundary by inner {
    override fun endStep(population: Population, time: Double, from: Int, to: Int) {
        wire.pass("before a piece of endStep")
        inner.endStep(population, time, from, to)
        wire.pass("behind a piece of endStep")
    }
}

class WiredRestitution(private val inner: Restitution, private val wire: Tripwire) : Restitution {
    override fun coefficient(impactSpeed: Double): Double {
        wire.pass("restitution")
        return inner.coefficient(impactSpeed)
    }
}

class WiredGuard(private val inner: CollapseGuard, private val wire: Tripwire) : CollapseGuard by inner {
    override fun makesElastic(impactSpeed: Double, sinceFirst: Double, sinceSecond: Double): Boolean {
        wire.pass("guard")
        return inner.makesElastic(impactSpeed, sinceFirst, sinceSecond)
    }
}

class WiredTimeStep(private val inner: TimeStep, private val wire: Tripwire) : TimeStep {
    override fun next(population: Population): Double {
        wire.pass("time step")
        return inner.next(population)
    }
}

/** Notes what it sees, with a wire before. */
class WiredOutput(private val wire: Tripwire) : Output {
    /** Step, time and digest, in the order in which they were seen. */
    val seen = ArrayList<String>()

    override fun write(simulation: Simulation) {
        wire.pass("output")
        seen += "${simulation.step} ${simulation.time} ${stateDigest(simulation.population)}"
    }
}
