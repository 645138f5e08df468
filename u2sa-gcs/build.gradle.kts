plugins {
    id("u2sa.java-conventions")
}

description = "Ground control: command line, reports."

dependencies {
    api(project(":u2sa-core"))
    api(project(":u2sa-drivers"))
    api(project(":u2sa-sim"))
    api(libs.picocli)
    api(libs.logback)
    testImplementation(testFixtures(project(":u2sa-abstract")))
    api(libs.jackson.core)
    api(libs.geographiclib)
    testImplementation(libs.jackson.databind)
    testImplementation(libs.junit.platform.launcher)
}

// version.properties says ${project.version}, as Maven's filtering understands it.
tasks.processResources {
    val versions = mapOf("project" to mapOf("version" to project.version.toString()))
    inputs.property("versions", versions)
    filesMatching("**/version.properties") {
        expand(versions)
    }
}
