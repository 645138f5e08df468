plugins {
    id("u2sa.java-conventions")
}

description = "The command line."

dependencies {
    api(project(":u2sa-control"))
    api(project(":u2sa-core"))
    api(project(":u2sa-gcs"))
    api(project(":u2sa-mission"))
    api(project(":u2sa-report"))
    api(libs.picocli)
    api(libs.logback)
    testImplementation(project(":u2sa-estimation"))
    testImplementation(project(":u2sa-planning"))
    testImplementation(project(":u2sa-sim"))
    testImplementation(project(":u2sa-world"))
    testImplementation(testFixtures(project(":u2sa-abstract")))
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
    from(rootDir) { // projects for Gradle get this project's own wrapper
        include("gradlew", "gradlew.bat", "gradle/wrapper/*")
        into("org/u2sa/cli/template/templates/gradle")
    }
}
