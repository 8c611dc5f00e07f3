package daphnis.analysis.report

import daphnis.analysis.plot.PatchPicture

/** The last state as it looks, from above and from the side. */
internal class PictureSection(private val study: Study) : Section {
    override val heading = "The patch"
    override val over = "${study.overLast} To scale."

    override fun write(page: ReportPage) {
        val last = study.last
        val picture = PatchPicture(last, study.units.length)
        fun part(isPart: Boolean) = if (isPart) " The first part of its length." else ""
        val axes = if (study.isRing) "orbital motion to the right, outward up" else "y to the right, x up"
        page.png(
            picture.writeAbove(study.plots, "patch-above"),
            "the patch from above",
            if (last.boundary.space.isPlane) {
                "$axes. The bar is ${picture.bar}.${part(picture.isPartAbove)}".replaceFirstChar { it.uppercase() }
            } else {
                "From above; $axes; higher spheres are brighter. The bar is ${picture.bar}.${part(picture.isPartAbove)}"
            },
        )
        if (last.boundary.space.isPlane) return
        page.png(
            picture.writeSide(study.plots, "patch-side"),
            "the patch from the side",
            "From the side; y to the right, z up; nearer spheres are brighter. The bar is ${picture.barSide}." +
                part(picture.isPartSide),
        )
    }
}
