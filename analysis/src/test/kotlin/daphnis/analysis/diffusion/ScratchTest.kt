package daphnis.analysis.diffusion

import daphnis.analysis.correlation.Insertion
import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.theory.HardSphereMixture
import daphnis.analysis.theory.HardSpheres
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Test
import java.nio.file.Files
import kotlin.math.PI
import kotlin.math.cbrt

class ScratchTest {
    @Test
    fun scratch() {
        val axes = List(3) { Coordinate.Position(it) }
        val va = List(3) { Coordinate.Velocity(it) }
        for ((phi, nu) in listOf(0.01 to 0.13884, 0.1 to 1.76552, 0.3 to 10.1002, 0.45 to 28.447)) {
            val n = 500
            val m = HardSphereMixture(doubleArrayOf(1.0), doubleArrayOf(phi * 6 / PI))
            println("phi $phi CS ${HardSpheres.carnahanStarlingChemicalPotential(phi)} mix ${m.excessChemicalPotential(1.0)} pt ${m.excessChemicalPotential(0.0)}")
            val edge = cbrt(n * PI / 6 / phi)
            for (hn in listOf(0.1, 0.3)) for (seed in 1..2) {
                val h = hn / nu
                val settings = listOf(
                    "particles={\"count\":$n,\"sizes\":{\"type\":\"equal\",\"radius\":0.5},\"mass\":1}",
                    "box.lengths=[$edge,$edge,$edge]",
                    "velocities={\"type\":\"gaussian\",\"temperature\":1,\"exact\":true}",
                    "timeStep={\"type\":\"fixed\",\"dt\":$h}",
                    "placement={\"type\":\"grown\"}",
                    "output={\"snapshotEvery\":1,\"transportEvery\":10}",
                    "until=${h * 2000}", "seed=$seed",
                )
                val path = Files.createTempDirectory("scr")
                Run.start(BuiltIn.scenario("elastic-gas", settings), "elastic-gas", path).use { it.execute() }
                val input = AnalysisInput.ofRun(path)
                val v = Trajectories(va, input.idsThroughout())
                val x = Trajectories(axes, input.idsThroughout())
                val ins = Averages(Insertion(1.0))
                val f = IntermediateScattering(6.5, 7.5)
                for (k in 200 until input.size) {
                    val s = input.snapshot(k)
                    v.add(s)
                    if (k % 14 == 0) x.add(s)
                    if (k % 40 == 0) ins.add(input.state(k, s))
                    f.add(input.state(k, s))
                }
                val t0 = System.nanoTime()
                val c = VelocityAutocorrelation(v, 150 * h)
                println("hn $hn seed $seed time ${(System.nanoTime() - t0) / 1e9} C(h) ${c.normalised[1]} min ${c.normalised.min()}")
                for (mo in listOf(3, 4, 6, 8)) println("   slope ${c.slope()} vs ${-2 * nu / 3 * n / (n - 1)} ")
                val d = MeanSquareDisplacement(x).diffusion(0, 1, 2)
                val g = d?.let { c.diffusion(it.from, it.to) }
                println("   D ${d?.value} ${d?.error}  ${d?.from}..${d?.to}; GK ${g?.value} ${g?.error}")
                println("   mu ${ins.average(20)} pt ${ins.average(0)}  ${-kotlin.math.ln(1 - phi)}")
                val ov = Overlap(x, 0.3)
                println("   Q ${ov.overlap.take(4)} ${ov.overlapError.take(3)} chi ${ov.susceptibility.take(4)} ${ov.susceptibilityError.take(4)}")
                val ff = f.function()
                println("   F ${f.vectorCount} ${f.waveNumber} ${ff.scattering.take(6)} ${ff.error.take(6)}")
            }
        }
    }
}
