package daphnis.analysis.report

import daphnis.analysis.table.UnitNames
import daphnis.analysis.transport.HelfandBulkViscosity
import daphnis.analysis.transport.HelfandConductivity
import daphnis.analysis.transport.HelfandViscosity
import daphnis.analysis.transport.Transport

/** The quantities of a box without Hill's frame, at rest or sheared. */
internal class BoxNumbers(private val study: Study) {
    private val units = study.units
    private val bulk = study.bulk
    private val motion = study.motion
    private val population = study.last.population
    private val flow = study.last.boundary.meanFlow
    private val space = study.last.boundary.space
    private val rows = NumberRows(references())

    fun rows(): List<NumberRow> {
        val transport = motion.transport
        val hasPiston = PistonVolume.isSeen(study)
        val isUniform = !DrivenWalls.isUnderGravity(study) && !hasPiston
        if (hasPiston) {
            val (key, name) = if (space.isPlane) "area" to "area A" else "volume" to "volume V"
            val unit = units.of(if (space.isPlane) "length^2" else "length^3")
            PistonVolume.average(study)?.let { rows.average(key, "$name between the walls", it, unit) }
        } else if (!isUniform) {
            // Of a bed that ends somewhere below the roof both would be numbers of the roof.
        } else {
            val (key, name) =
                if (space.isPlane) "area_fraction" to "area fraction ν" else "filling_factor" to "filling factor φ"
            if (study.input.scenario?.sources.orEmpty().isEmpty()) {
                rows.exact(key, name, bulk.fillingFactor, "")
            } else {
                rows.average(key, name, motion.fillingFactor, "")
            }
        }
        rows.exact("mean_radius", "mean radius", bulk.meanRadius, units.length)
        if (!study.input.hasVelocities) return rows.list()
        val isOld = flow != null && transport?.isPeculiar == false
        rows.average(
            "granular_temperature",
            "granular temperature ⟨c²⟩/${space.dimensions}",
            motion.temperature,
            units.temperature,
            if (isOld) {
                "around the boundary's straight flow: transport.csv is of an older version"
            } else {
                WallDrive.remark(study).ifEmpty { bulk.byMass.removePrefix(", ") }
            },
        )
        val further = SpinNumbers(study, rows, null)
        further.addCumulants()
        further.add()
        if (transport == null) return rows.list()
        rows.average("collisions_per_particle", "collisions per particle", transport.collisionRate, units.rate)
        if (isUniform) {
            val name = "compressibility p ${if (space.isPlane) "A" else "V"} / (M T)"
            rows.average("compressibility", name, transport.compressibility, "")
        }
        transport.wallBalance?.takeUnless { it.mean.isNaN() }?.let {
            rows.average("wall_work_over_dissipation", "work of walls over dissipation", it, "", "1 in a steady state")
        }
        if (flow != null && flow.rate != 0.0) sheared(transport, flow.rate)
        atRest()
        return rows.list()
    }

    /** What the stresses of a gas at rest tell as they fluctuate. In the plane the integral of theirs has no limit. */
    private fun atRest() {
        val scenario = study.physics ?: return
        if (!ElasticGas.isAtRest(scenario, study.last) || scenario.growth != null || space.isPlane) return
        val table = study.input.transport?.from(study.from) ?: return
        val (volume, diameter) = study.last.boundary.box.volume to 2 * bulk.meanRadius
        val unit = units.of("mass/(length time)")
        HelfandViscosity.of(table, volume, diameter)?.let {
            rows.average("viscosity_helfand", "shear viscosity η", it.average, unit, lags(it.lag))
        }
        HelfandBulkViscosity.of(table, volume, diameter)?.let {
            rows.average("bulk_viscosity_helfand", "bulk viscosity κ", it.average, unit, lags(it.lag))
        }
        if (!ElasticGas.isSeen(scenario, study.last)) return
        HelfandConductivity.of(table, volume, diameter)?.let {
            val name = "heat conductivity λ/k"
            rows.average("conductivity_helfand", name, it.average, units.of("1/(length time)"), lags(it.lag))
        }
    }

    private fun lags(longest: Double): String = "Einstein–Helfand, slope over lags from " +
        "${ReportText.short(longest / 2)} to ${UnitNames.amount(ReportText.short(longest), units.time)}"

    private fun references(): Map<String, Reference> {
        val scenario = study.physics ?: return emptyMap()
        // They are of the density of the box.
        if (PistonVolume.isSeen(study)) return emptyMap()
        val (last, filling) = study.last to bulk.fillingFactor
        return ElasticReferences.of(scenario, last, filling, motion.temperature.mean, bulk.numberDensity) +
            CoolingReferences.of(scenario, last) +
            References.ofHeated(scenario, last, bulk.numberDensity) +
            References.ofShear(scenario, last, filling) +
            References.ofDiluteShear(scenario, last, filling)
    }

    /** T/(γσ)², stresses over ρ_p σ²γ² with ρ_p the mass of a sphere over its volume, of a disc over its area. */
    private fun sheared(transport: Transport, rate: Double) {
        val mass = population.mass.sum()
        val diameter = 2 * bulk.meanRadius
        val gamma2 = rate * rate * diameter * diameter
        val stress =
            mass / study.last.boundary.box.volume /
                (population.mass.average() / space.volume(diameter / 2) * gamma2)
        val one = if (space.isPlane) "disc" else "sphere"
        val note = "γ: shear rate; σ in T*, p*, τ*: mean diameter; ρ_p: density of a $one"
        rows.average("reduced_temperature", "temperature T* = T/(γσ)²", transport.temperature * (1 / gamma2), "", note)
        rows.average("reduced_pressure", "pressure p* = p/(ρ_p σ²γ²)", transport.pressure * stress, "")
        val shearStress = transport.pressure("xy") * (-stress * Math.signum(rate))
        rows.average("reduced_shear_stress", "shear stress τ* = −P_xy/(ρ_p σ²γ²)", shearStress, "")
        normalStresses(transport)
        val ratio = transport.pressureRatio("xy") * -Math.signum(rate)
        rows.average("shear_stress_ratio", "shear stress −P_xy/p", ratio, "")
        rows.average("viscosity_translational", "viscosity, translational", transport.translational, units.viscosity)
        rows.average("viscosity_collisional", "viscosity, collisional", transport.collisional, units.viscosity)
        rows.average("viscosity_total", "viscosity, total", transport.viscosity, units.viscosity)
        rows.average(
            "shear_work_over_dissipation",
            "γ² ν over dissipation",
            transport.energyBalance,
            "",
            "1 in a steady state",
        )
    }

    /** They add up to the number of dimensions. */
    private fun normalStresses(transport: Transport) {
        for (axis in "xyz".take(space.dimensions)) {
            val name = "normal stress P_$axis$axis/p"
            rows.average("normal_stress_$axis$axis", name, transport.pressureRatio("$axis$axis"), "")
        }
    }
}
