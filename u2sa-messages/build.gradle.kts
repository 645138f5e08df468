plugins {
    id("u2sa.java-conventions")
}

description = "Data model (thesis 3.2.3): messages, frames and their conversions, codec."

dependencies {
    api(libs.geographiclib)
    api(libs.proj4j)
    testImplementation(libs.jackson.cbor) // older readers, whose sources a test compiles, read by it
    testImplementation(libs.jts)
}
