package daphnis.analysis.input

import io.jhdf.HdfFile
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPOutputStream

/**
 * Files of a [trajectory] as other programs write them, each time another.
 *
 * @property says what the file that was written last tells
 */
internal class DrawnFiles(private val trajectory: DrawnTrajectory, private val home: Path) {
    /** How places are written. */
    enum class Places { WRAPPED, WITH_IMAGES, UNWRAPPED }

    class Says(
        val words: String,
        val places: Places,
        val hasTime: Boolean,
        val hasVelocity: Boolean,
        val hasRadius: Boolean,
        val hasMass: Boolean,
        val frames: List<Int>,
    )

    private val t = trajectory
    private val places = t.pick(*Places.entries.toTypedArray())
    private val hasTime = t.chance(70)
    private val hasVelocity = t.chance(70)
    private val hasRadius = t.chance(80)
    private val hasMass = t.chance(60)

    private fun says(words: String, frames: List<Int> = (0 until t.frames).toList(), hasTime: Boolean = this.hasTime) =
        Says("$words, $places", places, hasTime, hasVelocity, hasRadius, hasMass, frames)

    /** Frames in the order of the file: a program that goes on from an earlier state writes some again. */
    private val written: List<Int> = (0 until t.frames).toList().let { all ->
        val again = t.pick(0, 0, 1, 2)
        if (t.frames < 3) all else all.take(t.frames - 1) + all.drop(t.frames - 1 - again)
    }

    /** Coordinates as the file has them, and flags. */
    private fun placed(frame: Int): Pair<Array<DoubleArray>, Array<IntArray>?> {
        val (wrapped, boxes) = t.wrapped(frame)
        val shown = if (places == Places.UNWRAPPED) t.place[frame] else wrapped
        val inFile = Array(3) { a -> DoubleArray(t.count) { t.inFile(frame, a, shown[a][it]) } }
        return inFile to boxes.takeIf { places == Places.WITH_IMAGES }
    }

    fun draw(): Pair<Path, Says> = when (t.pick("dump", "dump", "xyz", "xyz", "h5")) {
        "dump" -> dump()
        "xyz" -> xyz()
        else -> h5()
    }

    private fun text(name: String, lines: List<String>): Path {
        val end = t.pick("\n", "\n", "\r\n")
        val blank = t.pick("", "", end, "$end  $end")
        val text = t.pick("", "", "\uFEFF") + lines.joinToString("") { it + end } + blank
        val file = home.resolve(name)
        if (!t.chance(20)) return Files.writeString(file, text)
        val packed = home.resolve("$name.gz")
        GZIPOutputStream(Files.newOutputStream(packed)).use { it.write(text.toByteArray()) }
        return packed
    }

    private fun dump(): Pair<Path, Says> {
        val scaled = t.chance(50)
        val suffix = if (places == Places.UNWRAPPED) {
            (if (scaled) "su" else "u")
        } else if (scaled) {
            "s"
        } else {
            ""
        }
        val columns = ArrayList<Pair<String, (Int, Int) -> String>>()
        columns += "id" to { _, k -> "${t.id[k]}" }
        columns += "type" to { _, _ -> "1" }
        val at = List(t.frames) { placed(it) }
        for (axis in 0..2) {
            columns += "${"xyz"[axis]}$suffix" to { f, k ->
                "${if (scaled) fraction(f, k, at[f].first)[axis] else at[f].first[axis][k]}"
            }
            if (places == Places.WITH_IMAGES) columns += "i${"xyz"[axis]}" to { f, k -> "${at[f].second!![axis][k]}" }
            if (hasVelocity) columns += "v${"xyz"[axis]}" to { f, k -> "${t.velocity[f][axis][k]}" }
        }
        if (hasRadius) {
            columns += if (t.chance(50)) {
                "radius" to { _, k -> "${t.radius[k]}" }
            } else {
                "diameter" to { _, k -> "${2 * t.radius[k]}" }
            }
        }
        if (hasMass) columns += "mass" to { _, k -> "${t.mass[k]}" }
        if (t.chance(40)) columns.sortBy { it.first.hashCode() }
        val gap = t.pick(" ", "\t", "  ")
        val lines = ArrayList<String>()
        for (f in written) {
            if (f == 0 && t.chance(30)) lines += listOf("ITEM: UNITS", "lj")
            if (hasTime) lines += listOf("ITEM: TIME", "${t.time(f)}")
            lines += listOf("ITEM: TIMESTEP", "${t.step(f)}", "ITEM: NUMBER OF ATOMS", "${t.count}")
            lines += bounds(f)
            lines += "ITEM: ATOMS " + columns.joinToString(gap) { it.first }
            for (k in t.shuffled()) lines += columns.joinToString(gap) { it.second(f, k) } + t.pick("", " ")
        }
        return text("drawn.lammpstrj", lines) to says("dump $suffix of ${columns.map { it.first }}")
    }

