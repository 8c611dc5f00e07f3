package daphnis.core.cluster

import daphnis.core.table.UnitsOfDimensions
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue

/**
 * Scenarios whose rows differ in what they hold.
 *
 * @property check the lines of `series.csv`, so that the case is what it says
 */
enum class RowCase(text: String, internal val check: (List<List<String>>) -> Unit = {}) {
    SHEARED(
        """"until": 0.5, "box": {"lengths": [14, 14, 14]}, "boundary": {"type": "lees-edwards", "shearRate": 0.7},
        "particles": {"count": 900, "sizes": {"type": "equal", "radius": 0.5}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 1.0, "shearProfile": true}, $GAS""",
    ),
    RING(
        RING_UNITS + """"box": {"lengths": [60, 80, 12]}, "boundary": {"type": "hill-sheet"},
        "particles": {"opticalDepth": 0.3, "sizes": {"type": "equal", "radius": 1.4826}, "density": 900},
        "velocities": {"type": "gaussian", "sigma": 0.0004, "shearProfile": true}, $RING_STEPS""",
        { rows -> assertTrue(rows.column("hill_energy").all { it.toDouble().isFinite() }) },
    ),
    PERTURBED(
        RING_UNITS + """"box": {"lengths": [90, 80, 12]}, "boundary": {"type": "hill-sheet", "perturbation": 0.4},
        "particles": {"opticalDepth": 0.2, "materials": [
        {"name": "ice", "share": 1, "density": 900, "sizes": {"type": "equal", "radius": 1.4826}}]},
        "roughness": {"type": "constant", "coefficient": 0.5},
        "velocities": {"type": "gaussian", "sigma": 0.0004, "shearProfile": true}, $RING_STEPS""",
        { rows -> assertTrue(rows.column("temperature_ice").distinct().size > 3) },
    ),
    WALLS(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "walls"},
        "forces": [{"type": "uniform-acceleration", "acceleration": [0.3, 0, -2]}],
        "particles": {"count": 200, "sizes": {"type": "equal", "radius": 0.4}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 1.0}, $GAS""",
        { rows -> assertEquals(rows.size - 1, rows.column("potential_energy").distinct().size) },
    ),
    OPEN(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "open"},
        "forces": [{"type": "uniform-acceleration", "acceleration": [0.3, 0, -2]}],
        "particles": {"count": 200, "sizes": {"type": "equal", "radius": 0.4}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 1.0}, $GAS""",
    ),
    FALLING(
        """"until": 0.2, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "periodic"},
        "forces": [{"type": "uniform-acceleration", "acceleration": [0, 0, -2]}],
        "particles": {"count": 50, "sizes": {"type": "equal", "radius": 0.4}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 1.0}, $GAS""",
        { rows -> assertEquals(listOf("NaN"), rows.column("potential_energy").distinct()) },
    ),
    AT_REST(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "periodic"},
        "particles": {"count": 300, "sizes": {"type": "equal", "radius": 0.4}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 1.0}, "placement": {"type": "random"},
        "restitution": {"type": "constant", "coefficient": 1}, "timeStep": {"type": "fixed", "dt": 0.05}""",
    ),
    BODIES(
        RING_UNITS + """"box": {"lengths": [60, 80, 12]}, "boundary": {"type": "hill-sheet"},
        "particles": {"opticalDepth": 0.2, "sizes": {"type": "equal", "radius": 1.0}, "density": 900},
        "bodies": [{"radius": 5, "density": 200, "position": [0, 0, 0]}, {"radius": 4, "density": 200,
        "position": [20, 20, 0]}],
        "velocities": {"type": "gaussian", "sigma": 0.0004, "shearProfile": true}, $RING_STEPS""",
    ),
    REMOVED(
        RING_UNITS + """"box": {"lengths": [60, 80, 12]}, "boundary": {"type": "hill-sheet", "radiallyOpen": true},
        "particles": {"opticalDepth": 0.2, "sizes": {"type": "equal", "radius": 1.4826}, "density": 900},
        "forces": [{"type": "satellite", "massRatio": 1e-20, "x": -20, "y": -10, "radius": 14}],
        "velocities": {"type": "gaussian", "sigma": 0.0004, "shearProfile": true}, $RING_STEPS""",
        { rows -> assertNotEquals(rows.column("particles").first(), rows.column("particles").last()) },
    ),
    FEW(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "walls"},
        "particles": {"count": 3, "sizes": {"type": "equal", "radius": 0.4}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 1.0}, $GAS""",
    ),
    ONE(
        RING_UNITS + """"box": {"lengths": [60, 80, 12]}, "boundary": {"type": "hill-sheet"},
        "particles": {"count": 1, "sizes": {"type": "equal", "radius": 1.4826}, "density": 900},
        "velocities": {"type": "gaussian", "sigma": 0.0004, "shearProfile": true}, $RING_STEPS""",
        { rows -> assertEquals(listOf("0.0"), rows.column("granular_temperature").distinct()) },
    ),
    ROUGH(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "walls"},
        "particles": {"count": 300, "materials": [
        {"name": "iron", "share": 0.3, "density": 9, "sizes": {"type": "equal", "radius": 0.3}},
        {"name": "ice", "share": 0.7, "density": 1, "sizes": {"type": "equal", "radius": 0.4}}]},
        "roughness": {"type": "constant", "coefficient": 0.5, "momentFactor": 0.3},
        "spins": {"type": "gaussian", "temperature": 2, "mean": [1, 0, -3]},
        "velocities": {"type": "gaussian", "sigma": 1.0}, $GAS""",
        { rows ->
            for (name in listOf("rotational_temperature", "mean_spin_z", "angular_momentum_x", "temperature_iron")) {
                val all = rows.column(name).map { it.toDouble() }
                assertTrue(all.all { it.isFinite() && it != 0.0 } && all.distinct().size > 3) { "$name $all" }
            }
        },
    ),
    ROUGH_RING(
        RING_UNITS + """"box": {"lengths": [60, 80, 12]}, "boundary": {"type": "hill-sheet"},
        "particles": {"opticalDepth": 0.2, "materials": [
        {"name": "ice", "share": 1, "density": 900, "sizes": {"type": "equal", "radius": 1.4826}}]},
        "bodies": [{"radius": 5, "density": 200, "position": [0, 0, 0], "material": "rock"}],
        "roughness": {"type": "coulomb", "friction": 0.4, "sticking": 0.1},
        "velocities": {"type": "gaussian", "sigma": 0.0004, "shearProfile": true}, $RING_STEPS""",
        { rows -> assertTrue(rows.column("temperature_ice").distinct().size > 3) },
    ),
    TREE(
        RING_UNITS + """"box": {"lengths": [60, 80, 12]}, "boundary": {"type": "hill-sheet"},
        "particles": {"surfaceDensity": 400, "density": 400,
        "sizes": {"type": "power-law", "minimum": 1, "maximum": 3, "exponent": 3}},
        "bodies": [{"radius": 5, "density": 200, "position": [0, 0, 0]}],
        "forces": [{"type": "body-gravity"}, {"type": "self-gravity", "softening": 0.1}],
        "velocities": {"type": "gaussian", "sigma": 0.0004, "shearProfile": true}, $RING_STEPS""",
        { rows -> assertEquals(rows.size - 1, rows.column("hill_energy").distinct().size) },
    ),
    MESH(
        RING_UNITS + """"box": {"lengths": [60, 80, 12]}, "boundary": {"type": "hill-sheet"},
        "particles": {"surfaceDensity": 400, "density": 400,
        "sizes": {"type": "power-law", "minimum": 1, "maximum": 3, "exponent": 3}},
        "forces": [{"type": "self-gravity", "method": "mesh"}],
        "velocities": {"type": "gaussian", "sigma": 0.0004, "shearProfile": true}, $RING_STEPS""",
        { rows -> assertEquals(rows.size - 1, rows.column("hill_energy").distinct().size) },
    ),
    GROWING(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "periodic"},
        "particles": {"count": 300, "sizes": {"type": "equal", "radius": 0.4}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 1.0}, "placement": {"type": "random"},
        "growth": {"rate": 0.3, "untilFillingFactor": 0.14}, "restitution": {"type": "constant", "coefficient": 1},
        "timeStep": {"type": "fixed", "dt": 0.05}""",
        { rows ->
            assertEquals(rows.size - 1, rows.column("filling_factor").distinct().size)
            assertEquals(rows.size - 1, rows.column("reduced_pressure").distinct().size)
        },
    ),
    SHAKEN(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "walls", "faces": {
        "lowerZ": {"motion": {"type": "sine", "amplitude": 0.2, "frequency": 3}}, "upperX": {"temperature": 2}},
        "surfaces": [{"type": "sphere", "centre": [0, 0, 0], "radius": 1.5, "room": "outside", "angularVelocity": [0, 0, 1], "temperature": 1}]},
        "particles": {"count": 250, "sizes": {"type": "equal", "radius": 0.4}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 2.0}, $GAS""",
    ),
    STEPPED(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "periodic"},
        "particles": {"count": 300, "materials": [
        {"name": "a", "share": 0.5, "density": 1, "sizes": {"type": "equal", "radius": 0.4}},
        {"name": "b", "share": 0.5, "density": 3, "sizes": {"type": "equal", "radius": 0.3}}]},
        "interaction": {"type": "square-well", "ratio": 1.6, "depth": 0.5},
        "contacts": [{"between": ["b", "b"], "interaction": {"type": "stepped", "steps": [[2, 0.3], [1.5, -0.4]]}},
        {"between": ["a", "b"], "interaction": {"type": "none"}}],
        "velocities": {"type": "gaussian", "sigma": 1.5}, $GAS""",
        { rows -> assertEquals(rows.size - 1, rows.column("potential_energy").distinct().size) },
    ),
    CHAINED(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "periodic"},
        "particles": {"count": 300, "sizes": {"type": "equal", "radius": 0.3}, "mass": 1.0},
        "bonds": {"length": 4, "greatest": 1.2}, "velocities": {"type": "gaussian", "sigma": 2.0}, $GAS""",
        { rows -> assertEquals(rows.size - 1, rows.column("edge_events").distinct().size) },
    ),
    REMOVED_BOUND(
        RING_UNITS + """"box": {"lengths": [60, 80, 12]}, "boundary": {"type": "hill-sheet", "radiallyOpen": true},
        "particles": {"opticalDepth": 0.4, "sizes": {"type": "equal", "radius": 1.4826}, "density": 900},
        "forces": [{"type": "satellite", "massRatio": 1e-20, "x": -20, "y": -10, "radius": 14}],
        "interaction": {"type": "square-well", "ratio": 1.8, "depth": 0.002},
        "velocities": {"type": "gaussian", "sigma": 0.0004, "shearProfile": true}, $RING_STEPS""",
        { rows ->
            assertNotEquals(rows.column("particles").first(), rows.column("particles").last())
            assertTrue(rows.column("potential_energy").distinct().size > 3)
        },
    ),
    MERGING(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "periodic"},
        "particles": {"count": 300, "sizes": {"type": "equal", "radius": 0.3}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 2.0}, "roughness": {"type": "constant", "coefficient": 0.5},
        "merging": {"type": "always"}, $GAS""",
        { rows -> assertEquals(rows.size - 1, rows.column("particles").distinct().size) },
    ),
    BREAKING(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "periodic"},
        "particles": {"count": 200, "sizes": {"type": "equal", "radius": 0.4}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 2.0}, "merging": {"type": "slow", "speed": 1},
        "breaking": {"speed": 2, "pieces": 3, "spread": 0.2, "smallest": 0.2}, $GAS""",
        { rows -> assertTrue(rows.column("particles").let { it.last().toInt() > 2 * it.first().toInt() }) },
    ),
    SWAPPING(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "periodic"},
        "particles": {"count": 500, "materials": [
        {"name": "a", "share": 0.5, "density": 1, "sizes": {"type": "equal", "radius": 0.4}},
        {"name": "b", "share": 0.5, "density": 3, "sizes": {"type": "equal", "radius": 0.35}}]},
        "velocities": {"type": "gaussian", "sigma": 2.0}, "swaps": {"rate": 30}, $GAS""",
        { rows -> assertEquals(rows.size - 1, rows.column("temperature_a").distinct().size) },
    ),
    EXCHANGED(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "walls", "axes": "z"},
        "particles": {"count": 200, "sizes": {"type": "equal", "radius": 0.4}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 2.0}, "roughness": {"type": "constant", "coefficient": 0.5},
        "sources": [
        {"type": "reservoir", "region": {"x": [-4.5, 0.5]}, "fillingFactor": 0.15, "temperature": 2},
        {"type": "outflow", "region": {"x": [0, 2], "y": [-3, 4]}},
        {"type": "inflow", "rate": 200, "region": {"x": [-4.5, 4.5], "y": [2, 4.5]}, "velocity": [1, 0, 0],
        "sigma": 0.5, "particles": {"sizes": {"type": "power-law", "minimum": 0.1, "maximum": 0.5, "exponent": 3}, "density": 2}},
        {"type": "inflow", "rate": 200, "through": "upperZ", "sigma": 3}], $GAS""",
        { rows ->
            for (k in 0..3) assertNotEquals("0", rows.column("source${k}_${if (k == 1) "left" else "came"}").last())
            assertNotEquals("0", rows.column("source2_refused").last())
        },
    ),
    EMPTIED(
        """"until": 1.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "periodic"},
        "particles": {"count": 100, "sizes": {"type": "equal", "radius": 0.4}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 2.0},
        "sources": [{"type": "inflow", "rate": 4, "region": {"x": [0, 4]}}, {"type": "outflow"}], $GAS""",
        { rows -> assertEquals(listOf("0"), rows.column("particles").drop(1).distinct()) },
    ),
    PISTONS(
        """"until": 0.5, "box": {"lengths": [9, 9, 9]}, "boundary": {"type": "walls", "faces": {
        "lowerZ": {"motion": {"type": "piston", "mass": 50}},
        "upperZ": {"motion": {"type": "piston", "mass": 40, "force": -30}}}},
        "particles": {"count": 300, "sizes": {"type": "equal", "radius": 0.4}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 2.0}, $GAS""",
        { rows -> assertEquals(rows.size - 1, rows.column("piston_speed_upper_z").distinct().size) },
    ),
    MOONS(
        RING_UNITS + """"box": {"lengths": [60, 80, 12]}, "boundary": {"type": "hill-sheet", "radiallyOpen": true},
        "particles": {"opticalDepth": 0.2, "sizes": {"type": "equal", "radius": 1.4826}, "density": 900},
        "forces": [{"type": "satellite", "massRatio": 1e-20, "x": -40, "y": -10, "softening": 2, "feelsRing": true},
        {"type": "satellite", "massRatio": 2e-20, "x": 50, "y": 15, "e": 3, "inclination": 2, "feelsRing": true}],
        "velocities": {"type": "gaussian", "sigma": 0.0004, "shearProfile": true}, $RING_STEPS""",
        { rows -> assertEquals(rows.size - 1, rows.column("hill_energy").distinct().size) },
    ),
    ;

    /** The scenario in JSON. */
    val text: String = """{"name": "$name", $text}"""
}

private const val GAS = """"placement": {"type": "random"},
    "restitution": {"type": "constant", "coefficient": 0.7}, "timeStep": {"type": "fixed", "dt": 0.05}"""

private const val RING_UNITS = """"units": {"speedInCmPerSecond": 100, "lengthInMetres": 1, "massInKg": 1},
    "frame": {"type": "hill", "planet": "saturn", "distanceInKm": 130000}, """

private const val RING_STEPS = """"restitution": {"type": "bridges"},
    "timeStep": {"type": "orbit-fraction", "steps": 200}, "untilOrbits": 0.05"""

/** The entries of a column, below its name. */
private fun List<List<String>>.column(name: String): List<String> {
    val heads = map { it.map(UnitsOfDimensions::nameIn) }
    val header = heads.indexOfFirst { name in it }
    val at = heads[header].indexOf(name)
    return drop(header + 1).map { it[at] }
}
