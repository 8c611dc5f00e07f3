package daphnis.drills

import daphnis.app.allEngines
import daphnis.app.daphnis
import daphnis.core.Simulation
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.SeededRandom
import daphnis.core.run.engineOf
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.step.CollapseException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import java.nio.file.Files
import java.nio.file.Path

/**
 * Mutated scenarios, each read, set up, described and advanced by two steps: it works, or is refused in one line, or
 * its simulation ends in one line; soon.
 *
 * @param cases how many
 * @param seed of the mutations; a case is known by seed and number
 * @param home a directory for the scenarios; those with faults stay there
 */
internal fun scenarioFuzz(cases: Int, seed: Long, home: Path): FuzzCounts {
    val seeds = scenarioSeeds()
    return Fuzz(cases, seed).run { number, counts ->
        val random = SeededRandom(seed * 1_000_003 + number)
        val file = home.resolve("$seed-$number.json")
        Files.write(file, ScenarioMutation(random, seeds).text(seeds[random.nextInt(seeds.size)]))
        val before = counts.faults.size
        if (counts.count(daphnis("describe", "$file"), file)) twoSteps(file, counts)
        if (counts.faults.size == before) Files.delete(file)
    }
}

/** The built-in scenarios with few particles, and others whose keys these have not. */
internal fun scenarioSeeds(): List<JsonObject> {
    val small = BuiltIn.names.map { name ->
        val given = BuiltIn.scenario(name)
        val few = if (given.particles == null) {
            emptyList()
        } else {
            listOf("""particles={"count":60,"sizes":{"type":"equal","radius":${radius(name)}}}""")
        }
        ScenarioJson.write(
            BuiltIn.scenario(name, few + "engine.threads=${if (given.engine.name == "serial") 1 else 2}"),
        )
    }
    val golden = GOLDEN.map { name ->
        val text = checkNotNull(Fuzz::class.java.getResource("/golden/$name.json")) { name }.readText()
        ScenarioJson.write(ScenarioJson.parse(text, name))
    }
    return (small + golden + ODD).map { Json.parseToJsonElement(it).jsonObject }
}

/** A radius of which 60 fit. */
private fun radius(name: String): Double = BuiltIn.scenario(name).let { scenario ->
    val lengths = scenario.box.lengths
    scenario.space.edge(lengths.reduce(Double::times) / 60 * 0.02).coerceAtMost(lengths.min() / 4)
}

private fun twoSteps(file: Path, counts: FuzzCounts) {
    try {
        val scenario = ScenarioJson.read(file)
        val setup = ScenarioSetup.of(scenario, "$file")
        if (setup.population.size > MOST_ADVANCED) {
            counts.worked++
            return
        }
        val forcing =
            CollisionForcing(
                setup.restitution,
                setup.guard,
                engineOf(scenario, "$file", allEngines),
                search = setup.scenario.search,
            )
        Simulation(
            setup.population,
            setup.boundary,
            forcing,
            setup.timeStep,
            setup.forces,
            startTime = scenario.startTime,
            sources = setup.sources,
        ).use { simulation ->
            repeat(2) { simulation.advance() }
        }
        counts.worked++
    } catch (e: CollapseException) {
        oneLine(file, e, counts)
    } catch (e: IllegalStateException) {
        oneLine(file, e, counts)
    } catch (e: IllegalArgumentException) {
        oneLine(file, e, counts)
    }
}

/** Of these a run makes one line. */
private fun oneLine(file: Path, e: RuntimeException, counts: FuzzCounts) {
    if (e.message != null && '\n' !in e.message.orEmpty()) {
        counts.failed++
    } else {
        counts.faults += "$file: ${e.stackTraceToString()}"
    }
}

private const val MOST_ADVANCED = 20_000

private val GOLDEN = listOf(
    "big-among-small", "lees-edwards-sizes", "moonlet-small", "moons", "open-clump", "periodic-thin", "ring-gravity",
    "ring-mesh", "ring-waves", "ringlet-moon", "sheared-dense", "walls-gravity", "walls-lattice",
)

private val ODD = listOf(
    """{"name":"walls","box":{"lengths":[10,6,4]},"boundary":{"type":"walls","axes":"xz","restitution":0.5},
        "particles":{"fillingFactor":0.1,"sizes":{"type":"power-law","minimum":0.1,"maximum":0.5,"exponent":3},
        "density":2},
        "velocities":{"type":"uniform","halfWidth":1,"zeroMomentum":false},"restitution":{"type":"borderies",
        "criticalSpeed":0.1},
        "forces":[{"type":"uniform-acceleration","acceleration":[0,0,-1]},{"type":"self-gravity","constant":1,
        "openingAngle":0.5,"images":1,"softening":0.1}],
        "timeStep":{"type":"cell-crossing","longest":0.1,"fraction":0.5},"until":1,"search":"tree",
        "engine":{"name":"serial","threads":1}}""",
    """{"name":"lattice","box":{"lengths":[8,8,8]},"boundary":{"type":"lees-edwards","shearRate":1},
        "particles":{"count":9,"sizes":{"type":"log-normal","median":0.3,"sigma":0.2,"minimum":0.1,"maximum":0.5}},
        "placement":{"type":"lattice","lattice":"cubic"},
        "velocities":{"type":"gaussian","temperature":1,"exact":true,"shearProfile":true},
        "restitution":{"type":"bridges","prefactor":0.3,"exponent":-0.2},
        "guard":{"type":"contact-duration","duration":0.001},"timeStep":{"type":"fixed","dt":0.01},"until":1,
        "engine":{"name":"thread-pool","threads":2}}""",
    """{"name":"moons","units":{"lengthInMetres":1,"speedInCmPerSecond":1,"massInKg":1},"frame":{"type":"hill",
    "distanceInKm":100000,"planet":"saturn","verticalFactor":3.6},
        "box":{"lengths":[20,20,10]},"boundary":{"type":"hill-sheet","radiallyOpen":false},
        "particles":{"opticalDepth":0.3,"sizes":{"type":"list","radii":[0.2,0.5]}},"bodies":[{"radius":1,
        "position":[0,0,0],"density":0.5,"velocity":[0,0,0]}],
        "velocities":{"type":"gaussian","sigma":0.1,"shearProfile":true},"restitution":{"type":"constant",
        "coefficient":0.5},"guard":{"type":"floor-speed","relative":1e-5},
        "forces":[{"type":"body-gravity","constant":1,"softening":0.1},{"type":"satellite","massRatio":1e-18,"x":50,
        "y":-10,"e":1,"phase":0,"softening":0.1,"radius":1}],
        "timeStep":{"type":"orbit-fraction","steps":1000},"untilOrbits":0.01,"engine":{"name":"actors","threads":2},
        "output":{"seriesEvery":1,"snapshotEvery":1,"checkpointEvery":1,"collisionLog":true,"transportEvery":1}}""",
    """{"name":"open","box":{"lengths":[10,10,10]},"boundary":{"type":"open"},"particles":{"surfaceDensity":0.3,
    "sizes":{"type":"equal","radius":0.3},"mass":1},
        "velocities":{"type":"rest"},"restitution":{"type":"constant","coefficient":1},"timeStep":{"type":"fixed",
        "dt":0.01},"until":1}""",
)
