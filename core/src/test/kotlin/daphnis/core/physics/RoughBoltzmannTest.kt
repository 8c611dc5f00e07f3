package daphnis.core.physics

import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

/** The ratios to which [RoughGasTest] is held, from Boltzmann's equation. */
@Tag("physics")
class RoughBoltzmannTest {
    private val count = if (fullPhysics) 50_000 else 4000
    private val each = if (fullPhysics) 1000 else 80
    private val bound = if (fullPhysics) 0.004 else 0.04

    @Test
    fun `ratios of temperatures of rough gases that cool`() {
        for (target in RoughBoltzmann.COOLING) {
            // Spins with β < 0 need 150 collisions to forget that they were drawn as Gaussians: the ratio is 1.327 after
            // 20, and 1.30 after 60.
            val from = if (target.beta < 0) 150 else 20
            val gas = RoughBoltzmann(count, target.alpha, target.beta, target.ratio, 1)
            repeat(from) { gas.cool(1.0) }
            val ratio = (1..each).sumOf {
                gas.cool(1.0)
                gas.ratio
            } / each
            assertPhysics("T_rot/T_tr, α = ${target.alpha}, β = ${target.beta}, Boltzmann", target.ratio, ratio, bound)
        }
    }

    @Tag("thorough")
    @Test
    fun `ratios of energies of rough gases that are driven`() {
        for (target in RoughBoltzmann.DRIVEN) {
            val gas = RoughBoltzmann(count, target.alpha, target.beta, target.ratio, 1)
            repeat(40) { gas.drive(1.0) }
            val ratio = (1..each).sumOf {
                gas.drive(1.0)
                gas.ratio
            } / each
            assertPhysics("E_rot/E_kin, driven, β = ${target.beta}, Boltzmann", target.ratio, ratio, bound)
        }
    }
}
