plugins {
    id("u2sa.java-conventions")
}

description = "World Modeler (thesis 3.2.3): what stands and moves around the vehicle."

dependencies {
    api(project(":u2sa-abstract"))
    testImplementation(libs.jts)
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.logback)
}
