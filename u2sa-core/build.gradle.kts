plugins {
    id("u2sa.java-conventions")
}

description = "What runs a vehicle: Communication Manager, security, launcher, health, safety."

dependencies {
    api(project(":u2sa-abstract"))
    api(libs.jts)
    api(libs.moquette) {
        exclude(group = "com.librato.metrics")
        exclude(group = "com.bugsnag")
        exclude(group = "com.zaxxer")
        exclude(group = "io.dropwizard.metrics")
        exclude(group = "org.slf4j", module = "slf4j-reload4j")
        exclude(group = "io.netty", module = "netty-transport-native-epoll")
    }
    // Netty, all of it: Moquette was released with an older one.
    api(libs.netty.buffer)
    api(libs.netty.codec)
    api(libs.netty.codec.http)
    api(libs.netty.codec.mqtt)
    api(libs.netty.common)
    api(libs.netty.handler)
    api(libs.netty.resolver)
    api(libs.netty.transport)
    api(libs.netty.transport.native.unix.common)
    api(libs.slf4j)
    testImplementation(project(":u2sa-estimation"))
    testImplementation(project(":u2sa-mission"))
    testImplementation(project(":u2sa-planning"))
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.awaitility)
    testImplementation(libs.logback)
}
