package daphnis.core.engine

class EnginesCountTest : EnginesCountContract(CoreEngines)
