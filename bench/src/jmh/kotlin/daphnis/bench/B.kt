package daphnis.bench
import org.openjdk.jmh.annotations.*
@State(Scope.Benchmark)
open class B { @Benchmark open fun f(): Double = Math.sin(1.0) }
