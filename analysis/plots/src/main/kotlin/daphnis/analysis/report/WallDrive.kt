package daphnis.analysis.report

/** What walls do to the spheres, beside stopping them. */
internal object WallDrive {
    /**
     * What to say of numbers around a mean flow of [study] that is not known there: a surface that turns or has a belt
     * drags along what it touches. Nothing where no wall does.
     */
    fun remark(study: Study): String = if (study.input.scenario?.boundary?.surfaces.orEmpty().any { it.slides }) {
        "the flow that walls drag along counts as random motion"
    } else {
        ""
    }
}
