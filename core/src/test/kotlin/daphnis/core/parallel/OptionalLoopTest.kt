package daphnis.core.parallel

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.util.concurrent.atomic.AtomicInteger

class OptionalLoopTest {
    private fun pieces(run: (RangeBody) -> Unit): Int {
        val pieces = AtomicInteger()
        run { _, _, _ -> pieces.incrementAndGet() }
        return pieces.get()
    }

    @Test
    fun `the caller alone does the loops of steps, and light loops of others`() {
        FixedPool(2).use { pool ->
            val loop = OptionalLoop(ParallelLoop(pool, LoopStrategy.DYNAMIC))
            val others = loop.forOthers
            for (isAlone in listOf(false, true)) {
                loop.isAlone = isAlone
                fun check(isOne: Boolean, run: (RangeBody) -> Unit) {
                    val pieces = pieces(run)
                    if (isOne) assertEquals(1, pieces) else assertTrue(pieces > 5) { "$pieces pieces" }
                }
                check(isAlone) { loop.run(SIZE, it) }
                check(isAlone) { loop.run(SIZE, 100, it) }
                check(isAlone) { loop.runLight(SIZE, it) }
                check(isAlone) { others.runLight(SIZE, it) }
                check(false) { others.run(SIZE, it) }
                check(false) { others.run(SIZE, 100, it) }
            }
        }
    }

    private companion object {
        const val SIZE = 20_000
    }
}
