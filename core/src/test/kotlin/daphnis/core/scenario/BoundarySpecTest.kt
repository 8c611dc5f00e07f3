package daphnis.core.scenario

import daphnis.core.boundary.Box
import daphnis.core.boundary.everyBoundary
import daphnis.core.input.ValueCheck
import daphnis.core.orbit.OrbitalFrequencies
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.descriptors.PolymorphicKind
import kotlinx.serialization.descriptors.SerialDescriptor
import kotlinx.serialization.descriptors.elementDescriptors
import kotlinx.serialization.json.Json
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** A boundary that scenarios can name is under the contract of boundaries. */
@OptIn(ExperimentalSerializationApi::class)
class BoundarySpecTest {
    private val kinds: List<SerialDescriptor> = BoundarySpec.serializer().descriptor.let { sealed ->
        assertEquals(PolymorphicKind.SEALED, sealed.kind)
        sealed.getElementDescriptor(1).elementDescriptors.toList()
    }

    @Test
    fun `the contract of boundaries holds what every one of them makes`() {
        val contracted = everyBoundary().map { it.conditions.javaClass }.toSet()
        for (kind in kinds) {
            val needed = (0 until kind.elementsCount).filterNot { kind.isElementOptional(it) }
                .joinToString("") { ""","${kind.getElementName(it)}":0.25""" }
            val spec = Json.decodeFromString(BoundarySpec.serializer(), """{"type":"${kind.serialName}"$needed}""")
            val made = spec.conditions(
                Box.centred(4.0, 4.0, 4.0),
                OrbitalFrequencies(1.0),
                ValueCheck("test"),
                seed = 0,
            )
            assertTrue(made.javaClass in contracted) { "${kind.serialName}: $made is not in everyBoundary()" }
            assertTrue("$spec".startsWith(kind.serialName)) { "$spec" }
        }
    }
}
