package daphnis.actors

import daphnis.core.engine.FailingStepsContract

class FailingStepsTest : FailingStepsContract(TestedActors())
