package daphnis.core.boundary

/**
 * Reflecting walls: the surface of a sphere never passes a face; its normal velocity is reversed at the moment of
 * contact and multiplied by [wallRestitution]. Axes for which [walled] is false are periodic.
 */
public class Walls @JvmOverloads constructor(
    override val box: Box,
    override val wallRestitution: Double = 1.0,
    private val walled: BooleanArray = booleanArrayOf(true, true, true),
) : PerSphereBoundary {
    init {
        requireFinite(box) { true }
        require(wallRestitution in 0.0..1.0) { "wall restitution is $wallRestitution; it must be in [0, 1]" }
        require(walled.size == AXES) { "walled has ${walled.size} entries, one for each of x, y, z is needed" }
    }

    override fun contactFaces(axis: Int): ContactFaces = if (walled[axis]) ContactFaces.WALL else ContactFaces.PERIODIC
}
