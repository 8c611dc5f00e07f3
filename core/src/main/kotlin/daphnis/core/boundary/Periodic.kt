package daphnis.core.boundary

/**
 * A box that repeats along the axes marked in [periodic] (x, y, z) and is open along the others; contacts are found
 * through the faces. A flat box is open along z.
 */
public class Periodic @JvmOverloads constructor(
    override val box: Box,
    periodicX: Boolean = true,
    periodicY: Boolean = true,
    periodicZ: Boolean = true,
) : PerSphereBoundary {
    private val periodic = booleanArrayOf(periodicX, periodicY, periodicZ && !box.space.isPlane)

    override fun keepsFinite(asked: PerSphereBoundary): Boolean = asked === this

    init {
        requireFinite(box) { periodic[it] }
    }

    override fun contactFaces(axis: Int): ContactFaces =
        if (periodic[axis]) ContactFaces.PERIODIC else ContactFaces.OPEN
}
