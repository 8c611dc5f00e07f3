package daphnis.app

import daphnis.app.describe.Rows
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class RowsTest {
    private val rows = Rows().apply {
        add("scenario", "gas")
        add("box", "200 m x 200 m x 20 m, periodic on all of its faces")
        add("box", "and once more")
    }

    @Test
    fun `without an edge each text is a line beside its label`() = assertEquals(
        """
        scenario          gas
        box               200 m x 200 m x 20 m, periodic on all of its faces
                          and once more
        """.trimIndent(),
        rows.text(),
    )

    @Test
    fun `a line that is too long goes on below its text`() = assertEquals(
        """
        scenario          gas
        box               200 m x 200 m x 20 m, periodic
                          on all of its faces
                          and once more
        """.trimIndent(),
        rows.text(48),
    )

    @Test
    fun `on a narrow terminal texts stand below their labels`() = assertEquals(
        """
        scenario
          gas
        box
          200 m x 200 m x 20 m, periodic on all
          of its faces
          and once more
        """.trimIndent(),
        rows.text(40),
    )

    @Test
    fun `no line is wider than the terminal, but for single words`() {
        for (columns in 1..100) {
            for (line in rows.text(columns).lines()) {
                assertTrue(line.length <= columns || ' ' !in line.trim()) { "$columns: '$line'" }
            }
        }
    }
}
