plugins {
    id("u2sa.java-conventions")
}

description = "Ground control: command line, reports."

dependencies {
    api(project(":u2sa-core"))
    api(libs.picocli)
    testImplementation(testFixtures(project(":u2sa-abstract")))
}
