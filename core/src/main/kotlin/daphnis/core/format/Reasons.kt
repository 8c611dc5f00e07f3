@file:JvmName("Reasons")

package daphnis.core.format

import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.AccessDeniedException
import java.nio.file.DirectoryNotEmptyException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.FileSystemException
import java.nio.file.FileSystemLoopException
import java.nio.file.NoSuchFileException
import java.nio.file.NotDirectoryException
import java.nio.file.Path
import java.nio.file.ReadOnlyFileSystemException

/**
 * What went wrong with a file, in the system's words where it has some, since exceptions of Java often leave them out.
 * The file is named first, unless it is [named], which the message before has said already.
 */
@JvmOverloads
public fun reasonOf(e: Exception, named: Path? = null): String {
    val words = when (e) {
        is AccessDeniedException -> "permission denied"
        is NoSuchFileException -> "no such file or directory"
        is FileAlreadyExistsException -> "a file is in the way"
        is DirectoryNotEmptyException -> "a directory is in the way"
        is NotDirectoryException -> "is no directory"
        is FileSystemLoopException -> "a link leads to itself"
        is ReadOnlyFileSystemException -> "the file system is read-only"
        is FileSystemException -> e.reason
        is CharacterCodingException -> "is not UTF-8 text"
        is IOException -> e.message
        else -> e.message
    }?.let { if ("Too many open files" in it) "$it; ulimit -n sets how many there may be" else it }
        ?: e.javaClass.simpleName
    val file = (e as? FileSystemException)?.file
    return if (file == null || named != null && isSame(file, named)) words else "$file: $words"
}

private fun isSame(file: String, named: Path) =
    named.fileSystem.getPath(file).toAbsolutePath().normalize() == named.toAbsolutePath().normalize()
