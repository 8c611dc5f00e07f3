package daphnis.bench

import daphnis.core.population.stateDigest

/** One who takes turns: [steps] steps of [dt] from [start]. [engine] makes one. */
internal class Runner(val start: StartState, val engine: EngineName, val threads: Int, val dt: Double, val steps: Int) {
    /** Of the fastest turn, after a first step in which arrays get their size. */
    var seconds: Double = Double.POSITIVE_INFINITY
        private set

    /** In the steps that are timed. */
    var collisions: Long = 0
        private set

    val perStep: Double get() = seconds / steps
    val perParticle: Double get() = perStep / start.size

    /** NaN when there was none. */
    val perCollision: Double get() = if (collisions == 0L) Double.NaN else seconds / collisions

    /** @return the digest of the state at the end */
    fun turn(isKept: Boolean): String = start.simulation(engine.create(threads), dt).use { simulation ->
        simulation.advance()
        val counters = simulation.collisions!!.counters
        val before = counters.collisions
        val begin = System.nanoTime()
        repeat(steps) { simulation.advance() }
        val time = (System.nanoTime() - begin) * 1e-9
        if (isKept) seconds = minOf(seconds, time)
        collisions = counters.collisions - before
        stateDigest(simulation.population)
    }
}

/**
 * All [runners] in turn, round after round; the first round warms up. Those with the same start, steps and step must
 * end in the same state.
 */
internal fun takeTurns(runners: List<Runner>, rounds: Int) {
    for (round in 0..rounds) {
        val ends = HashMap<List<Any>, String>()
        for (runner in runners) {
            val end = runner.turn(isKept = round > 0)
            val other = ends.putIfAbsent(listOf(runner.start, runner.dt, runner.steps), end) ?: end
            check(other == end) { "${runner.engine} on ${runner.threads} disagrees with those before it" }
        }
    }
}
