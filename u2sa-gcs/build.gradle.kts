plugins {
    id("u2sa.java-conventions")
}

description = "Ground control: what joins a running system."

dependencies {
    api(project(":u2sa-core"))
    api(project(":u2sa-mavlink"))
    api(project(":u2sa-report"))
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.jackson.databind)
    testImplementation(libs.logback)
    testImplementation(libs.awaitility)
}
