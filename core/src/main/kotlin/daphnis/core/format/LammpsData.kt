package daphnis.core.format

import daphnis.core.format.Kept.Presence.ALWAYS
import daphnis.core.format.Kept.Presence.IF_THERE
import java.nio.file.Path

/**
 * The data file that LAMMPS reads with `read_data` and writes with `write_data`: one state, atoms of style `sphere`
 * (radii and densities; spins behind the velocities) or `atomic` (masses by type, no radii). Along an axis without
 * bounds the box is open. The file does not say whether it is periodic; that is taken, as it is LAMMPS' default.
 */
public object LammpsData : ReadableFormat {
    override val title: String = "LAMMPS data"
    override val extensions: List<String> = listOf("data", "lmp")
    override val prefix: String = "data."
    override val isText: Boolean = true
    override val keeps: Kept = Kept(masses = IF_THERE, velocities = IF_THERE, ids = ALWAYS, severalStates = false)

    /** Reads [path] as a state at time 0. @throws FormatException that names the line of the error */
    override fun read(path: Path, notices: MutableList<String>): List<Snapshot> =
        TextLines(path).use { listOf(LammpsDataReader(it, path, notices).snapshot()) }
}