    /** Scaled coordinates: those in units of the edges. */
    private fun fraction(f: Int, k: Int, at: Array<DoubleArray>): DoubleArray {
        val s = DoubleArray(3) { (at[it][k] - t.corner(f, it)) / t.edge(f, it) }
        val (normal, slide) = t.axes ?: return s
        s[slide] = (at[slide][k] - t.corner(f, slide) - s[normal] * t.offset(f)) / t.edge(f, slide)
        return s
    }

    private val closed = t.pick("ff", "ff", "ss", "mm", "fs", "sm")

    private fun bounds(f: Int): List<String> {
        val faces = (0..2).joinToString(" ") { if (t.periodic[it]) "pp" else closed }
        val low = DoubleArray(3) { t.corner(f, it) }
        val high = DoubleArray(3) { low[it] + t.edge(f, it) }
        val (normal, slide) = t.axes ?: (0 to 0)
        val cell = t.cell(f)
        if (normal < slide) {
            return listOf("ITEM: BOX BOUNDS abc origin $faces") +
                (0..2).map { "${cell[it][0]} ${cell[it][1]} ${cell[it][2]} ${low[it]}" }
        }
        if (t.axes == null && t.chance(70)) {
            return listOf("ITEM: BOX BOUNDS $faces") + (0..2).map { "${low[it]} ${high[it]}" }
        }
        low[slide] += minOf(0.0, t.offset(f))
        high[slide] += maxOf(0.0, t.offset(f))
        val tilt = doubleArrayOf(cell[1][0], cell[2][0], cell[2][1])
        return listOf("ITEM: BOX BOUNDS xy xz yz $faces") + (0..2).map { "${low[it]} ${high[it]} ${tilt[it]}" }
    }

    private fun pbc(): String {
        val (yes, no) = t.pick("T" to "F", "true" to "false", "1" to "0", "True" to "False")
        val faces = t.periodic.map { if (it) yes else no }
        return t.pick(
            "pbc=\"${faces.joinToString(" ")}\"",
            "pbc=[${faces.joinToString()}]",
            "pbc=\"[${faces.joinToString()}]\"",
            "pbc='${faces.joinToString(" ")}'",
            "PBC = {${faces.joinToString(" ")}}",
        )
    }

