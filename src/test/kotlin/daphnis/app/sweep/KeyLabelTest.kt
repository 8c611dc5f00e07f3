package daphnis.app.sweep

import daphnis.core.input.UnitsSpec
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class KeyLabelTest {
    private val metric = KeyLabel(UnitsSpec(100.0, 1.0, 1.0))

    @Test
    fun `an axis has words and a unit in place of the path of a key`() {
        assertEquals("restitution: coefficient", metric.of("restitution.coefficient"))
        assertEquals("particles: optical depth", metric.of("particles.opticalDepth"))
        assertEquals("particles: surface density [kg/m²]", metric.of("particles.surfaceDensity"))
        assertEquals("forces[0]: x [m]", metric.of("forces[0].x"))
        assertEquals("box: lengths[2] [m]", metric.of("box.lengths[2]"))
        assertEquals("boundary: shear rate [1/s]", metric.of("boundary.shearRate"))
    }

    @Test
    fun `a key that has its unit in its name keeps it, whatever the units of the scenario`() {
        for (label in listOf(metric, KeyLabel(UnitsSpec()), KeyLabel(null))) {
            assertEquals("frame: distance [km]", label.of("frame.distanceInKm"))
            assertEquals("until [orbits]", label.of("untilOrbits"))
            assertEquals("restitution: critical speed [cm/s]", label.of("restitution.criticalSpeed"))
            assertEquals("restitution: speed [cm/s]", label.of("restitution.speed"))
        }
        assertEquals("time step: dt [units of time]", KeyLabel(UnitsSpec()).of("timeStep.dt"))
    }

    @Test
    fun `sigma is a speed of velocities, and a pure number of sizes`() {
        assertEquals("velocities: sigma [m/s]", metric.of("velocities.sigma"))
        assertEquals("particles.sizes: sigma", metric.of("particles.sizes.sigma"))
        assertEquals("guard: speed [m/s]", metric.of("guard.speed"))
        assertEquals("spins: sigma [1/s]", metric.of("spins.sigma"))
        assertEquals("restitution: radius [m]", metric.of("restitution.radius"))
    }

    @Test
    fun `the temperature of spins is an energy, that of velocities a speed squared`() {
        assertEquals("spins: temperature [J]", metric.of("spins.temperature"))
    }
}
