plugins {
    id("u2sa.java-conventions")
}

description = "Data model (thesis 3.2.3): messages, frames and their conversions, codec."

dependencies {
    api(libs.geographiclib)
    api(libs.proj4j)
    // Older readers, whose sources a test compiles, read by it.
    testImplementation(libs.jackson.cbor)
    testImplementation(libs.jts)
}
