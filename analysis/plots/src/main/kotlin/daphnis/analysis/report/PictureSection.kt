package daphnis.analysis.report

import daphnis.analysis.plot.PatchPicture

/** The last state as it looks, from above and from the side. */
internal class PictureSection(private val study: Study) : Section {
    override val heading = "The ${study.place}"
    override val over = "${study.overLast} To scale."

    override fun write(page: ReportPage) {
        val last = study.last
        val picture = PatchPicture(last, study.units.length)
        val isTurned = picture.across == 0
        val right = if (isTurned) "x" else "y"
        val axes = when {
            study.isRing && isTurned -> "outward to the right, orbital motion up"
            study.isRing -> "orbital motion to the right, outward up"
            else -> "$right to the right, ${if (isTurned) "y" else "x"} up"
        }
        fun rest(bar: String, part: String?) = "The bar is $bar.${part?.let { " $it." }.orEmpty()}"
        val above = rest(picture.bar, picture.partAbove) + MoonPart.of(study)?.let { " ${it.standing}" }.orEmpty()
        page.png(
            picture.writeAbove(study.plots, "patch-above"),
            "the ${study.place} from above",
            if (last.boundary.space.isPlane) {
                "From above; $axes. $above"
            } else {
                "From above; $axes; higher spheres are brighter. $above"
            },
        )
        if (last.boundary.space.isPlane) return
        val walls = if (study.isRoomCut) " What is behind walls is grey, as in the middle of the box." else ""
        page.png(
            picture.writeSide(study.plots, "patch-side"),
            "the ${study.place} from the side",
            "From the side; $right to the right, z up; nearer spheres are brighter. " +
                "${rest(picture.barSide, picture.partSide)}$walls" +
                picture.leftOutSide?.let { " $it." }.orEmpty(),
        )
    }
}
