package daphnis.drills

import java.nio.file.Path
import kotlin.io.path.exists

/**
 * Short runs that differ in what nodes have to agree on: boundaries, time step, forces, bodies, a guard that remembers,
 * outputs that need the spheres and outputs that do not.
 *
 * @property words of `run`: scenario, `--until TIME`, settings
 */
internal enum class NodesScenario(private val words: String) {
    SHEARED("shear-cell --until 6 output.snapshotEvery=40 output.checkpointEvery=70"),
    WALLS(
        "cooling-gas --until 40 boundary={\"type\":\"walls\",\"axes\":\"z\"} box.lengths=[24,24,24] " +
            "output.snapshotEvery=350 output.checkpointEvery=110",
    ),
    BOX(
        "cooling-gas --until 40 boundary={\"type\":\"walls\",\"restitution\":0.8} box.lengths=[24,24,24] " +
            "output.snapshotEvery=9 output.checkpointEvery=50",
    ),
    GUARDED(
        "cooling-gas --until 40 restitution.coefficient=0.4 guard={\"type\":\"contact-duration\",\"duration\":0.05} " +
            "output.snapshotEvery=120 output.checkpointEvery=400",
    ),
    MEASURED(
        "shear-cell --until 12 timeStep={\"type\":\"cell-crossing\",\"fraction\":0.1,\"longest\":0.05} " +
            "output.snapshotEvery=100 output.checkpointEvery=33",
    ),
    RING("ring-patch --until 72000 box.lengths=[80,80,20] output.snapshotEvery=60 output.checkpointEvery=45"),
    MOONLET(
        "moonlet --until 48000 box.lengths=[60,80,6] bodies=[{\"radius\":4,\"density\":200,\"position\":[0,0,0]}] " +
            "output.snapshotEvery=70 output.checkpointEvery=200",
    ),
    ;

    /** The words of the command that runs it with these [options]. */
    fun command(vararg options: String): List<String> {
        val all = words.split(' ') + ALWAYS
        return listOf("run") + all.take(3) + all.drop(3).flatMap { listOf("--set", it) } + options
    }

    /** The run directory of `--engine serial` in [home], made when it is not there. */
    fun whole(home: Path): Path {
        val whole = home.resolve("whole-$ordinal")
        if (!whole.exists()) {
            val words = command("--engine", "serial", "--quiet", "--out", whole.fileName.toString())
            Program.succeed(home, *words.toTypedArray())
        }
        return whole
    }

    private companion object {
        val ALWAYS = listOf("output.seriesEvery=1", "output.transportEvery=3", "output.collisionLog=true")
    }
}
