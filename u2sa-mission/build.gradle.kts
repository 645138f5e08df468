plugins {
    id("u2sa.java-conventions")
}

description = "Mission Manager (thesis 3.2.3): missions, their files and their goals."

dependencies {
    api(project(":u2sa-abstract"))
    api(libs.jts)
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.logback)
}