    private fun xyz(): Pair<Path, Says> {
        val at = List(t.frames) { placed(it) }
        val columns = ArrayList<Pair<String, (Int, Int) -> String>>()
        fun vector(name: String, value: (Int, Int, Int) -> Any) {
            columns += name to { f, k -> (0..2).joinToString("\t") { "${value(f, it, k)}" } }
        }
        columns += "species:S:1" to { _, _ -> "Si" }
        vector("pos:R:3") { f, a, k -> at[f].first[a][k] }
        if (hasMass) columns += t.pick("mass:R:1", "masses:R:1") to { _, k -> "${t.mass[k]}" }
        if (hasVelocity && hasMass && t.chance(50)) {
            vector("momenta:R:3") { f, a, k -> t.velocity[f][a][k] * t.mass[k] }
        } else if (hasVelocity) {
            vector(t.pick("velo:R:3", "vel:R:3")) { f, a, k -> t.velocity[f][a][k] }
        }
        columns += "id:I:1" to { _, k -> "${t.id[k]}" }
        if (hasRadius) columns += "radius:R:1" to { _, k -> "${t.radius[k]}" }
        if (places == Places.WITH_IMAGES) vector("map_shift:I:3") { f, a, k -> at[f].second!![a][k] }
        if (t.chance(40)) columns.sortBy { it.first.hashCode() }
        val lines = ArrayList<String>()
        for (f in written) {
            val lattice = t.cell(f).joinToString(" ") { row -> row.joinToString(" ") }
            val parts = mutableListOf(
                "Lattice=" + t.pick("\"$lattice\"", "[${lattice.replace(" ", ", ")}]"),
                "Origin=\"${(0..2).joinToString(" ") { "${t.corner(f, it)}" }}\"",
                "Properties=" + columns.joinToString(":") { it.first },
                pbc(),
                "Step=${t.step(f)}",
                "energy=-1.5",
                "note=\"a 'b' c=d\"",
            )
            if (hasTime) parts += "Time=${t.time(f)}"
            if (t.chance(50)) parts.sortBy { it.hashCode() }
            lines += listOf("${t.count}", parts.joinToString(t.pick(" ", "\t", "  ")))
            for (k in t.shuffled()) lines += columns.joinToString(t.pick(" ", "\t")) { it.second(f, k) }
        }
        return text(t.pick("drawn.xyz", "drawn.extxyz"), lines) to says("xyz of ${columns.map { it.first }}")
    }

    private inline fun <reified A> byFrame(of: (Int) -> A): Array<A> = Array(written.size) { of(written[it]) }

    private fun h5(): Pair<Path, Says> {
        val path = home.resolve("drawn.h5")
        Files.deleteIfExists(path)
        val frames = written
        val orders = List(t.frames) { t.shuffled() }
        val centred = t.chance(50)

        // A box of H5MD begins at 0, or is centred.
        fun at(f: Int): Pair<Array<DoubleArray>, Array<IntArray>?> {
            val (shown, flags) = placed(f)
            for (a in 0..2) {
                val by = t.inFile(f, a, 0.0) - if (centred) 0.0 else t.edge(f, a) / 2
                for (k in 0 until t.count) shown[a][k] -= by
            }
            return shown to flags
        }
        val all = List(t.frames) { at(it) }
        HdfFile.write(path).use { file ->
            val group = file.putGroup("particles").putGroup("grains")
            val box = group.putGroup("box")
            box.putAttribute("dimension", 3)
            box.putAttribute("boundary", Array(3) { if (t.periodic[it]) "periodic" else "none" })
            val steps = LongArray(frames.size) { t.step(frames[it]) }
            fun element(name: String, value: Any) = group.putGroup(name).also {
                it.putDataset("step", steps)
                if (hasTime) it.putDataset("time", DoubleArray(frames.size) { t.time(frames[it]) })
                it.putDataset("value", value)
            }
            fun vectors(value: (Int, Int, Int) -> Double) = byFrame { f ->
                Array(t.count) { k -> DoubleArray(3) { a -> value(f, a, orders[f][k]) } }
            }
            val edges = box.putGroup("edges")
            edges.putDataset("step", steps)
            edges.putDataset(
                "value",
                if (t.axes == null) byFrame { f -> DoubleArray(3) { t.edge(f, it) } } else byFrame(t::cell),
            )
            element("position", vectors { f, a, k -> all[f].first[a][k] })
            if (hasVelocity) element("velocity", vectors { f, a, k -> t.velocity[f][a][k] })
            if (places == Places.WITH_IMAGES) {
                val flags = byFrame { f ->
                    Array(t.count) { k -> IntArray(3) { a -> all[f].second!![a][orders[f][k]] } }
                }
                element("image", flags)
            }
            element("id", byFrame { f -> IntArray(t.count) { t.id[orders[f][it]] } })
            if (hasMass) element("mass", byFrame { f -> DoubleArray(t.count) { t.mass[orders[f][it]] } })
            if (hasRadius) element("radius", byFrame { f -> DoubleArray(t.count) { t.radius[orders[f][it]] } })
        }
        return path to says("h5, ${if (centred) "centred" else "from 0"}")
    }
}
