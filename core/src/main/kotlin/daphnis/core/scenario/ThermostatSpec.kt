package daphnis.core.scenario

import kotlinx.serialization.EncodeDefault
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** What heats and cools particles from outside; see [daphnis.core.force.thermostat.Thermostat]. */
@Serializable
public sealed interface ThermostatSpec : ForceSpec {
    /**
     * Exactly one of [intensity], and [temperature] with a [drag].
     *
     * @property intensity ξ² of the noise, the same for all particles, (length/time)² per unit of time
     * @property temperature T of a bath, mass · (length/time)²; then ξ² is 2 γ T/m
     * @property drag γ, per unit of time
     * @property conserveMomentum whether the sum of the kicks is taken back
     */
    @OptIn(ExperimentalSerializationApi::class)
    @Serializable
    @SerialName("white-noise")
    public class WhiteNoise @JvmOverloads constructor(
        @EncodeDefault(EncodeDefault.Mode.NEVER) public val intensity: Double? = null,
        @EncodeDefault(EncodeDefault.Mode.NEVER) public val temperature: Double? = null,
        public val drag: Double = 0.0,
        public val conserveMomentum: Boolean = false,
    ) : ThermostatSpec

    /**
     * @property rate at which each particle gets a new velocity, per unit of time
     * @property temperature T of the bath, mass · (length/time)²
     * @property conserveMomentum whether the sum of the changes is taken back
     */
    @Serializable
    @SerialName("andersen")
    public class Andersen @JvmOverloads constructor(
        public val rate: Double,
        public val temperature: Double,
        public val conserveMomentum: Boolean = false,
    ) : ThermostatSpec

    /**
     * @property temperature T, mass · (length/time)²
     * @property time of relaxation; 0 for at once
     */
    @Serializable
    @SerialName("rescaling")
    public class Rescaling @JvmOverloads constructor(public val temperature: Double, public val time: Double = 0.0) :
        ThermostatSpec
}
