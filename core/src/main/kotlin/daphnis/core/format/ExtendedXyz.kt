package daphnis.core.format

import java.io.Writer
import java.nio.file.Path

/** Extended XYZ, the text format of OVITO and ASE. */
public object ExtendedXyz {
    /**
     * Appends one [frame] to [out]. Lengths (and velocities) are multiplied by [scale]: OVITO takes coordinates that
     * all lie in about [−½, ½] for reduced ones and stretches them to the cell, so small boxes are better given in
     * particle radii.
     */
    public fun write(frame: Snapshot, out: Writer, scale: Double = 1.0) {
        out.append(frame.size.toString()).append('\n')
        val l = DoubleArray(3) { frame.lengths[it] * scale }
        if (l.none { it.isNaN() }) {
            val edges = frame.edges().joinToString(" ") { row -> row.joinToString(" ") { (it * scale).toString() } }
            out.append("Lattice=\"$edges\" ")
            out.append("Origin=\"${-l[0] / 2} ${-l[1] / 2} ${-l[2] / 2}\" ")
        }
        out.append("Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1 ")
        out.append("Time=${frame.time} Step=${frame.step} Scale=$scale ")
        out.append("pbc=\"${frame.periodic.joinToString(" ") { if (it) "T" else "F" }}\"\n")
        for (k in 0 until frame.size) {
            out.append('X')
            for (axis in 0..2) out.append(' ').append((frame.position[axis][k] * scale).toString())
            for (axis in 0..2) out.append(' ').append((frame.velocity[axis][k] * scale).toString())
            out.append(' ').append((frame.radius[k] * scale).toString())
            out.append(' ').append(frame.mass[k].toString())
            out.append(' ').append(frame.id[k].toString()).append('\n')
        }
    }

    /**
     * A scale that keeps OVITO from taking lengths for reduced coordinates: 1 for boxes longer than 4, else 1 / mean
     * radius.
     */
    public fun suitableScale(frame: Snapshot): Double {
        val longest =
            frame.lengths.filter { !it.isNaN() }.maxOrNull()
                ?: frame.position.maxOf { a -> a.maxOfOrNull { Math.abs(it) } ?: 0.0 } * 2
        return if (longest > SHORT_BOX || frame.size == 0) 1.0 else 1.0 / frame.radius.average()
    }

    /**
     * Reads every frame of [path]: `Properties` must hold `pos:R:3`; `velo`, `radius`, `mass` and `id` where they are
     * there, else 0, 1/2, 1 and the line number. A `Lattice` of edges along the axes gives the lengths; one that leans,
     * along x or y as sliding images do, the offset; another is refused. Lengths and velocities are divided by the
     * `Scale` in the comment line, the factor that [write] multiplied them by.
     *
     * @throws FormatException that names the line of what is wrong
     */
    public fun read(path: Path): List<Snapshot> {
        val frames = ArrayList<Snapshot>()
        TextLines(path).use { lines ->
            val reader = XyzReader(lines, path)
            while (true) frames += reader.frame(frames.size) ?: break
        }
        return frames
    }

    private const val SHORT_BOX = 4.0
}
