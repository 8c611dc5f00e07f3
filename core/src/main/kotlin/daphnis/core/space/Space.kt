package daphnis.core.space

import daphnis.core.surface.SurfaceContact

/**
 * Space in which particles move: three dimensions, or the plane z = 0, where they are discs. All that counts degrees of
 * freedom, volumes or distances asks here. In the plane a volume is an area, and a density is per area.
 *
 * @property dimensions number of components of a velocity
 * @property rotations number of axes about which a particle can spin; in the plane it is z alone
 * @property closestPacking part of the volume that equal particles fill at most
 * @property momentFactor moment of inertia of a homogeneous particle over mass · radius²
 * @property mostMomentFactor the same of a hollow one, which no other exceeds
 */
public enum class Space(
    public val dimensions: Int,
    public val rotations: Int,
    public val closestPacking: Double,
    public val momentFactor: Double,
    public val mostMomentFactor: Double,
) {
    /** The plane z = 0. All z, v_z, and spins about x and y are exactly 0. */
    PLANE(2, 1, 0.9069, 0.5, 1.0) {
        override fun volume(radius: Double): Double = Math.PI * radius * radius

        override fun edge(volume: Double): Double = Math.sqrt(volume)
    },

    /** Three dimensions. */
    VOLUME(3, 3, 0.7405, SurfaceContact.SOLID, 2.0 / 3.0) {
        override fun volume(radius: Double): Double = 4.0 / 3.0 * Math.PI * radius * radius * radius

        override fun edge(volume: Double): Double = StrictMath.cbrt(volume)
    }, ;

    /** Whether particles are discs in the plane. */
    public val isPlane: Boolean get() = this == PLANE

    /** The bound on the factor of a moment of inertia, for messages. */
    internal val mostMomentInWords: String
        get() = if (isPlane) "at most 1, that of a ring" else "at most 2/3, that of a hollow sphere"

    /** Volume of a sphere of [radius], in the plane the area of a disc. */
    public abstract fun volume(radius: Double): Double

    /** Edge of a cube, in the plane of a square, of [volume]. */
    public abstract fun edge(volume: Double): Double

    public companion object {
        /** That with so many [dimensions], 2 or 3. */
        @JvmStatic
        public fun of(dimensions: Int): Space = requireNotNull(
            entries.find {
                it.dimensions == dimensions
            },
        ) { "there are $dimensions dimensions; 2 or 3 can be" }
    }
}
