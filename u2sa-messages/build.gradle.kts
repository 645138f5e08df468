plugins {
    id("u2sa.java-conventions")
}

description = "Data model (thesis 3.2.3): messages, frames and their conversions, codec."

dependencies {
    api(libs.jackson.core)
    api(libs.jackson.cbor) {
        exclude(group = "com.fasterxml.jackson.core", module = "jackson-databind")
    }
    api(libs.geographiclib)
    api(libs.proj4j)
    testImplementation(libs.jts)
}
