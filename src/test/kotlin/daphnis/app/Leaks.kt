package daphnis.app

import com.tngtech.archunit.core.domain.JavaCall
import com.tngtech.archunit.core.domain.JavaClasses
import com.tngtech.archunit.core.domain.JavaCodeUnit
import java.io.IOException

/**
 * The functions of [classes] that let an [IOException] out, by their bytecode: they call one that declares it, or one
 * of these, and do not catch it. What is called through a lambda or an interface that declares nothing is not seen.
 */
internal class Leaks(classes: JavaClasses) {
    val units: Set<JavaCodeUnit>

    init {
        val all = classes.flatMap { it.codeUnits }
        val found = HashSet<JavaCodeUnit>()
        do {
            val more = all.filter { unit -> unit !in found && unit.callsFromSelf.any { isOpen(it, found) } }
        } while (found.addAll(more))
        units = found
        for (u in found) {
            if ("Surroundings" in u.fullName ||
                "scenario" in u.fullName
            ) {
                for (c in u.callsFromSelf) {
                    if (isOpen(c, found)) {
                        println(
                            "LEAK " + u.fullName + " -> " + c.target.fullName,
                        )
                    }
                }
            }
        }
    }

    private fun isOpen(call: JavaCall<*>, found: Set<JavaCodeUnit>): Boolean {
        val target = call.target.resolveMember().orElse(null) ?: return false
        val throws = target in found || target.throwsClause.any { it.rawType.isAssignableTo(IOException::class.java) }
        return throws && !isCaught(call)
    }

    /** `use` of Kotlin catches every Throwable and throws it again. */
    private fun isCaught(call: JavaCall<*>): Boolean = call.origin.tryCatchBlocks.any { block ->
        call in block.accessesContainedInTryBlock && block.caughtThrowables.any { it.name in CATCHING }
    }

    private companion object {
        val CATCHING = setOf(IOException::class.java.name, Exception::class.java.name)
    }
}
