plugins {
    id("u2sa.java-conventions")
}

description = "Service contract (thesis 3.2.1) and its default implementations."

dependencies {
    api(project(":u2sa-messages"))
    api(libs.jackson.xml)
    api(libs.paho)
}
