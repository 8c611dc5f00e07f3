package daphnis.core.surface

import daphnis.core.input.Kind
import daphnis.core.input.Kinds
import daphnis.core.input.Quantities
import daphnis.core.input.ValueCheck
import kotlinx.serialization.Serializable

/**
 * The coefficient of normal restitution ε as a scenario describes it: what others ask of a law is asked here, and nobody
 * asks which law it is. All its speeds are in cm/s. Only [law] and [inWords] must be said.
 */
@Serializable(RestitutionKinds::class)
public interface RestitutionSpec {
    /** ε of a law that has the same in every impact; else null. */
    public val constant: Double? get() = null

    /** ε at the lowest speeds: below 1 spheres can collapse. */
    public val atRest: Double get() = constant ?: 1.0

    /** Whether impacts lose energy however slow they are; laws that are elastic for slow ones end all cooling. */
    public val losesAlways: Boolean get() = atRest < 1

    /** Whether ε depends on radii and masses, too. */
    public val dependsOnSize: Boolean get() = false

    /**
     * The law, with its values checked.
     *
     * @throws daphnis.core.input.InputException for values that are wrong
     */
    public fun law(place: LawPlace): ContactLaw

    /** A description for a reader, with its numbers. */
    public fun inWords(say: Quantities): String
}

/**
 * Where a law stands in a scenario.
 *
 * @property key what messages call it
 * @property cmPerSecond how many cm/s one unit of speed is
 * @property isOfPair whether it is that of a pair of materials
 * @param massOf the mass that a sphere of a radius has; null where that is not known
 */
public class LawPlace @JvmOverloads constructor(
    public val key: String,
    public val cmPerSecond: Double,
    public val check: ValueCheck,
    public val isOfPair: Boolean = false,
    private val massOf: (radius: Double) -> Double? = { null },
    measured: () -> MeasuredSphere? = { null },
) {
    /** The sphere of which two have the coefficient of a law that names no sphere; null where spheres differ. */
    public val measured: MeasuredSphere? by lazy(measured)

    /** The mass of a sphere of [radius]; null where it is not known. */
    public fun mass(radius: Double): Double? = massOf(radius)
}

/**
 * A sphere of which two have a coefficient that was measured.
 *
 * @property mass null for what a sphere of [radius] has
 */
public class MeasuredSphere @JvmOverloads constructor(public val radius: Double, public val mass: Double? = null)

/** The laws that a scenario can name. */
internal object RestitutionKinds : Kinds<RestitutionSpec>(
    RestitutionSpec::class,
    listOf(
        Kind(ConstantRestitutionSpec::class, ConstantRestitutionSpec.serializer()),
        Kind(BridgesSpec::class, BridgesSpec.serializer()),
        Kind(BorderiesSpec::class, BorderiesSpec.serializer()),
        Kind(StepRestitutionSpec::class, StepRestitutionSpec.serializer()),
        Kind(TableRestitutionSpec::class, TableRestitutionSpec.serializer()),
        Kind(ViscoelasticSpec::class, ViscoelasticSpec.serializer()),
    ),
)
