plugins {
    id("u2sa.java-conventions")
}

description = "Reports of runs: maps, charts, pages, tables and exports."

dependencies {
    api(project(":u2sa-recorder"))
    api(libs.jackson.core)
    api(libs.geographiclib)
    // Without what draws images and fonts within pictures.
    api(libs.batik.svggen) {
        exclude(group = "org.apache.xmlgraphics", module = "xmlgraphics-commons")
    }
    api(libs.jfreechart)
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.jackson.databind)
}
