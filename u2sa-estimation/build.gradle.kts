plugins {
    id("u2sa.java-conventions")
}

description = "State Estimator (thesis 3.2.3): one state of what all sensors measure."

dependencies {
    api(project(":u2sa-abstract"))
    api(libs.ejml)
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.logback)
}
