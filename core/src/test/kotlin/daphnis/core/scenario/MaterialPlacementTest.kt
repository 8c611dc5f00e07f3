package daphnis.core.scenario

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.format.ExtendedXyz
import daphnis.core.format.LammpsDump
import daphnis.core.format.Snapshot
import daphnis.core.input.InputException
import daphnis.core.population.MaterialSums
import daphnis.core.population.Population
import daphnis.core.population.PopulationSums
import daphnis.core.randomSpheres
import daphnis.core.run.Program
import daphnis.core.run.Run
import daphnis.core.run.RunDirectory
import daphnis.core.run.RunOrigin
import daphnis.core.run.SeriesColumns
import daphnis.core.run.results
import daphnis.core.run.tableScenario
import daphnis.core.run.toStep
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.MaterialLaws
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** Materials of states from files and of runs. */
class MaterialPlacementTest {
    @TempDir
    lateinit var home: Path

    private fun three(): Population {
        val zero = DoubleArray(3)
        val one = DoubleArray(3) { 1.0 }
        return Population(doubleArrayOf(-3.0, 0.0, 3.0), zero, zero, one, zero.copyOf(), zero.copyOf(), one, one)
    }

    private fun write(p: Population): String = home.resolve("state.xyz").also { file ->
        Files.newBufferedWriter(file).use { ExtendedXyz.write(Snapshot.of(p, Open, 0, 0.0), it) }
    }.toString()

    private fun placed(path: String, vararg settings: String) = ScenarioSetup.of(
        ScenarioJson.parse(
            """{
              "box": { "lengths": [60, 60, 60] }, "boundary": { "type": "open" },
              "placement": { "type": "file", "path": "$path" },
              "restitution": { "type": "constant", "coefficient": 1 },
              "timeStep": { "type": "fixed", "dt": 0.01 }, "until": 1
            }""",
            "test",
            settings.toList(),
        ),
        "test",
    )

    private val made = three().withMaterial(intArrayOf(0, 1, 1), listOf("ice", "rock"))

    @Test
    fun `materials of a file are taken by name where the placement names them, and else dropped, which is said`() {
        val file = write(made)
        val same = placed(file, """placement.materials=["ice", "rock"]""")
        assertEquals(listOf(0.0, 1.0, 1.0), same.population.material.toList())
        assertTrue(same.notices.none { "material" in it }) { "${same.notices}" }
        val more = placed(file, """placement.materials=["iron", "rock", "ice"]""").population
        assertEquals(listOf(2.0, 1.0, 1.0), more.material.toList())
        assertEquals(listOf("iron", "rock", "ice"), more.materials)
        val dropped = placed(file)
        assertFalse(dropped.population.hasMaterials)
        assertTrue(dropped.notices.any { "has materials, ice, rock, which are dropped: placement.materials" in it })
        val e = assertThrows(InputException::class.java) { placed(file, """placement.materials=["ice", "iron"]""") }
        assertTrue("test: placement.materials: $file: particles of 'rock' are of none of the materials" in e.message!!)
    }

    @Test
    fun `a file without materials has the first, which is said where there are several`() {
        val file = write(three())
        val one = placed(file, """placement.materials=["ice"]""")
        assertEquals(listOf(0.0, 0.0, 0.0), one.population.material.toList())
        assertTrue(one.notices.none { "material" in it }) { "${one.notices}" }
        val two = placed(file, """placement.materials=["ice", "rock"]""")
        assertEquals(listOf(0.0, 0.0, 0.0), two.population.material.toList())
        assertTrue(
            two.notices.any {
                "does not say what spheres are made of but 'X': all are of the first material, ice" in it
            },
        )
    }

    @Test
    fun `a file of one other material is refused, and names that are numbers are no numbers`() {
        val rocks = three().withMaterial(IntArray(3), listOf("rock"))
        val e = assertThrows(InputException::class.java) { placed(write(rocks), """placement.materials=["ice"]""") }
        assertTrue("particles of 'rock' are of none of the materials ice" in e.message!!)
        val names = listOf("1", "0")
        val odd = three().withMaterial(intArrayOf(0, 1, 0), names)
        val dump = home.resolve("odd.lammpstrj")
        Files.newBufferedWriter(dump).use { LammpsDump.write(Snapshot.of(odd, Open, 0, 0.0), it) }
        for (file in listOf(write(odd), "$dump")) {
            val found = placed(file, """placement.materials=["1", "0"]""").population
            assertEquals(listOf(0.0, 1.0, 0.0), found.material.toList()) { file }
        }
    }

    @Test
    fun `types of LAMMPS are materials where these are named, and spins stay`() {
        val zero = DoubleArray(3)
        val file = home.resolve("a.lammpstrj")
        val spun = made.withSpin(doubleArrayOf(0.5, 0.0, 1.0), zero, zero)
        Files.newBufferedWriter(file).use { LammpsDump.write(Snapshot.of(spun, Open, 0, 0.0), it) }
        val p = placed("$file", """placement.materials=["a", "b"]""", """roughness={"type": "smooth"}""").population
        assertEquals(listOf(0.0, 1.0, 1.0), p.material.toList())
        assertEquals(listOf(0.5, 0.0, 1.0), p.wx.toList())
        val plain = placed("$file")
        assertFalse(plain.population.hasMaterials)
        assertTrue(plain.notices.none { "material" in it }) { "${plain.notices}" }
    }

