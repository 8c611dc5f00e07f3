package daphnis.core.surface

/**
 * A law for each pair of materials, which does not depend on which of the two is named first. Impacts of pairs that are
 * not named have the law of all [others]. Immutable.
 *
 * ```java
 * ContactLaw law = new MaterialLaws(new ConstantRestitution(0.9)).between(0, 1, new ConstantRestitution(0.3));
 * ```
 */
public class MaterialLaws private constructor(private val table: PairTable<ContactLaw>) : ContactLaw {
    /** Every pair has the law of all [others]. */
    public constructor(others: ContactLaw) : this(PairTable(others))

    /** The law of pairs that are not named. */
    public val others: ContactLaw get() = table.others

    override val isRough: Boolean = table.any { it.isRough }

    /**
     * The same laws, but [law] for impacts of the materials of the numbers [first] and [second], which may be the same.
     */
    public fun between(first: Int, second: Int, law: ContactLaw): MaterialLaws =
        MaterialLaws(table.with(first, second, law))

    override fun restitution(contact: SurfaceContact): Double = table[contact].restitution(contact)

    override fun roughness(contact: SurfaceContact): Double = change(contact) - 1.0

    override fun change(contact: SurfaceContact): Double =
        table[contact].let { if (it.isRough) it.change(contact) else 0.0 }
}

/** The same for β alone; null is smooth. */
public class MaterialRoughness private constructor(private val table: PairTable<Roughness?>) : Roughness {
    /** Every pair has the roughness of all [others]. */
    public constructor(others: Roughness?) : this(PairTable(others))

    /** As [MaterialLaws.between]. */
    public fun between(first: Int, second: Int, roughness: Roughness?): MaterialRoughness =
        MaterialRoughness(table.with(first, second, roughness))

    override fun coefficient(contact: SurfaceContact): Double = change(contact) - 1.0

    override fun change(contact: SurfaceContact): Double = table[contact]?.change(contact) ?: 0.0
}
