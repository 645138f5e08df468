plugins {
    id("u2sa.java-conventions")
}

description = "Core services (thesis 3.2.3), Communication Manager and launcher."

dependencies {
    api(project(":u2sa-abstract"))
    api(libs.ejml)
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
    api(libs.jmdns)
    api(libs.slf4j)
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.awaitility)
    testImplementation(libs.logback)
}
