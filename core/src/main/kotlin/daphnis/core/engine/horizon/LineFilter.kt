package daphnis.core.engine.horizon

/**
 * Dismisses most of the lines that a search looks at, in floats, by the bounds of
 * [waitUntilContact][daphnis.core.collision.waitUntilContact]: a line comes near only if c ≤ 0, or if b² ≥ u²c and
 * c ≤ −2bτ. Both are tested with room for the rounding of floats, so a line that comes near is never dismissed; some
 * others are kept, and which is up to the filter.
 */
internal interface LineFilter {
    /** Adds those of the slots [first] until [end] in [state] which may come near [query] to [into]. */
    fun near(state: FloatArray, query: LineQuery, first: Int, end: Int, into: KeptLines)

    /** What a row of cells in a search costs, and each line in it, in the nanoseconds of [EpochCost]. */
    val perRun: Double
    val perLine: Double

    companion object {
        /** Room for the rounding of floats in b² ≥ u²c. */
        const val ROUNDING = 1.00001f

        /** What is quickest in this JVM. */
        val BEST: LineFilter = vector() ?: ScalarFilter

        /** The filter with the vector unit; null where the JVM was started without the module for it. */
        fun vector(): LineFilter? = try {
            val unit = ModuleLayer.boot().findModule(VECTOR_MODULE).orElse(null)
            if (unit == null || !isCompiled()) {
                null
            } else {
                // Not in module-info: compilers of programs would warn of an incubating module.
                LineFilter::class.java.module.addReads(unit)
                Class.forName(VECTOR_FILTER).getDeclaredConstructor().newInstance() as LineFilter
            }
        } catch (_: ReflectiveOperationException) {
            null
        } catch (_: LinkageError) {
            null
        }

        /** Whether HotSpot's second compiler is at work; without it each vector is an object, which takes far longer. */
        private fun isCompiled(): Boolean {
            val mode = System.getProperty("java.vm.info", "")
            return "mixed mode" in mode && "emulated-client" !in mode
        }

        private const val VECTOR_MODULE = "jdk.incubator.vector"
        private const val VECTOR_FILTER = "daphnis.core.engine.horizon.VectorFilter"
    }
}

/** One line after the other. */
internal object ScalarFilter : LineFilter {
    override val perRun: Double get() = 16.0
    override val perLine: Double get() = 2.4

    override fun near(state: FloatArray, query: LineQuery, first: Int, end: Int, into: KeptLines) {
        into.reserve(end - first)
        val x = query.x
        val y = query.y
        val z = query.z
        val u = query.u
        val v = query.v
        val w = query.w
        val t = query.time
        val closing = query.closing
        val radius = query.radius
        val marks = into.marks
        var size = into.size
        for (slot in first until end) {
            val p = Lines.place(slot)
            val pu = state[p + Lines.U]
            val pv = state[p + Lines.V]
            val pw = state[p + Lines.W]
            val a = pu - u
            val b = pv - v
            val c = pw - w
            val dx = state[p] + pu * t - x
            val dy = state[p + Lines.Y] + pv * t - y
            val dz = state[p + Lines.Z] + pw * t - z
            val s = radius + state[p + Lines.RADIUS]
            val gap = dx * dx + dy * dy + dz * dz - s * s
            val approach = dx * a + dy * b + dz * c
            val late = approach * closing - gap
            val miss = approach * approach * LineFilter.ROUNDING - (a * a + b * b + c * c) * gap
            // Sign bits instead of comparisons: one branch, which nearly always goes the same way.
            val isNear = (late.toRawBits() or miss.toRawBits()) >= 0 || gap <= 0f
            if (isNear) marks[size++] = slot.toLong() shl Lines.LANES or 1
        }
        into.size = size
    }
}
