plugins {
    id("u2sa.java-conventions")
}

description = "MAVLink framing and dialect, for drivers and bridges."

dependencies {
    api(libs.mavlink)
}
