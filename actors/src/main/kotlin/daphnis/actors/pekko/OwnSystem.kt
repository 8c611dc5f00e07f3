package daphnis.actors.pekko

import com.typesafe.config.ConfigFactory
import daphnis.actors.region.onFreshThread
import org.apache.pekko.actor.typed.ActorSystem
import org.apache.pekko.actor.typed.DispatcherSelector
import org.apache.pekko.actor.typed.javadsl.Behaviors
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/**
 * An actor system with [threads] threads, started when it is first needed, and again when the last one has ended. From
 * any thread.
 */
internal class OwnSystem(private val threads: Int) {
    private var system: ActorSystem<Void>? = null
    private var isEnded = false

    /** The system. Starting it blocks for some hundred milliseconds, and no interrupt of the caller ends that wait. */
    @Synchronized
    fun get(): ActorSystem<Void> {
        check(!isEnded) { "the engine is closed" }
        system?.let { if (!it.whenTerminated().isCompleted) return it }
        return onFreshThread(::start).also { system = it }
    }

    /** Runs [task] on the system's default dispatcher. */
    fun execute(task: Runnable) {
        get().dispatchers().lookup(DispatcherSelector.defaultDispatcher()).execute(task)
    }

    /** Ends the system for good, without waiting for it. */
    @Synchronized
    fun end() {
        isEnded = true
        val ending = system ?: return
        system = null
        val thread = Thread({ terminate(ending) }, "daphnis-end").apply { isDaemon = true }
        try {
            thread.start()
        } catch (e: Throwable) {
            // No thread or no memory is available: telling it once must suffice.
            ending.terminate()
        }
    }

    /**
     * An interrupt of this thread or of the system's threads can lose the message that ends the system, so it is sent
     * until the system has ended.
     */
    private fun terminate(ending: ActorSystem<Void>) {
        repeat(MOST_TRIES) {
            try {
                ending.terminate()
                ending.getWhenTerminated().toCompletableFuture().get(PAUSE_MILLIS, TimeUnit.MILLISECONDS)
                return
            } catch (e: TimeoutException) {
                // Try again.
            } catch (e: InterruptedException) {
                // Try again.
            }
        }
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
                // With it on, only the first call of terminate() would do anything.
                "pekko.coordinated-shutdown.run-by-actor-system-terminate" to "off",
                "pekko.actor.default-dispatcher.executor" to "thread-pool-executor",
                "pekko.actor.default-dispatcher.thread-pool-executor.fixed-pool-size" to threads,
                "pekko.actor.default-dispatcher.throughput" to 1,
                // A system that was interrupted while it ended may not shut its executors down; their threads must not
                // stay for long.
                "pekko.actor.default-dispatcher.thread-pool-executor.keep-alive-time" to KEEP_ALIVE,
                "pekko.actor.internal-dispatcher.executor" to "thread-pool-executor",
                "pekko.actor.internal-dispatcher.thread-pool-executor.fixed-pool-size" to 2,
                "pekko.actor.internal-dispatcher.thread-pool-executor.keep-alive-time" to KEEP_ALIVE,
            ),
        ).withFallback(ConfigFactory.load(PekkoEngine::class.java.classLoader)),
    )

    private companion object {
        const val MOST_TRIES = 100
        const val PAUSE_MILLIS = 500L
        const val KEEP_ALIVE = "2s"
    }
}
