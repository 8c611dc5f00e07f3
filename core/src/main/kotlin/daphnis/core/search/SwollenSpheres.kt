package daphnis.core.search

import daphnis.core.population.SphereColumns
import daphnis.core.population.SphereQuantity

/**
 * The spheres of another object as a search for events at a distance sees them: with radii larger by a factor. Made
 * once, reused for any spheres.
 */
internal class SwollenSpheres : SphereColumns {
    private var spheres: SphereColumns? = null
    private var radii = DoubleArray(0)

    /** These [of], each with its radius times [factor]. Allocates when there are more than before. */
    fun take(of: SphereColumns, factor: Double): SphereColumns {
        spheres = of
        if (radii.size < of.size) radii = DoubleArray(of.size + of.size / 8)
        for (k in 0 until of.size) radii[k] = of.radius[k] * factor
        return this
    }

    override val size: Int get() = spheres!!.size
    override val id: IntArray get() = spheres!!.id

    override fun column(place: Int): DoubleArray = if (place == RADIUS) radii else spheres!!.column(place)

    private companion object {
        val RADIUS = SphereQuantity.RADIUS.place
    }
}
