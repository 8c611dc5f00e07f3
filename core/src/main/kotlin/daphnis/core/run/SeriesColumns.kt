package daphnis.core.run

import daphnis.core.CommonNumber
import daphnis.core.format.Snapshot
import daphnis.core.table.Column
import daphnis.core.table.Columns
import daphnis.core.table.Dimension
import daphnis.core.table.Need
import daphnis.core.table.TableColumns
import daphnis.core.wall.pistons
import java.nio.file.Path

/**
 * The columns of `series.csv`. A further quantity is a further declaration here. Those from [ROTATIONAL_ENERGY] on are
 * only there where spheres have spins, [FILLING_FACTOR] and [REDUCED_PRESSURE] where they grow, those of a piston where
 * that wall is one, and [EDGE_EVENTS] where spheres have interactions. Those of [exchanged] are there for each source.
 */
public object SeriesColumns : TableColumns {
    internal val rows = Columns<SeriesRow>("series.csv")
    override val file: String get() = rows.file
    override val columns: List<Column> get() = rows.columns

    @JvmField
    public val STEP: Column = rows.step { it.simulation.step }

    @JvmField
    public val TIME: Column = rows.time { it.simulation.time }

    @JvmField
    public val PARTICLES: Column = rows.particles { it.sums.count.toLong() }

    @JvmField
    public val COLLISIONS: Column = rows.whole(
        "collisions",
        "between two spheres, since the start",
        Need.NEEDED,
    ) { it.simulation.collisions?.counters?.collisions ?: 0 }

    @JvmField
    public val KINETIC_ENERGY: Column = rows.number(
        "kinetic_energy",
        "Σ m v²/2 with the mean flow in it, bodies included",
        Dimension.ENERGY,
    ) { it.sums.kineticEnergy }

    @JvmField
    public val GRANULAR_TEMPERATURE: Column = rows.number(
        "granular_temperature",
        "⟨c²⟩/3 (discs: /2) of the particles, weighted by mass, c the peculiar velocity",
        Dimension.SPEED_SQUARED,
    ) { it.sums.granularTemperature }

    @JvmField
    public val RMS_COMPONENT_SPEED: Column = rows.number(
        "rms_component_speed",
        "√(2 E/3M) (discs: √(E/M)), E the kinetic energy and M the mass",
        Dimension.SPEED,
    ) { it.sums.rmsComponentSpeed }

    @JvmField
    public val MOMENTUM: List<Column> = rows.each(
        listOf("momentum_x", "momentum_y", "momentum_z"),
        "Σ m v, bodies included",
        Dimension.MOMENTUM,
    ) { row, axis ->
        row.sums.momentum(axis)
    }

    @JvmField
    public val POTENTIAL_ENERGY: Column = rows.number(
        "potential_energy",
        "in all forces, see below; 0 without forces",
        Dimension.ENERGY,
    ) { it.energies.potential }

    @JvmField
    public val TOTAL_ENERGY: Column = rows.number(
        "total_energy",
        "kinetic + rotational + potential; NaN in Hill's frame",
        Dimension.ENERGY,
    ) { it.energies.total }

    @JvmField
    public val HILL_ENERGY: Column = rows.number(
        "hill_energy",
        "Σ m (v²/2 − (2Ω² − κ²/2)x² + ν²z²/2) + rotational + potential, in Hill's frame only; with that of " +
            "satellites that feel the ring",
        Dimension.ENERGY,
    ) { it.energies.hill }

    @JvmField
    public val ROTATIONAL_ENERGY: Column = rows.number(
        "rotational_energy",
        "Σ I ω²/2; this and the next three only where spheres spin",
        Dimension.ENERGY,
    ) { it.spins?.energyOfRotation ?: Double.NaN }

    @JvmField
    public val ROTATIONAL_TEMPERATURE: Column = rows.number(
        "rotational_temperature",
        "Σ I ω² / 3M (discs: Σ I ω² / M), to be compared with `granular_temperature`",
        Dimension.SPEED_SQUARED,
    ) { it.spins?.temperature ?: Double.NaN }

    @JvmField
    public val MEAN_SPIN: List<Column> = rows.each(
        listOf("mean_spin_x", "mean_spin_y", "mean_spin_z"),
        "mean of ω over all spheres",
        Dimension.ANGULAR_SPEED,
    ) { row, axis ->
        row.spins?.mean(axis) ?: Double.NaN
    }

    @JvmField
    public val ANGULAR_MOMENTUM: List<Column> = rows.each(
        listOf("angular_momentum_x", "angular_momentum_y", "angular_momentum_z"),
        "Σ (m r × v + I ω) about the origin; NaN where the box repeats, and in Hill's frame",
        Dimension.ACTION,
    ) { row, axis -> row.angularMomentum(axis) }

    @JvmField
    public val FILLING_FACTOR: Column = rows.number(
        "filling_factor",
        "of the box; this and the next only where spheres grow",
    ) { row ->
        CommonNumber.FILLING_FACTOR.anywhere(row.simulation)
    }

    @JvmField
    public val REDUCED_PRESSURE: Column = rows.number(
        "reduced_pressure",
        "P V/(N k T) in the last step, from the energy that growing spheres gave; NaN before the first step",
    ) { it.growth?.reducedPressure ?: Double.NaN }

