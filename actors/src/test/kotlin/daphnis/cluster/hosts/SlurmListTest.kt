package daphnis.cluster.hosts

import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SlurmListTest {
    @Test
    fun `ranges and single numbers are expanded in their order, with leading zeros`() {
        assertEquals(listOf("n001", "n002", "n003", "n07", "login2"), SlurmList.hosts("n[001-003,07],login2"))
        assertEquals(listOf("n9", "n10", "n11"), SlurmList.hosts("n[9-11]"))
        assertEquals(listOf("n099", "n100"), SlurmList.hosts("n[099-100]"))
        assertEquals(listOf("r1n1", "r1n2", "r2n1", "r2n2"), SlurmList.hosts("r[1-2]n[1-2]"))
        assertEquals(listOf("n1-ib", "n2-ib"), SlurmList.hosts("n[1-2]-ib"))
        assertEquals(listOf("a", "b.c-d"), SlurmList.hosts("a,b.c-d"))
    }

    @Test
    fun `what is wrong is named`() {
        for ((text, what) in mapOf(
            "" to "'' is no name of a host",
            "n1,," to "'' is no name",
            "n[1-3" to "brackets do not match",
            "n1-3]" to "brackets do not match",
            "n[[1]]" to "brackets do not match",
            "n[a-b]" to "'a-b' is no number",
            "n[]" to "'' is no number",
            "n[3-1]" to "ends before it begins",
            "n[1-999999999]" to "more than",
            "n[1-1000][1-1000][1-1000]" to "more than",
            "n[1-99999999999]" to "is no number",
            "-n" to "no name",
        )) {
            val e = assertThrows(InputException::class.java, { SlurmList.hosts(text) }, text)
            assertTrue(what in e.message!!) { e.message }
        }
    }
}
