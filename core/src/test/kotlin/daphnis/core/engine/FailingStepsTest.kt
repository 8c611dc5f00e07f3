package daphnis.core.engine

/** The engines of this module, and steps without collisions. */
class FailingStepsTest : FailingStepsContract(CoreEngines) {
    override val engines get() = super.engines + (NO_ENGINE to { null }) + ("lists" to { CoreEngines.lists() })
}
