package daphnis.analysis.plot

private const val NO_FONTS =
    "this Java has no fonts to draw with; install fontconfig and some, such as those of the package fonts-dejavu-core"
private const val HEADLESS = "java.awt.headless"

/**
 * Does [draw], which draws into pictures in memory: without a display, whatever the environment says of one.
 *
 * @throws IllegalStateException when this Java cannot draw
 */
internal fun <T> drawing(draw: () -> T): T = try {
    if (System.getProperty(HEADLESS) == null) System.setProperty(HEADLESS, "true")
    draw()
} catch (e: LinkageError) {
    throw IllegalStateException("this Java has no library to draw with: ${e.message}", e)
} catch (e: InternalError) {
    throw IllegalStateException(NO_FONTS, e)
}
