package daphnis.actors

import daphnis.actors.coroutine.RegionActorEngine
import daphnis.actors.pekko.PekkoEngine
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.EngineSettings
import daphnis.core.engine.TestedEngines
import org.apache.pekko.actor.typed.ActorSystem

/** The engines of this module, with any number of regions, and with a host where there is one. */
internal class TestedActors : TestedEngines(ActorEngines) {
    /** What Pekko's engine works in; null for a system of its own. */
    var host: ActorSystem<Void>? = null

    override fun make(name: String, settings: EngineSettings): CollisionEngine = when (name) {
        "actors" -> RegionActorEngine(settings.threads(), regions(settings)).also {
            it.fewest = fewest(settings)
            it.tuning = tuning(settings)
        }
        "pekko" -> pekko(settings.threads(), regions(settings)).also {
            it.fewest = fewest(settings)
            it.tuning = tuning(settings)
        }
        else -> super.make(name, settings)
    }

    private fun pekko(threads: Int, regions: Int) =
        host?.let { PekkoEngine(threads, regions, it) } ?: PekkoEngine(threads, regions)

    /** Epochs in all steps, in none, or as users have them. */
    private fun fewest(settings: EngineSettings): Int = listOf(0, Int.MAX_VALUE, 256)[settings.random.nextInt(3)]

    private fun regions(settings: EngineSettings): Int {
        val random = settings.random
        return if (random.nextInt(2) == 0) random.nextInt(13) else PRIMES[random.nextInt(PRIMES.size)]
    }

    private companion object {
        val PRIMES = intArrayOf(13, 17, 31)
    }
}
