package daphnis.core.scenario

import daphnis.core.hill.Epicycle
import daphnis.core.input.Nearest
import kotlinx.serialization.EncodeDefault
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
public sealed interface ForceSpec {
    @Serializable
    @SerialName("uniform-acceleration")
    public class UniformAcceleration(public val acceleration: List<Double>) : ForceSpec

    /**
     * A moon on a given epicyclic orbit in Hill's frame. The ring feels its gravity; the moon feels no force.
     *
     * @property massRatio mass over that of the planet; exactly one of this and [mass]
     * @property x radial position of its guiding centre
     * @property y azimuthal position of its guiding centre at time 0
     * @property e amplitude of its epicycle in units of length: eccentricity times semi-major axis
     * @property phase φ at time 0 in radians; pericentre at 0
     * @property softening length ε in 1/(r² + ε²)
     * @property radius particles that touch it are removed; 0 for a point
     * @property constant G in the scenario's units, with [mass]; from [Scenario.units] when left out
     * @property inclination amplitude of its vertical swing in units of length: inclination times semi-major axis
     * @property node phase of that swing at time 0 in radians, from the ascending node
     * @property returns whether it comes back after each synodic period
     */
    @OptIn(ExperimentalSerializationApi::class)
    @Serializable
    @SerialName("satellite")
    public class Satellite @JvmOverloads constructor(
        public val massRatio: Double? = null,
        public val mass: Double? = null,
        public val x: Double,
        public val y: Double,
        public val e: Double = 0.0,
        public val phase: Double = 0.0,
        public val softening: Double = 0.0,
        public val radius: Double = 0.0,
        public val constant: Double? = null,
        @EncodeDefault(EncodeDefault.Mode.NEVER) public val inclination: Double = 0.0,
        @EncodeDefault(EncodeDefault.Mode.NEVER) public val node: Double = 0.0,
        @EncodeDefault(EncodeDefault.Mode.NEVER) public val returns: Boolean = false,
    ) : ForceSpec {
        /** Its epicycle at time 0; without [inclination] the vertical phase is 0. */
        public val orbit: Epicycle
            get() = Epicycle(x, y, e, phase, inclination, if (inclination == 0.0) 0.0 else node - Math.PI / 2)
    }

    /**
     * Gravity between the particles.
     *
     * @property openingAngle a node of a tree is taken as one mass when its size is below this times its distance
     * @property softening length ε in 1/(r² + ε²); 0 with modes
     * @property images the range of a tree around each particle is [images] + ½ of the shortest periodic edge
     * @property constant G in the scenario's units; from [Scenario.units] when left out
     * @property spacing between points of a mesh; about one point in the plane per sphere when left out
     * @property modes how many radial waves, with [GravityMethod.RADIAL_MODES] alone
     */
    @Serializable
    @SerialName("self-gravity")
    public class SelfGravity @JvmOverloads constructor(
        public val openingAngle: Double = 0.5,
        public val softening: Double = 0.0,
        public val images: Int = 1,
        public val constant: Double? = null,
        public val method: GravityMethod = GravityMethod.TREE,
        public val spacing: Double? = null,
        public val modes: Int? = null,
    ) : ForceSpec

    /**
     * Gravity of [Scenario.bodies] on all other spheres and, as reaction, of these on the bodies, but not among the
     * other spheres. Nearest images count.
     */
    @Serializable
    @SerialName("body-gravity")
    public class BodyGravity @JvmOverloads constructor(
        public val softening: Double = 0.0,
        public val constant: Double? = null,
    ) : ForceSpec
}
