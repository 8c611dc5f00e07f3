package daphnis.core.run

import daphnis.core.input.InputException
import java.io.IOException
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import kotlin.io.path.name

/**
 * Links in a directory that somebody else prepared would lead what is written there to files elsewhere. So a link to a
 * file, or to nothing, is refused, whatever its name; a link to a directory, such as one on another disk, is followed
 * when it belongs to whoever runs this program. The directory itself may be a link.
 */
public object Links {
    /**
     * Checks [directory] and its subdirectories before anything is written there; one that is not there is in order.
     *
     * @param replaces whether files are written elsewhere and moved there, which puts them in the place of links
     * @throws InputException naming the first link that is refused
     */
    @JvmStatic
    @JvmOverloads
    @Throws(IOException::class)
    public fun check(directory: Path, replaces: Boolean = false) {
        if (!Files.isDirectory(directory)) return
        for (entry in entries(directory)) {
            checkOne(entry, replaces)
            if (Files.isDirectory(entry)) for (inner in entries(entry)) checkOne(inner, replaces)
        }
    }

    private fun entries(directory: Path) = Files.list(directory).use { it.sorted().toList() }

    private fun checkOne(entry: Path, replaces: Boolean) {
        if (!Files.isSymbolicLink(entry)) return
        val why = when {
            entry.name in RunLock.FILES -> "is a link, and its target would be written to"
            !Files.isDirectory(entry) -> if (replaces) return else "is a link, and its target would be written to"
            isForeign(entry) -> "is a link to a directory, and belongs to ${Files.getOwner(entry, NOFOLLOW_LINKS)}"
            else -> return
        }
        throw InputException(entry.toString(), null, "$why; remove it, or give another directory")
    }

    /** Whether it belongs to another user than what this process makes; not where files have no owners. */
    private fun isForeign(entry: Path): Boolean = try {
        Files.getOwner(entry, NOFOLLOW_LINKS).name != System.getProperty("user.name")
    } catch (e: UnsupportedOperationException) {
        false
    }
}
