// A program of a user, with the oldest compiler that daphnis is made for. tools/consumers/check.sh runs it.
plugins {
    kotlin("jvm") version "2.2.0"
}
repositories {
    maven(providers.gradleProperty("published").get())
    mavenCentral()
}
dependencies {
    implementation(platform("io.github.daphnis-sim:daphnis-bom:${providers.gradleProperty("daphnis").get()}"))
    implementation("io.github.daphnis-sim:daphnis-core")
    implementation("io.github.daphnis-sim:daphnis-analysis")
}
kotlin {
    compilerOptions { allWarningsAsErrors = true }
}
sourceSets.main { kotlin.srcDir("src") }

tasks.register<Copy>("lib") {
    from(tasks.jar, configurations.runtimeClasspath)
    into(layout.buildDirectory.dir("lib"))
}
