package daphnis.actors

import daphnis.core.engine.EnginesAgreeContract
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.BeforeEach

private val tested = TestedActors()

/** The engines of this module. One actor system is host to all of Pekko's, since a start takes long. */
class EnginesAgreeTest : EnginesAgreeContract(tested) {
    @BeforeEach
    fun `start a host`() {
        tested.host = FaultKit.actorSystem()
    }

    @AfterEach
    fun `end the host`() {
        tested.host!!.terminate()
        tested.host = null
    }
}
