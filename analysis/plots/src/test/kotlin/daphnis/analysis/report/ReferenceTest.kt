package daphnis.analysis.report

import daphnis.analysis.insitu.State
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.cbrt

/** A number from elsewhere stands beside one of a run only where everything that decides it is the same. */
class ReferenceTest {
    @Test
    fun `a ring patch has references as shipped, and none when any one thing is another`() {
        assertEquals(9, patch().size)
        assertEquals(9, patch("guard={\"type\":\"none\"}").size)
        val others = listOf(
            "frame.verticalFactor=3.6",
            "frame.distanceInKm=120000",
            "restitution.prefactor=0.32",
            "restitution.exponent=-0.2",
            "restitution={\"type\":\"constant\",\"coefficient\":0.5}",
            "restitution={\"type\":\"borderies\",\"criticalSpeed\":0.1}",
            "restitution={\"type\":\"step\",\"speed\":0.1,\"coefficient\":0.5}",
            "restitution={\"type\":\"table\",\"points\":[[0.1,0.5]]}",
            "restitution={\"type\":\"viscoelastic\",\"speed\":0.1,\"coefficient\":0.5}",
            "guard={\"type\":\"contact-duration\",\"duration\":100}",
            "roughness={\"type\":\"constant\",\"coefficient\":0}",
            "guard={\"type\":\"floor-speed\",\"relative\":0.1}",
            "guard={\"type\":\"floor-speed\",\"speed\":1e-4}",
            "boundary.radiallyOpen=true",
            "particles.opticalDepth=0.52",
            "particles.sizes={\"type\":\"list\",\"radii\":[1.4,1.56]}",
            "particles.sizes.radius=1.5",
            "forces=[{\"type\":\"self-gravity\"}]",
            "forces=[{\"type\":\"satellite\",\"massRatio\":1e-12,\"x\":5000,\"y\":0}]",
            "bodies=[{\"radius\":5,\"density\":900,\"position\":[0,0,0]}]",
        )
        for (other in others) assertEquals(emptyMap<String, Reference>(), patch(other)) { other }
    }

    @Test
    fun `a sheared box and an elastic gas have references only where they are the ones that are known`() {
        assertEquals(3, sheared().size)
        for (
        other in listOf(
            "restitution.coefficient=0.85",
            "restitution={\"type\":\"table\",\"points\":[[0,0.9]]}",
            "guard={\"type\":\"floor-speed\",\"relative\":0.5}",
            "forces=[{\"type\":\"uniform-acceleration\",\"acceleration\":[0,0,-1]}]",
            "particles.sizes={\"type\":\"list\",\"radii\":[0.4,0.5]}",
            "roughness={\"type\":\"constant\",\"coefficient\":0}",
        )
        ) {
            assertEquals(emptyMap<String, Reference>(), sheared(other)) { other }
        }
        assertEquals(5, elastic().size)
        assertEquals(5, elastic("roughness={\"type\":\"smooth\"}").size)
        for (
        other in listOf(
            "restitution.coefficient=0.99",
            "restitution={\"type\":\"viscoelastic\",\"speed\":1,\"coefficient\":1}",
            "boundary={\"type\":\"walls\"}",
            "forces=[{\"type\":\"uniform-acceleration\",\"acceleration\":[0,0,-1]}]",
            "roughness={\"type\":\"constant\",\"coefficient\":0}",
        )
        ) {
            assertEquals(emptyMap<String, Reference>(), elastic(other)) { other }
        }
    }

    @Test
    fun `spheres of two sizes have the pressure of a mixture, which is that of one size where both are nearly equal`() {
        val near = elastic("particles.sizes={\"type\":\"list\",\"radii\":[0.49999,0.5]}")
        assertEquals(setOf("compressibility", "collisions_per_particle"), near.keys)
        for ((key, reference) in near) {
            assertTrue("BMCSL" in reference.source)
            assertEquals(elastic().getValue(key).value, reference.value, 2e-3 * reference.value) { key }
        }
        val mixed = elastic("particles.sizes={\"type\":\"list\",\"radii\":[0.25,0.5]}")
        // n = 0.191: φ = 0.05625 of d = 1 and 1/2 in equal numbers.
        assertEquals(1.228, mixed.getValue("compressibility").value, 2e-3)
    }

    @Test
    fun `a crystal has its own pressure, between the two phases there is none`() {
        fun lattice(edge: Double) = elastic(
            "placement={\"type\":\"lattice\",\"lattice\":\"fcc\"}",
            "particles.count=500",
            "box.lengths=[$edge,$edge,$edge]",
        )
        val crystal = lattice(cbrt(500 * PI / 6 / 0.5433))
        // 11.148 of very many, less a 500th.
        assertEquals(11.1257, crystal.getValue("compressibility").value, 1e-3)
        assertEquals(0.0111, crystal.getValue("compressibility").bound, 1e-4)
        assertTrue("Speedy" in crystal.getValue("collisions_per_particle").source)
        assertEquals(emptyMap<String, Reference>(), lattice(cbrt(500 * PI / 6 / 0.52)))
        val fluid = lattice(10.0)
        assertEquals(3.26737, fluid.getValue("compressibility").value, 2e-5)
        assertTrue(fluid.getValue("compressibility").bound in 1e-4..1e-3)
    }

    @Test
    fun `a difference is in errors of the run, beside the bound of the reference, and none without an error`() {
        val reference = Reference(10.0, 0.9, "there")
        fun page(value: Double, error: Double) =
            ReportPage("t").apply { numbers(listOf(NumberRow("c", value, error, "m", reference))) }.html("")
        val within = page(9.0, 0.2)
        assertTrue("10.00, good to 0.90" in within && "−10.0 % (−5.0 σ, within bounds)" in within) { within }
        assertTrue("−20.0 % (−10.0 σ, beyond)" in page(8.0, 0.2))
        assertTrue("−10.0 % (beyond)" in page(9.0, 0.0))
        assertTrue("10.0 %" !in page(9.0, Double.NaN)) { "a number without an error may differ by chance" }
    }

    internal companion object {
        private fun of(
            name: String,
            settings: Array<out String>,
            use: (ScenarioSetup, State) -> Map<String, Reference>,
        ) = ScenarioSetup.of(BuiltIn.scenario(name, settings.asList()), name).let { setup ->
            use(setup, State(setup.population, setup.boundary, 0.0, setup.frequencies))
        }

        /** References of `ring-patch`, with [settings], as the directory of a run has it: all is resolved. */
        fun patch(vararg settings: String) = of("ring-patch", settings) { setup, state ->
            val p = state.population
            val depth = p.radius.filterIndexed { k, _ -> p.radius[k] < 4 }.sumOf { PI * it * it } / state.area
            References.ofPatch(written(setup), state, setup.frequencies!!, depth)
        }

        /** References of `shear-cell`. */
        fun sheared(vararg settings: String) = of("shear-cell", settings) { setup, state ->
            References.ofShear(written(setup), state, filling(state))
        }

        /** References of `elastic-gas`. */
        fun elastic(vararg settings: String) = of("elastic-gas", settings) { setup, state ->
            val density = state.population.size / state.boundary.box.volume
            ElasticReferences.of(written(setup), state, filling(state), 1.0, density)
        }

        private fun written(setup: ScenarioSetup) =
            ScenarioJson.parse(ScenarioJson.write(setup.scenario), "scenario.json")

        private fun filling(state: State) =
            state.population.radius.sumOf { 4.0 / 3 * PI * it * it * it } / state.boundary.box.volume
    }
}
