package daphnis.app

import com.tngtech.archunit.core.domain.JavaClasses
import com.tngtech.archunit.core.domain.JavaMethod
import com.tngtech.archunit.core.importer.ClassFileImporter
import com.tngtech.archunit.core.importer.ImportOption
import daphnis.actors.ActorEngines
import daphnis.core.Engines
import daphnis.core.Repository
import daphnis.core.format.SnapshotFormats
import daphnis.core.table.TableColumns
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.io.IOException
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

    @Test
    fun `objects that are values can be had without their field`() {
        val values = types.filter { type ->
            type.interfaces.isNotEmpty() && type.declaredFields.any { it.name == "INSTANCE" && it.type == type }
        }
        assertTrue(values.size > 10) { "only ${values.size} objects that are values" }
        val listed = SnapshotFormats.all.toSet<Any>()
        val missing = values.filter { type ->
            val value = type.getField("INSTANCE").get(null)
            value !in listed && value !is TableColumns && type.interfaces.none { above -> value in given(above) }
        }
        assertEquals(emptyList<String>(), missing.map { it.simpleName })
        assertTrue(Engines.factory() === Engines && ActorEngines.factory() === ActorEngines)
    }

    /** What the static functions of [type] without arguments return that are of this type. */
    private fun given(type: Class<*>): List<Any?> = type.declaredMethods
        .filter { it.isStatic && it.parameterCount == 0 && it.returnType == type }.map { it.invoke(null) }

    @Test
    fun `functions of files are in classes with a name`() {
        val files = sources.filterValues { PUBLIC_FUNCTION.containsMatchIn(it) }
        assertTrue(files.size > 10) { "only ${files.size} files with functions" }
        assertEquals(emptySet<String>(), files.filterValues { FILE_NAME.find(it) == null }.keys)
    }

    @Test
    fun `no public function takes or gives a type that only Kotlin makes`() {
        val methods = types.flatMap { it.declaredMethods.toList() }.filter(::isCalled)
        assertTrue(methods.size > 500) { "only ${methods.size} functions" }
        val strange = methods.filter { method ->
            val all = method.genericParameterTypes.toList() + method.genericReturnType
            all.any { type -> OF_KOTLIN.any { it in type.typeName } }
        }
        assertEquals(KOTLIN_ONLY, strange.map(::nameOf).toSet())
    }

    @Test
    fun `what lets an IOException out declares it`() {
        val leaking = Leaks(classes).units
        assertTrue(leaking.size > 20) { "only ${leaking.size} functions that let an IOException out" }
        val silent = leaking.filterIsInstance<JavaMethod>().map { it.reflect() }.filter { method ->
            val mayThrow = method.exceptionTypes.any { it.isAssignableFrom(IOException::class.java) }
            !mayThrow && isCalled(method) && !overrides(method)
        }
        assertEquals(emptyList<String>(), silent.map(::nameOf).sorted())
    }

    /** Whether a user calls [method]. */
    private fun isCalled(method: Method): Boolean = method.isPublic &&
        !method.isSynthetic &&
        !method.isMangled &&
        method.declaringClass in types &&
        isDeclaredPublic(method)

    private fun overrides(method: Method): Boolean =
        (listOfNotNull(method.declaringClass.superclass) + method.declaringClass.interfaces)
            .any { above -> above.methods.any { it.isLike(method) } }

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
        val own = Regex("""public ([a-z]+ )*fun (<[^>]*> )?(\w+\.)?${method.name}\(""").containsMatchIn(text)
        return own || "@JvmName(\"${method.name}\")" in text
    }

    private companion object {
        const val DEFAULT = "\$default"
        const val MARKER = "kotlin.jvm.internal.DefaultConstructorMarker"

        val FILE_NAME = Regex("""^@file:JvmName\("(\w+)"\)""")
        val PUBLIC_FUNCTION = Regex("""^public ((const|inline) )*(fun|val) (?!interface)""", RegexOption.MULTILINE)

        /** Parts of the names of types that Java cannot make well. */
        val OF_KOTLIN =
            listOf("kotlin.jvm.functions", "kotlin.sequences", "kotlin.coroutines", "kotlin.Pair", "kotlin.Unit")

        /** What has another way for Java, or is called by the functions beside it alone. */
        val KOTLIN_ONLY = setOf(
            "RegionActorEngine.advanceSuspending(CollisionStep, Continuation)",
            "RegionMap.forEachStretch(int, Function2)",
            // Inline, so that words are made only where something is wrong; `fail` is for Java.
            "ValueCheck.must(String, boolean, Function0)",
            "ValueCheck.that(String, Object, boolean, Function0)",
            "Vtp.writeIndex(List, Path)",
            "WritableFormat.export(Sequence, Path, ExportOptions)",
        )

        /** Internal in Kotlin, for tests that set what users cannot. */
        val INTERNAL_CONSTRUCTORS = setOf(
            "RandomPlacement.<init>(int, List, int, Integer, int, long)",
            "WallSet.<init>(List, List, double, long, Space)",
        )

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

        /**
         * By package and name of a type, the text of the file that declares it as public; nested types likewise, and
         * the types that hold the functions of files.
         */
        val declarations: Map<String, String> = sources.flatMap { (path, text) ->
            val folder = path.substringBeforeLast('/').replace('/', '.')
            val types = Regex("""public ([a-z]+ )*(class|interface|object) (\w+)""").findAll(text)
            val names = types.map { it.groupValues[3] } + FILE_NAME.findAll(text).map { it.groupValues[1] }
            names.map { "$folder.$it" to text }.toList()
        }.toMap()

        /** The text of the file that declares [type], or whose functions [type] holds; empty when it is not public. */
        fun source(type: Class<*>): String {
            val own = if (type.simpleName == "Companion") type.enclosingClass else type
            return declarations["${own.packageName}.${own.simpleName}"].orEmpty()
        }

        fun isDeclaredPublic(type: Class<*>): Boolean =
            source(type).isNotEmpty() && type.enclosingClass?.let(::isDeclaredPublic) != false

        val classes: JavaClasses = ClassFileImporter().withImportOption(ImportOption.DoNotIncludeTests())
            .importPackages("daphnis.core", "daphnis.actors", "daphnis.cluster", "daphnis.analysis")

        val types: List<Class<*>> = classes
            .map { Class.forName(it.name, false, JavaCallsTest::class.java.classLoader) }
            .filter { Modifier.isPublic(it.modifiers) && !it.isSynthetic && it.simpleName != "Companion" }
            .filter(::isDeclaredPublic)
    }
}
