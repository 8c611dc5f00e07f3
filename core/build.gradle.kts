plugins {
    alias(libs.plugins.kotlin.jvm)
    alias(libs.plugins.kotlin.serialization)
    `java-library`
}
kotlin { explicitApi() }
dependencies {
    api(libs.serialization.json)
    implementation(libs.jhdf)
    testRuntimeOnly(libs.slf4j.nop)
}
