plugins {
    alias(libs.plugins.kotlin.jvm)
    `java-library`
}
kotlin { explicitApi() }
dependencies {
    api(project(":core"))
    implementation(libs.lets.plot.kotlin)
    implementation(libs.lets.plot.batik)
    implementation(libs.jcodec)
    testRuntimeOnly(libs.slf4j.nop)
}
