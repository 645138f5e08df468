plugins {
    id("u2sa.java-conventions")
}

description = "Path Planner (thesis 3.2.3): the way to the goal and around obstacles."

dependencies {
    api(project(":u2sa-abstract"))
    testImplementation(project(":u2sa-mission"))
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.logback)
}
