package daphnis.analysis.plot

/**
 * How a curve is told from others beside its colour: by the [dashes] of its line and the shape of its marks.
 */
internal enum class Pattern(val dashes: Dashes?) {
    SOLID_DISC(null) {
        override fun mark(sheet: Sheet, x: Double, y: Double, r: Double, colour: String) = sheet.disc(x, y, r, colour)
    },
    DASHED_TRIANGLE(Dashes(4, 3)) {
        override fun mark(sheet: Sheet, x: Double, y: Double, r: Double, colour: String) =
            polygon(sheet, x, y, r, colour, TRIANGLE)
    },
    DOTS_AND_DASHES_SQUARE(Dashes(1, 2, 5, 2)) {
        override fun mark(sheet: Sheet, x: Double, y: Double, r: Double, colour: String) =
            polygon(sheet, x, y, r, colour, SQUARE)
    },
    LONG_DASHES_RHOMBUS(Dashes(9, 3)) {
        override fun mark(sheet: Sheet, x: Double, y: Double, r: Double, colour: String) =
            polygon(sheet, x, y, r, colour, RHOMBUS)
    },
    LONG_AND_SHORT_RING(Dashes(2, 2, 8, 2)) {
        override fun mark(sheet: Sheet, x: Double, y: Double, r: Double, colour: String) =
            sheet.disc(x, y, r, colour, EDGE)
    },
    DOTTED_CROSS(Dashes(1, 2)) {
        override fun mark(sheet: Sheet, x: Double, y: Double, r: Double, colour: String) {
            sheet.line(x - r, y - r, x + r, y + r, colour, EDGE)
            sheet.line(x - r, y + r, x + r, y - r, colour, EDGE)
        }
    },
    SOLID_OPEN_SQUARE(null) {
        override fun mark(sheet: Sheet, x: Double, y: Double, r: Double, colour: String) =
            edges(sheet, x, y, r, colour, SQUARE)
    },
    DASHED_OPEN_TRIANGLE(Dashes(4, 3)) {
        override fun mark(sheet: Sheet, x: Double, y: Double, r: Double, colour: String) =
            edges(sheet, x, y, r, colour, TRIANGLE)
    }, ;

    /** Marks the point ([x], [y]) by something about [r] in radius. */
    abstract fun mark(sheet: Sheet, x: Double, y: Double, r: Double, colour: String)

    protected companion object {
        const val EDGE = 1.3
        val TRIANGLE = doubleArrayOf(0.0, -1.25, 1.1, 0.75, -1.1, 0.75)
        val SQUARE = doubleArrayOf(-0.9, -0.9, 0.9, -0.9, 0.9, 0.9, -0.9, 0.9)
        val RHOMBUS = doubleArrayOf(0.0, -1.3, 1.3, 0.0, 0.0, 1.3, -1.3, 0.0)

        /** The corners in turn, x and then y of each, in units of [r] around ([x], [y]). */
        fun polygon(sheet: Sheet, x: Double, y: Double, r: Double, colour: String, corners: DoubleArray) {
            val n = corners.size / 2
            sheet.area(
                DoubleArray(n) {
                    x + r * corners[2 * it]
                },
                DoubleArray(n) { y + r * corners[2 * it + 1] },
                colour,
            )
        }

        fun edges(sheet: Sheet, x: Double, y: Double, r: Double, colour: String, corners: DoubleArray) {
            val n = corners.size / 2
            fun corner(k: Int, axis: Int) = corners[2 * (k % n) + axis]
            sheet.path(
                DoubleArray(n + 1) { x + r * corner(it, 0) },
                DoubleArray(n + 1) { y + r * corner(it, 1) },
                colour,
                EDGE,
            )
        }
    }
}
