plugins {
    id("u2sa.java-conventions")
}

description = "Control System (thesis 3.2.3): actuator values of ground vehicles and aircraft."

dependencies {
    api(project(":u2sa-abstract"))
    api(libs.ejml)
    testImplementation(project(":u2sa-estimation"))
    testImplementation(project(":u2sa-mission"))
    testImplementation(project(":u2sa-planning"))
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.logback)
}
