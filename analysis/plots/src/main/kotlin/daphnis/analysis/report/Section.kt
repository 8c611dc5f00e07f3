package daphnis.analysis.report

import daphnis.analysis.insitu.State
import daphnis.core.format.Snapshot

/** Something that the report shows, from the states that are averaged: its quantities, its words and its figures. */
internal interface Part {
    /** Takes in one more of the states that are averaged. */
    fun add(state: State) = Unit

    /** Writes onto [page], after the last state. */
    fun write(page: ReportPage)
}

/** A section of the report. To add one, write it in a file of its own and name it in [Sections]. */
internal interface Section : Part {
    val heading: String

    /** What it shows and over which states: the first line under the heading. */
    val over: String

    /** Whether it is about runs of this kind; when it is not, the report is silent about it. */
    val applies: Boolean get() = true

    /** Whether it has a place on the page, and not only rows in the table of numbers. */
    val isWritten: Boolean get() = true

    /** Why it would mean nothing here, as the end of a sentence; null when it means something. Asked at the end. */
    val leftOut: String? get() = null

    /** Indices of the states that it is to [follow], ascending, beside those that are averaged. */
    val followed: List<Int> get() = emptyList()

    /** Takes in the next of the states that it follows, as its file holds it. */
    fun follow(snapshot: Snapshot) = Unit

    /** Its rows in the table of numbers. */
    fun numbers(): List<NumberRow> = emptyList()

    /** Rows of a table of numbers of its own; asked for at the end. */
    fun ownNumbers(): List<NumberRow> = emptyList()
}
