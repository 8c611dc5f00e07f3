package daphnis.core.physics

import org.junit.jupiter.api.Assertions.assertTrue
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE
import java.util.Locale

/** Whether the long forms run: `./check --physics`. */
val fullPhysics: Boolean = System.getProperty("daphnis.physics") == "full"

/** Whether only the shortest forms run: `./check` alone. */
val quickPhysics: Boolean = System.getProperty("daphnis.physics") == "quick"

/** Holds [measured] against [target] and writes a row of the table that `./check` prints, whatever comes out. */
fun assertPhysics(what: String, target: Double, measured: Double, bound: Double, relative: Boolean = true) {
    val deviation = if (relative) Math.abs(measured / target - 1) else Math.abs(measured - target)
    val limit = if (relative) {
        String.format(
            Locale.ROOT,
            "%.3g %%",
            bound * 100,
        )
    } else {
        String.format(Locale.ROOT, "%.3g", bound)
    }
    val row = String.format(
        Locale.ROOT,
        "| %s | %.6g | %.6g | ± %s | %s |%n",
        what,
        target,
        measured,
        limit,
        if (deviation <= bound) {
            "ok"
        } else {
            "FAILED"
        },
    )
    TABLE.toAbsolutePath().parent?.let { Files.createDirectories(it) }
    Files.writeString(TABLE, row, CREATE, APPEND)
    if (fullPhysics) Files.writeString(FULL_TABLE, row, CREATE, APPEND)
    assertTrue(deviation <= bound) { row }
}

private val TABLE = Path.of(System.getProperty("daphnis.physicsTable") ?: "target/physics.md")

/** What the long forms have measured, from which [ValidationRecord] is written anew. */
internal val FULL_TABLE: Path = TABLE.resolveSibling("physics-full.md")

/** Something that must stay below [bound]. */
fun assertBelow(what: String, measured: Double, bound: Double) {
    assertPhysics(what, 0.0, measured, bound, relative = false)
}
