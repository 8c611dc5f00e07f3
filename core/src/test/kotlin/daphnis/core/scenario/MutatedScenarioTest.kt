package daphnis.core.scenario

import daphnis.core.Simulation
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.Draws
import daphnis.core.initial.SeededRandom
import daphnis.core.input.InputException
import daphnis.core.step.CollapseException
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTimeoutPreemptively
import org.junit.jupiter.api.Assertions.fail
import org.junit.jupiter.api.Test
import java.time.Duration

/** Mutated scenarios: each is refused in one line or runs. Never another exception, never a hang. */
class MutatedScenarioTest {
    private val values =
        """0 -1 1e308 -1e308 1e-308 NaN null true "x" [] {} [1,2,3] 2147483647 1e999 0.5 1 3 "" """
            .plus("9223372036854775807 [0.1,0.1,0.1]")
            .split(' ')
    private val keys =
        listOf("type", "count", "radius", "dt", "lengths", "sigma", "fillingFactor", "until", "bogus", "")

    @Test
    fun `mutants are refused in one line or run a few steps`() {
        var ran = 0
        for (seed in 1L..DRAWS) {
            val random = SeededRandom(seed)
            val name = BuiltIn.names[random.nextInt(BuiltIn.names.size)]
            // Small, so that the ones that do run are quick.
            var text = ScenarioJson.write(
                BuiltIn.scenario(
                    name,
                    listOf(if (name.startsWith("paper")) "particles.count=300" else "particles.count=150"),
                ),
            )
            repeat(1 + random.nextInt(2)) { text = mutate(text, random) }
            assertTimeoutPreemptively(Duration.ofSeconds(60), {
                if (survives(text)) ran++
            }) { "seed $seed hangs:\n$text" }
        }
        assertFalse(ran < DRAWS / 30) { "only $ran mutants ran: the mutations are too wild to test anything" }
    }

    private fun survives(text: String): Boolean {
        try {
            val setup = ScenarioSetup.of(ScenarioJson.parse(text, "mutant"), "mutant")
            if (setup.population.size > 20_000) return false
            Simulation(
                setup.population,
                setup.boundary,
                CollisionForcing(setup.restitution, setup.guard),
                setup.timeStep,
                setup.forces,
                sources = setup.sources,
            ).use { simulation ->
                repeat(2) { simulation.advance() }
            }
            return true
        } catch (e: InputException) {
            assertFalse('\n' in e.message.orEmpty()) { e.message }
            assertFalse(e.message.orEmpty().length > 1000) { e.message }
        } catch (e: CollapseException) {
            return false
        } catch (e: IllegalStateException) {
            // The state is no longer finite: a run says so in one line and ends with 1.
            return false
        } catch (e: IllegalArgumentException) {
            // A step too long for the box, found while running: likewise.
            assertFalse('\n' in e.message.orEmpty()) { e.message }
        } catch (e: Throwable) {
            fail<Unit>("$e for\n$text", e)
        }
        return false
    }

    private fun mutate(text: String, random: SeededRandom): String {
        val numbers = Regex("""-?\d+(\.\d+)?([eE]-?\d+)?|"[^"]*"""").findAll(text).toList()
        if (numbers.isEmpty()) return text
        val at = numbers[random.nextInt(numbers.size)].range
        return when (random.nextInt(8)) {
            0 -> text.removeRange(
                random.nextInt(text.length).let {
                    it..minOf(text.lastIndex, it + random.nextInt(20))
                },
            )
            1 -> text.replaceRange(at, "\"" + keys[random.nextInt(keys.size)] + "\"")
            2 -> text.substring(0, random.nextInt(text.length))
            3 -> text.replaceRange(
                random.nextInt(text.length).let {
                    it..it
                },
                listOf("{", "}", ",", "\"", ":", "\u0000", "/")[random.nextInt(7)],
            )
            4, 5, 6 -> text.replaceRange(at, listOf("0.5", "1", "3", "0.1", "20", "0.01", "7e-3")[random.nextInt(7)])
            else -> text.replaceRange(at, values[random.nextInt(values.size)])
        }
    }

    private companion object {
        val DRAWS = Draws.share(usual = 3000, long = 3000)
    }
}
