package daphnis.core.surface

/**
 * What an impact of two spheres does: the coefficients of normal and of tangential restitution, ε and β, as functions
 * of both speeds, radii, masses and materials. [daphnis.core.surface.Restitution] is the law of smooth spheres whose
 * ε depends on the impact speed alone; [Roughness] is a β beside the ε of another law, see [RoughContact].
 *
 * Must be a pure function that gives the same bits on every machine: use [StrictMath] for `pow`, `exp`, `sin`.
 */
public interface ContactLaw {
    /**
     * Whether β is ever other than −1; asked once. Spheres with such a law need spins.
     */
    public val isRough: Boolean

    /**
     * Not asked where a guard makes the impact elastic.
     *
     * @param contact its [SurfaceContact.restitution] is NaN
     * @return ε in [0, 1]; any other number ends the step with an [IllegalArgumentException]
     */
    public fun restitution(contact: SurfaceContact): Double

    /**
     * Asked after [restitution], where surfaces slide, of a law which [isRough].
     *
     * @return β in [−1, 1]; any other number ends the step with an [IllegalArgumentException]
     */
    public fun roughness(contact: SurfaceContact): Double = -1.0

    /** 1 + β, for a law that knows it better than as that sum: near −1 it would lose digits. */
    public fun change(contact: SurfaceContact): Double = 1.0 + roughness(contact)
}

/** ε of the law [normal], and β of [tangential] in place of that law's own. */
public class RoughContact(public val normal: ContactLaw, public val tangential: Roughness) : ContactLaw {
    override val isRough: Boolean get() = true

    override fun restitution(contact: SurfaceContact): Double = normal.restitution(contact)

    override fun roughness(contact: SurfaceContact): Double = tangential.coefficient(contact)

    override fun change(contact: SurfaceContact): Double = tangential.change(contact)
}
