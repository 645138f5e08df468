plugins {
    id("u2sa.java-conventions")
}

description = "Data model (thesis 3.2.3): messages, frames and their conversions, codec."

dependencies {
    implementation(libs.jackson.core)
    implementation(libs.jackson.cbor) {
        exclude(group = "com.fasterxml.jackson.core", module = "jackson-databind")
    }
    implementation(libs.geographiclib)
    implementation(libs.proj4j)
}
