package daphnis.core.engine.horizon

import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Test

class FilterChoiceTest {
    private val quick = object : LineFilter by ScalarFilter {}

    @Test
    fun `large systems use the quick filter at once, small ones when they have gone on for long`() {
        assertSame(quick, FilterChoice(quick, always = false).choose(20_000))
        assertSame(quick, FilterChoice(quick, always = true).choose(1))
        val choice = FilterChoice(quick, always = false)
        repeat(199) {
            choice.passed(10_000)
            assertSame(ScalarFilter, choice.choose(10_000))
        }
        choice.passed(10_000)
        assertSame(quick, choice.choose(10_000))
        assertSame(quick, choice.choose(1))
    }
}
