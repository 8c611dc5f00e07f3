package daphnis.actors

import daphnis.core.engine.EnginesCountContract

class EnginesCountTest : EnginesCountContract(TestedActors())
