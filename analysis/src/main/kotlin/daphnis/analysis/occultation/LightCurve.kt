package daphnis.analysis.occultation

/**
 * What an instrument sees of a star that passes behind a patch: the share of the light that comes through, by track and
 * by place along it. Footprints of a track touch, and tracks lie side by side.
 *
 * @property transmission `[track][place]`
 * @property step distance from place to place along the path
 * @property rays in each footprint
 */
public class LightCurve internal constructor(
    public val transmission: Array<DoubleArray>,
    public val step: Double,
    public val rays: Int,
) {
    /** Footprints of all tracks together. */
    public val size: Int get() = transmission.sumOf { it.size }

    /** Counts of photons in the place of the transmission, in units of their mean number without a patch. */
    public fun counted(photons: PhotonCounts): LightCurve =
        LightCurve(Array(transmission.size) { photons.of(transmission[it]) }, step, rays)
}
