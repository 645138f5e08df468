plugins {
    id("com.android.application")
    id("org.jetbrains.kotlin.android")
}

description = "The Android application that carries a vehicle's services (thesis 4.6)."

android {
    namespace = "org.u2sa.android"
    compileSdk = 34
    defaultConfig {
        minSdk = 28
        targetSdk = 34
        versionCode = 1
        versionName = project.version.toString()
    }
    compileOptions {
        sourceCompatibility = JavaVersion.VERSION_17
        targetCompatibility = JavaVersion.VERSION_17
    }
    kotlinOptions {
        jvmTarget = "17"
        allWarningsAsErrors = true
    }
    packaging {
        resources {
            excludes += setOf(
                "META-INF/*.md", "META-INF/LICENSE*", "META-INF/NOTICE*", "META-INF/INDEX.LIST", "META-INF/DEPENDENCIES", "META-INF/*.versions.properties",
                "about.html")
        }
    }
    testOptions {
        unitTests.all {
            it.useJUnitPlatform()
            it.systemProperty("slf4j.provider", "org.slf4j.helpers.NOP_FallbackServiceProvider") // Android's log is not there on a desktop
        }
    }
    sourceSets.getByName("main").assets.srcDir(layout.buildDirectory.dir("vehicle-assets"))
}

// The vehicle's files, by the same paths as ./u2sa apk gives them.
val vehicleAssets = tasks.register<Sync>("vehicleAssets") {
    for (folder in listOf("config/ugv", "missions/ugv")) {
        from(rootProject.file(folder)) { into(folder) }
    }
    into(layout.buildDirectory.dir("vehicle-assets"))
}
tasks.named("preBuild") { dependsOn(vehicleAssets) }

dependencies {
    api(project(":u2sa-estimation"))
    api(project(":u2sa-world"))
    api(project(":u2sa-mission"))
    api(project(":u2sa-planning"))
    api(project(":u2sa-control"))
    api(project(":u2sa-core"))
    api(project(":u2sa-recorder"))
    api(project(":u2sa-drivers"))
    api(libs.kotlin.stdlib)
    api(libs.stax)
    testImplementation(libs.bundles.test)
    testRuntimeOnly(libs.junit.platform.launcher)
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.awaitility)
}