    @Test
    fun `names in a placement are checked`() {
        val file = write(made)
        fun refused(names: String) = assertThrows(InputException::class.java) {
            placed(file, "placement.materials=$names")
        }.message.orEmpty()
        assertTrue("placement.materials: is empty" in refused("[]"))
        assertTrue(
            "placement.materials[1]: is 'ice', which another material is called" in refused("""["ice", "ice"]"""),
        )
        assertTrue("placement.materials[0]: is 'a b'; it must be a word" in refused("""["a b"]"""))
    }

    private fun mixture(vararg settings: String) = tableScenario(
        """particles={"count": 60, "materials": [
            {"name": "ice", "share": 0.5, "sizes": {"type": "equal", "radius": 0.5}},
            {"name": "rock", "share": 0.5, "sizes": {"type": "equal", "radius": 0.7}, "density": 3}]}""",
        """contacts=[{"between": ["ice", "rock"], "restitution": {"type": "constant", "coefficient": 0.3},
            "roughness": {"type": "constant", "coefficient": 0.5}}]""",
        *settings,
    )

    private fun first(name: String) = Run.open(home.resolve(name)).let { it.atStep(it.steps().first()) }

    @Test
    fun `a run that is ended and resumed, done again or started from a state has the same bits`() {
        val whole = Run.start(mixture(), "test", home.resolve("whole")).use { it.execute() }
        val broken = RunDirectory(home.resolve("broken"))
        Run.start(mixture(), "test", broken.path).toStep(8)
        Run.resume(broken.path).use { it.execute() }
        assertEquals(results(home.resolve("whole")), results(broken.path))
        val again = ScenarioJson.read(home.resolve("whole/scenario.json"))
        val second = Run.start(again, "again", home.resolve("again")).use { it.execute() }
        assertEquals(whole.stateDigest, second.stateDigest)
        val other = mixture("contacts[0].restitution.coefficient=0.9")
        assertTrue(
            whole.stateDigest != Run.start(other, "test", home.resolve("other")).use {
                it.execute()
            }.stateDigest,
        )
        val run = Run.open(home.resolve("whole"))
        val state = run.atStep(run.steps()[1])
        val from = Run.start(again, "test", home.resolve("from"), from = RunOrigin(run, state)).use { it.execute() }
        assertEquals(whole.stateDigest, from.stateDigest)
        assertEquals(listOf("ice", "rock"), first("from").materials)
        // And from that one, which has its materials from a file.
        val third = Run.open(home.resolve("from"))
        val written = ScenarioJson.read(home.resolve("from/scenario.json"))
        val origin = RunOrigin(third, third.atStep(third.steps()[1]))
        val last = Run.start(written, "test", home.resolve("third"), from = origin).use { it.execute() }
        assertEquals(whole.stateDigest, last.stateDigest)
    }

    @Test
    fun `a state of a run with materials may go on without any`() {
        Run.start(mixture(), "test", home.resolve("a")).toStep(8)
        val run = Run.open(home.resolve("a"))
        Run.start(tableScenario(), "test", home.resolve("b"), from = RunOrigin(run, run.last())).toStep(1)
        assertFalse(first("b").hasMaterials)
    }

    @Test
    fun `the series has a temperature for each material`() {
        Run.start(mixture(), "test", home.resolve("series")).use { it.execute() }
        val lines = Files.readAllLines(home.resolve("series/series.csv"))
        val heads = lines[0].split(',').map { it.substringBefore(' ') }
        assertEquals(listOf("ice", "rock").map { SeriesColumns.temperatureOf(it) }, heads.takeLast(2))
        val last = RunDirectory(home.resolve("series")).let { it.readSnapshot(it.snapshotSteps().last()) }.population()
        val flow = ScenarioSetup.of(mixture(), "test").boundary.meanFlow
        val sums = MaterialSums(last.materials, flow).also { it.take(last, PopulationSums(flow).apply { take(last) }) }
        val cells = lines.last().split(',').map { it.toDouble() }.takeLast(2)
        assertEquals(List(2) { sums.temperature(it) }, cells)
        assertTrue(cells.all { it > 0 })
        Run.start(tableScenario(), "test", home.resolve("plain")).toStep(1)
        assertFalse(",temperature_" in Files.readString(home.resolve("plain/series.csv")))
    }

    /** A gas of two materials, with a law between them, that no scenario describes. */
    private class Gas : Program {
        override val name = "gas"
        override val version = "1"
        override val until = 1.0
        override val output = OutputSpec(1, 4, 3)
        private val boundary = Periodic(Box.centred(7.0, 7.0, 7.0))

        override fun population(): Population =
            randomSpheres(40, boundary, 7, 1.0) { 0.5 }.withMaterial(IntArray(40) { it % 2 }, listOf("a", "b"))

        override fun simulation(population: Population): Simulation {
            val law = MaterialLaws(ConstantRestitution(0.9)).between(0, 1, ConstantRestitution(0.5))
            val forcing = CollisionForcing(law, recordCollisions = true)
            return Simulation(population, boundary, forcing, FixedTimeStep(0.1))
        }
    }

    @Test
    fun `a program's spheres keep their materials in its snapshots and at a resume`() {
        Run.start(Gas(), home.resolve("whole")).use { it.execute() }
        Run.start(Gas(), home.resolve("broken")).toStep(5)
        Run.resume(Gas(), home.resolve("broken")).use { it.execute() }
        assertEquals(results(home.resolve("whole")), results(home.resolve("broken")))
        assertTrue("temperature_b" in Files.readAllLines(home.resolve("broken/series.csv"))[0])
        assertEquals(listOf("a", "b"), Run.open(home.resolve("broken")).last().materials)
    }
}
