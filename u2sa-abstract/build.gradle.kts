plugins {
    id("u2sa.java-conventions")
    `java-test-fixtures`
}

description = "U2SAService and its abstract sensor and actuator (thesis 3.2.2)."

dependencies {
    api(project(":u2sa-interfaces"))
    testImplementation(libs.awaitility)
}
