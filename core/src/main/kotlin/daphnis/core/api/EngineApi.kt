package daphnis.core.api

/**
 * Marks what only engines, their tests and their benchmarks need. It changes with the engines and may change in any
 * version. A program that passes an engine to a simulation, by name or made with its constructor, needs none of it. A
 * program with its own engine opts in with `@OptIn(EngineApi::class)` or the compiler's `-opt-in`.
 */
@RequiresOptIn("Only an engine needs this, and it may change in any version of daphnis.")
@Retention(AnnotationRetention.BINARY)
@Target(AnnotationTarget.CLASS, AnnotationTarget.FUNCTION, AnnotationTarget.PROPERTY, AnnotationTarget.CONSTRUCTOR)
public annotation class EngineApi
