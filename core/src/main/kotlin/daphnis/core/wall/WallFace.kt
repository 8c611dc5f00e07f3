package daphnis.core.wall

/**
 * What one wall has of its own.
 *
 * @property restitution its coefficient of restitution, in [0, 1], in place of that of all walls; null for that
 * @property motion how it moves; null when it rests. A [Piston] is not thermal
 * @property temperature T of a thermal wall, mass · (length/time)², > 0; null for one that reflects. From a thermal
 *   wall spheres of mass m leave with velocities drawn from the flux of a gas of that temperature: relative to the
 *   wall, the density of the normal speed c is (m c/T) exp(−m c²/2T), and the components along the wall are normal with
 *   variance T/m. Restitution does not matter there, and the wall is not rough
 */
public class WallFace @JvmOverloads constructor(
    public val restitution: Double? = null,
    public val motion: WallMotion? = null,
    public val temperature: Double? = null,
) {
    init {
        require(restitution == null || restitution in 0.0..1.0) {
            "wall restitution is $restitution; it must be in [0, 1]"
        }
        require(temperature == null || temperature > 0 && temperature.isFinite()) {
            "temperature of a wall is $temperature; it must be > 0"
        }
        require(temperature == null || motion?.isKnownAhead != false) { "a wall is a piston; it cannot be thermal" }
    }
}
