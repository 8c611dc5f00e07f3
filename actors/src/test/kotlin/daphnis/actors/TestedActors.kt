package daphnis.actors

import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.pekko.PekkoEngine
import daphnis.actors.region.RegionLayout
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EngineSettings
import daphnis.core.engine.TestedEngines
import org.apache.pekko.actor.typed.ActorSystem

/** The engines of this module, with every division of space, and with a host where there is one. */
internal class TestedActors : TestedEngines(ActorEngines) {
    /** What Pekko's engine works in; null for a system of its own. */
    var host: ActorSystem<Void>? = null

    override fun make(name: String, settings: EngineSettings): CollisionEngine = when (name) {
        "actors" -> RegionActorEngine(settings.threads(), layout(settings)).also {
            it.fewest = fewest(settings)
            it.tuning = tuning(settings)
        }
        "pekko" -> pekko(settings.threads(), layout(settings)).also {
            it.fewest = fewest(settings)
            it.tuning = tuning(settings)
        }
        else -> super.make(name, settings)
    }

    private fun pekko(threads: Int, layout: RegionLayout) =
        host?.let { PekkoEngine(threads, layout, it) } ?: PekkoEngine(threads, layout)

    /** Epochs in all steps, in none, or as users have them. */
    private fun fewest(settings: EngineSettings): Int = listOf(0, Int.MAX_VALUE, 256)[settings.random.nextInt(3)]

    private fun layout(settings: EngineSettings): RegionLayout {
        val random = settings.random
        return when (random.nextInt(3)) {
            0 -> RegionLayout.Stretches(1 + random.nextInt(12))
            1 -> RegionLayout.Stretches(PRIMES[random.nextInt(PRIMES.size)])
            else -> RegionLayout.Blocks(1 + random.nextInt(4), 1 + random.nextInt(4), 1 + random.nextInt(3))
        }
    }

    private companion object {
        val PRIMES = intArrayOf(13, 17, 31)
    }
}
