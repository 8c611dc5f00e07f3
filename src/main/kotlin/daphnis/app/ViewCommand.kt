package daphnis.app

import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.int
import daphnis.app.live.ViewPage
import daphnis.app.live.requirePort
import daphnis.app.printing.flushPrinted
import daphnis.app.printing.printLine
import daphnis.core.run.Run

/** `daphnis view`: the states of a run in a browser, in space. */
class ViewCommand : CliktCommand(name = "view") {
    private val run by argument("run", help = "run directory", completionCandidates = Candidates.files)
    private val port by option("--port", help = "where to listen on this machine (default: any free port)").int()
        .default(0)

    override fun help(context: Context) = "Serve a page that shows the states of a run in 3-D."

    override fun run() {
        requirePort("--port", port)
        val recorded = Run.open(pathOf(run, "run"))
        ViewPage(recorded, port).use { page ->
            // Ctrl-C ends the process when hooks have run: pages that are open are told.
            val hook = Thread { page.close() }
            Runtime.getRuntime().addShutdownHook(hook)
            printLine("view: ${page.address} (Ctrl-C ends it)")
            flushPrinted()
            try {
                page.serve()
            } catch (e: InterruptedException) {
                Runtime.getRuntime().removeShutdownHook(hook)
            }
        }
    }
}