    private val FACES = listOf("lower_x", "upper_x", "lower_y", "upper_y", "lower_z", "upper_z")

    @JvmField
    public val PISTON_POSITION: List<Column> = rows.each(
        FACES.map { "piston_position_$it" },
        "displacement of a piston from the face of the box; these and the next only for walls that are pistons",
        Dimension.LENGTH,
    ) { row, face ->
        row.pistons[face]?.position ?: Double.NaN
    }

    @JvmField
    public val PISTON_SPEED: List<Column> = rows.each(
        FACES.map { "piston_speed_$it" },
        "its velocity along the axis",
        Dimension.SPEED,
    ) { row, face ->
        row.pistons[face]?.speed ?: Double.NaN
    }

    @JvmField
    public val PISTON_ENERGY: Column = rows.number(
        "piston_energy",
        "Σ M V²/2 − F · position over all pistons; with `total_energy` conserved where impacts are elastic, " +
            "to what the step loses",
        Dimension.ENERGY,
    ) { row -> row.pistons.values.sumOf { it.energy } }

    /** Position and speed of each piston at [state], by face, as the file at [path] has it; null without its row. */
    internal fun pistons(path: Path, state: Snapshot): Map<Int, List<Double>>? {
        val row = RowsOfState.read(path, state, TIME).singleOrNull() ?: return null
        return FACES.indices.mapNotNull { face ->
            val position = row[PISTON_POSITION[face]] ?: return@mapNotNull null
            face to listOf(position, row[PISTON_SPEED[face]] ?: return@mapNotNull null)
        }.toMap()
    }

    private val ofGrowth = setOf(FILLING_FACTOR, REDUCED_PRESSURE)
    private val ofRotation = MEAN_SPIN.toSet() + ANGULAR_MOMENTUM + ROTATIONAL_ENERGY + ROTATIONAL_TEMPERATURE

    /** Name of the column of the partial temperature, an energy, of [material] in runs with materials. */
    @JvmStatic
    public fun temperatureOf(material: String): String = "temperature_$material"

    @JvmField
    public val EDGE_EVENTS: Column = rows.whole(
        "edge_events",
        "passages and reflections at edges since the start; only where spheres have interactions",
    ) { it.simulation.collisions?.counters?.edgeEvents ?: 0 }

    /**
     * What the source number [source] has brought and taken since the start: spheres that came, that left, and that
     * found no place; and what came less what left of mass, momentum along x, y, z, and kinetic energy with that of
     * rotation.
     */
    @JvmStatic
    public fun exchanged(source: Int): List<String> = listOf(
        "came",
        "left",
        "refused",
        "mass",
        "momentum_x",
        "momentum_y",
        "momentum_z",
        "energy",
    ).map { "source${source}_$it" }

    private fun Columns<SeriesRow>.addExchanged(k: Int) {
        val (came, left, refused, mass) = exchanged(k)
        whole(
            came,
            "spheres that came since the start; this and what follows for each of `sources`, counted from 0",
        ) { it.exchanged.came(k) }
        whole(
            left,
            "that left; `particles` is that of the first row, plus all that came, less all that left",
        ) { it.exchanged.left(k) }
        whole(refused, "that found no place") { it.exchanged.refused(k) }
        number(mass, "of what came less what left", Dimension.MASS) { it.exchanged.mass(k) }
        each(exchanged(k).subList(4, 7), "of what came less what left", Dimension.MOMENTUM) { row, axis ->
            row.exchanged.momentum(k, axis)
        }
        number(
            exchanged(k).last(),
            "of what came less what left, kinetic and of rotation",
            Dimension.ENERGY,
        ) { it.exchanged.energy(k) }
    }

    /** The columns of a run, at the end with one for each of [materials] and those for each of so many [sources]. */
    internal fun of(
        hasSpins: Boolean,
        materials: List<String>,
        grow: Boolean = false,
        pistons: Set<Int> = emptySet(),
        haveEdges: Boolean = false,
        sources: Int = 0,
    ): Columns<SeriesRow> {
        val ofEdges = if (haveEdges) emptyList() else listOf(EDGE_EVENTS)
        val none =
            (if (hasSpins) emptySet() else ofRotation) + (if (grow) emptySet() else ofGrowth) + without(pistons) +
                ofEdges
        return rows.without(none).also { all ->
            materials.forEachIndexed { k, name ->
                all.number(
                    temperatureOf(name),
                    "m ⟨c²⟩/3 (discs: /2) of the particles of a material, for each that there is",
                    Dimension.ENERGY,
                ) { it.materials?.temperature(k) ?: Double.NaN }
            }
            for (k in 0 until sources) all.addExchanged(k)
        }
    }

    /** What is not there where the faces [pistons] alone are such. */
    private fun without(pistons: Set<Int>): List<Column> {
        val others = FACES.indices.filter { it !in pistons }.flatMap { listOf(PISTON_POSITION[it], PISTON_SPEED[it]) }
        return if (pistons.isEmpty()) others + PISTON_ENERGY else others
    }
}
