plugins {
    id("u2sa.java-conventions")
}

description = "Service contract (thesis 3.2.1) and its default implementations."

dependencies {
    api(project(":u2sa-messages"))
    implementation(libs.jackson.xml)
    implementation(libs.slf4j)
    implementation(libs.logback)
    implementation(libs.paho)
}
