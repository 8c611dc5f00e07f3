package daphnis.cluster.system

import daphnis.cluster.desk.Mails
import daphnis.cluster.link.LinkMessage
import org.apache.pekko.actor.typed.Behavior
import org.apache.pekko.actor.typed.javadsl.Behaviors
import java.time.Duration

/** An actor that puts what has come over the links into the mails. */
internal object PostBehavior {
    private object Tick

    /** @param isTimer whether this one also sends anew what has waited too long */
    fun create(mails: Mails, isTimer: Boolean): Behavior<Any> = Behaviors.withTimers { timers ->
        if (isTimer) timers.startTimerWithFixedDelay(Tick, TICK)
        Behaviors.receive(Any::class.java)
            .onMessage(LinkMessage::class.java) {
                mails.accept(it)
                Behaviors.same()
            }
            .onMessageEquals(Tick) {
                mails.tick()
                Behaviors.same()
            }
            .onAnyMessage { Behaviors.same() }
            .build()
    }

    private val TICK = Duration.ofMillis(25)
}
