package daphnis.app

import com.tngtech.archunit.core.importer.ClassFileImporter
import com.tngtech.archunit.core.importer.ImportOption
import daphnis.core.Repository
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.lang.reflect.Executable
import java.lang.reflect.Method
import java.lang.reflect.Modifier
import java.nio.file.Files
import kotlin.io.path.extension
import kotlin.io.path.readText

/**
 * What Java can call of the libraries: members of companions and objects as static ones, and all that has default
 * arguments also without them. Bytecode says which members there are, and sources which of them are public, since
 * `internal` is public in bytecode.
 */
class JavaCallsTest {
    @Test
    fun `members of companions are static in their class`() {
        val companions = types.mapNotNull { type ->
            type.declaredClasses.find { it.simpleName == "Companion" && "public companion object" in source(type) }
        }
        assertTrue(companions.size > 30) { "only ${companions.size} companions" }
        val missing = companions.flatMap { companion ->
            val static = companion.enclosingClass.declaredMethods.filter { it.isStatic }
            ownMembers(companion).filter { member -> static.none { it.isLike(member) } }
        }
        assertEquals(emptyList<String>(), missing.map(::nameOf))
    }

    @Test
    fun `members of objects are static`() {
        val objects = types.filter { type -> type.declaredFields.any { it.name == "INSTANCE" && it.type == type } }
        assertTrue(objects.size > 10) { "only ${objects.size} objects" }
        assertEquals(emptyList<String>(), objects.flatMap(::ownMembers).filter { !it.isStatic }.map(::nameOf))
    }

    @Test
    fun `functions with default arguments can be called without them`() {
        val defaults = (types + types.flatMap { it.declaredClasses.toList() }).distinct().flatMap { type ->
            type.declaredMethods.filter { it.isSynthetic && it.name.endsWith(DEFAULT) }
        }
        val full = defaults.mapNotNull(::fullOf)
        assertTrue(full.size > 30) { "only ${full.size} functions with default arguments" }
        val missing = full.filter { function ->
            function.declaringClass.declaredMethods.none { it.name == function.name && it.isShorter(function) }
        }
        assertEquals(emptyList<String>(), missing.map(::nameOf))
    }

    @Test
    fun `constructors with default arguments can be called without them`() {
        val full = types.flatMap { type ->
            val synthetic = type.declaredConstructors.filter { it.isSynthetic }
            val defaults = synthetic.filter { it.parameterTypes.lastOrNull()?.name == MARKER }
            val rows = defaults.map { it.parameterTypes.dropLast(2) }
            type.constructors.filter { it.parameterTypes.toList() in rows }
        }
        assertTrue(full.size > 30) { "only ${full.size} constructors with default arguments" }
        val missing = full.filter { one -> one.declaringClass.constructors.none { it.isShorter(one) } }
        assertEquals(INTERNAL_CONSTRUCTORS.toList(), missing.map(::nameOf).sorted())
    }

    /** Public methods that [holder] has neither from its supertypes nor from serialization. */
    private fun ownMembers(holder: Class<*>): List<Method> = holder.declaredMethods.filter { method ->
        method.isPublic &&
            !method.isSynthetic &&
            !method.isMangled &&
            method.name != "serializer" &&
            (listOfNotNull(holder.superclass) + holder.interfaces).none { above ->
                above.methods.any { it.isLike(method) }
            }
    }

    /** The public function whose default arguments [default] fills in, null when it is internal or private. */
    private fun fullOf(default: Method): Method? {
        val name = default.name.removeSuffix(DEFAULT)
        // Data classes have `copy`, which cannot be annotated.
        if (name == "copy") return null
        val type = default.declaringClass
        // The object, the arguments, bits that say which are missing, and a marker.
        val row = default.parameterTypes.toList().dropLast(2)
        val full = type.declaredMethods.find { method ->
            val own = method.parameterTypes.toList()
            method.name == name && method.isPublic && !method.isMangled && (row == own || row == listOf(type) + own)
        }
        return full?.takeIf { isDeclaredPublic(it) }
    }

    private fun isDeclaredPublic(method: Method): Boolean {
        val text = source(method.declaringClass)
        return Regex("""public ([a-z]+ )*fun (<[^>]*> )?(\w+\.)?${method.name}\(""").containsMatchIn(text)
    }

    private companion object {
        const val DEFAULT = "\$default"
        const val MARKER = "kotlin.jvm.internal.DefaultConstructorMarker"

        /** Internal in Kotlin, for tests that set what users cannot. */
        val INTERNAL_CONSTRUCTORS = setOf("RandomPlacement.<init>(int, List, int, Integer, int, long)")

        val Executable.isPublic: Boolean get() = Modifier.isPublic(modifiers)
        val Executable.isStatic: Boolean get() = Modifier.isStatic(modifiers)

        /** Internal members have the module in their name, those with value classes a hash. */
        val Method.isMangled: Boolean get() = '$' in name || '-' in name

        fun Method.isLike(other: Method) = name == other.name && parameterTypes.contentEquals(other.parameterTypes)

        fun Executable.isShorter(other: Executable) =
            isPublic && !isSynthetic && parameterCount == other.parameterCount - 1

        fun nameOf(member: Executable): String {
            val name = if (member is Method) member.name else "<init>"
            val types = member.parameterTypes.joinToString { it.simpleName }
            return "${member.declaringClass.name.substringAfterLast('.')}.$name($types)"
        }

        /** The text of each source file, by its path behind the folder of sources. */
        val sources: Map<String, String> = listOf("core", "actors", "analysis", "analysis/plots").flatMap { module ->
            val root = Repository.root.resolve("$module/src/main/kotlin")
            Files.walk(root).use { paths ->
                paths.filter { it.extension == "kt" }.map { "${root.relativize(it)}" to it.readText() }.toList()
            }
        }.toMap()

        /** By package and name of a type, the text of the file that declares it as public; nested types likewise. */
        val declarations: Map<String, String> = sources.flatMap { (path, text) ->
            val folder = path.substringBeforeLast('/').replace('/', '.')
            Regex("""public ([a-z]+ )*(class|interface|object) (\w+)""").findAll(text)
                .map { "$folder.${it.groupValues[3]}" to text }.toList()
        }.toMap()

        /** The text of the file that declares [type], or whose functions [type] holds; empty when it is not public. */
        fun source(type: Class<*>): String {
            val own = if (type.simpleName == "Companion") type.enclosingClass else type
            if (own.name.endsWith("Kt")) return sources[own.name.removeSuffix("Kt").replace('.', '/') + ".kt"].orEmpty()
            return declarations["${own.packageName}.${own.simpleName}"].orEmpty()
        }

        fun isDeclaredPublic(type: Class<*>): Boolean =
            source(type).isNotEmpty() && type.enclosingClass?.let(::isDeclaredPublic) != false

        val types: List<Class<*>> = ClassFileImporter().withImportOption(ImportOption.DoNotIncludeTests())
            .importPackages("daphnis.core", "daphnis.actors", "daphnis.cluster", "daphnis.analysis")
            .map { Class.forName(it.name, false, JavaCallsTest::class.java.classLoader) }
            .filter { Modifier.isPublic(it.modifiers) && !it.isSynthetic && it.simpleName != "Companion" }
            .filter(::isDeclaredPublic)
    }
}
