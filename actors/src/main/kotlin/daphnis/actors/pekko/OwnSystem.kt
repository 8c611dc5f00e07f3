package daphnis.actors.pekko

import com.typesafe.config.ConfigFactory
import daphnis.actors.region.onFreshThread
import org.apache.pekko.actor.typed.ActorSystem
import org.apache.pekko.actor.typed.DispatcherSelector
import org.apache.pekko.actor.typed.javadsl.Behaviors

/**
 * An actor system with [threads] threads, started when it is first wanted, and anew when the last one has ended. From
 * any thread.
 */
internal class OwnSystem(private val threads: Int) {
    private var system: ActorSystem<Void>? = null
    private var isEnded = false

    /** The system. Starting it blocks for some hundred milliseconds, which no interrupt of the caller breaks off. */
    @Synchronized
    fun get(): ActorSystem<Void> {
        check(!isEnded) { "the engine is closed" }
        system?.let { if (!it.whenTerminated().isCompleted) return it }
        return onFreshThread(::start).also { system = it }
    }

    /** Does [task] on the system's default dispatcher. */
    fun execute(task: Runnable) {
        get().dispatchers().lookup(DispatcherSelector.defaultDispatcher()).execute(task)
    }

    /** Ends the system for good, without waiting for it. */
    @Synchronized
    fun end() {
        isEnded = true
        system?.terminate()
        system = null
    }

    private fun start(): ActorSystem<Void> = ActorSystem.create(
        Behaviors.empty<Void>(),
        "daphnis",
        ConfigFactory.parseMap(
            mapOf(
                "pekko.loglevel" to "WARNING",
                "pekko.stdout-loglevel" to "WARNING",
                "pekko.daemonic" to "on",
                "pekko.jvm-exit-on-fatal-error" to "off",
                "pekko.coordinated-shutdown.run-by-jvm-shutdown-hook" to "off",
                "pekko.actor.default-dispatcher.executor" to "thread-pool-executor",
                "pekko.actor.default-dispatcher.thread-pool-executor.fixed-pool-size" to threads,
                "pekko.actor.default-dispatcher.throughput" to 1,
            ),
        ).withFallback(ConfigFactory.load(PekkoEngine::class.java.classLoader)),
    )
}
