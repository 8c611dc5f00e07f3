package daphnis.core.engine

import daphnis.core.Engines
import daphnis.core.cluster.FleetEngines
import daphnis.core.cluster.ThreadFleet
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class EngineFactoryTest {
    private val none = object : EngineFactory {
        override val names: List<String> get() = listOf("none")

        override fun create(name: String, threads: Int): CollisionEngine? = null
    }

    @Test
    fun `one engine is the specification, on one thread whatever is asked, and whoever is asked`() {
        for (factory in listOf(Engines, CombinedEngines(none, Engines))) {
            val name = factory.names.single(factory::isSpecification)
            factory.create(name, 3)!!.use {
                assertEquals(1, it.threads)
                assertEquals(name, it.name)
            }
            assertFalse(factory.isSpecification("none"))
        }
    }

    @Test
    fun `who asks for an engine that is gone is told what to take`() {
        val engines = CombinedEngines(none, Engines)
        for (name in listOf("bricks", "islands")) {
            assertNull(engines.create(name, 1))
            val message = assertThrows(IllegalArgumentException::class.java) {
                CollisionForcing.builder { 1.0 }.engine(name, 1, engines)
            }.message!!
            assertTrue("it is gone; take horizon" in message) { message }
        }
        assertNull(engines.successor("snail"))
    }

    @Test
    fun `nodes are no engine`() {
        ThreadFleet(1).use { fleet ->
            val engines = FleetEngines(fleet)
            assertEquals(emptyList<String>(), engines.names)
            for (name in Engines.names + "cluster") assertNull(engines.create(name, 0))
        }
    }
}
