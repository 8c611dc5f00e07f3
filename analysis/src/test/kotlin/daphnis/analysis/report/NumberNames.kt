package daphnis.analysis.report

import daphnis.core.Repository
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import java.nio.file.Files
import java.nio.file.Path

/** Names in `numbers.csv`, which others read by them. */
internal object NumberNames {
    private val BOX = listOf("filling factor φ", "mean radius", "granular temperature ⟨c²⟩/3")
    private val MEETINGS = listOf("collisions of a particle", "compressibility p V / (M T)")
    val GAS = BOX + MEETINGS
    val SHEARED = GAS + listOf(
        "temperature T* = T/(γσ)²",
        "pressure p* = p/(ρ_p σ²γ²)",
        "shear stress τ* = −P_xy/(ρ_p σ²γ²)",
        "viscosity; translational",
        "viscosity; collisional",
        "viscosity; total",
        "γ² ν over dissipation",
    )
    val RING = listOf(
        "optical depth τ",
        "surface density Σ",
        "mean radius r",
        "r Ω",
        "velocity dispersion c",
        "σ_x",
        "σ_y",
        "σ_z",
        "orientation of the velocity ellipsoid",
        "scale height H",
        "filling factor in the middle plane",
        "collisions of a particle",
        "mean impact speed",
        "viscosity; translational",
        "viscosity; collisional",
        "viscosity; total",
        "viscosity; total; in the run's units",
        "(9/4) Ω² ν over dissipation",
    )

    /** The run in [path] has just these, and the guide names them all. */
    fun assertNamed(expected: List<String>, path: Path) {
        val names = Files.readAllLines(path.resolve("tables/numbers.csv")).drop(1).map { it.substringBefore(',') }
        assertEquals(expected, names)
        val guide = Repository.read("docs/analysis.md")
        for (name in expected) assertTrue("`$name`" in guide) { "docs/analysis.md lacks `$name`" }
    }
}
