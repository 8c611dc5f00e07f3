package daphnis.core.format

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SnapshotCheckTest {
    @Test
    fun `ids are looked through twice at most, however many there are`() {
        for (size in listOf(0, 1, 2, 1000, 100_000)) {
            for (repeats in listOf(false, true)) {
                val ids = IntArray(size) { (it * 7919L % (size + 1)).toInt() }
                if (repeats && size > 1) ids[size / 2] = ids[0]
                var reads = 0L
                val place = SnapshotCheck.lastRepeated(size) {
                    reads++
                    ids[it]
                }
                assertEquals(if (repeats && size > 1) size / 2 else -1, place)
                assertTrue(reads <= 2L * size) { "$reads reads of $size ids" }
            }
        }
    }
}
