package daphnis.actors

import daphnis.core.engine.EnginesAgreeContract
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.BeforeEach

/** The engines of this module. One actor system is host to all of Pekko's, for a thousand starts take minutes. */
class EnginesAgreeTest private constructor(private val tested: TestedActors) : EnginesAgreeContract(tested) {
    constructor() : this(TestedActors())

    @BeforeEach
    fun `start a host`() {
        tested.host = FaultKit.actorSystem()
    }

    @AfterEach
    fun `end the host`() {
        tested.host!!.terminate()
    }
}
