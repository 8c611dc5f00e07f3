package daphnis.analysis.report

/**
 * The rows of a table of numbers on how particles spin.
 *
 * @param omega angular speed of Hill's frame, null without one
 */
internal class SpinNumbers(private val study: Study, private val rows: NumberRows, private val omega: Double?) {
    private val space = study.last.boundary.space

    /** Adds them; none for spheres without spins. */
    fun add() {
        val rotation = study.motion.rotation ?: return
        val speed = if (omega == null) 1.0 else study.bulk.meanRadius * omega
        rows.average(
            "rotational_temperature",
            "rotational temperature Σ I ω²/${if (space.isPlane) "" else "3"}M",
            rotation.temperature * (1 / (speed * speed)),
            if (omega == null) study.units.temperature else "r² Ω²",
            "with the mean spin in it",
        )
        // Of spheres that only spin there is none.
        if (study.input.hasVelocities && rotation.ratio.mean.isFinite()) {
            rows.average(
                "rotational_over_translational",
                "rotational over translational temperature",
                rotation.ratio,
                "",
                if (omega == null) "" else "translational: c²/3",
            )
        }
        if (omega != null) {
            val note = "relative to the rotating frame; among the stars Ω more"
            rows.average("mean_spin_z", "mean spin ω_z", rotation.mean(2) * (1 / omega), "Ω", note)
            return
        }
        for ((axis, name) in listOf("x", "y", "z").withIndex().drop(3 - space.rotations)) {
            rows.average("mean_spin_$name", "mean spin ω_$name", rotation.mean(axis), study.units.rate)
        }
    }

    /** Adds the fourth cumulants of a gas; of spheres at rest there are none. */
    fun addCumulants() {
        val flow = WallDrive.remark(study)
        val ofVelocities = study.motion.cumulant("a2")
        if (ofVelocities.mean.isNaN()) return
        rows.average(
            "velocity_a2",
            "fourth cumulant a₂ of velocities",
            ofVelocities,
            "",
            "⟨c⁴⟩ = ${if (space.isPlane) "2" else "(5/3)"} ⟨c²⟩² (1 + a₂), of √m c; 0 for Maxwellians of one " +
                "temperature" +
                (if (flow.isEmpty()) "" else "; $flow"),
        )
        if (study.motion.rotation == null) return
        val ofSpins = "the same of spins; 0 for a Maxwellian"
        rows.average("spin_a2", "fourth cumulant a₀₂ of spins", study.motion.cumulant("spin_a2"), "", ofSpins)
        val ofBoth = "⟨c² ω²⟩ = ⟨c²⟩ ⟨ω²⟩ (1 + a₁₁); 0 where speed and spin are independent"
        rows.average("mixed_a2", "fourth cumulant a₁₁ of both", study.motion.cumulant("mixed_a2"), "", ofBoth)
    }
}
