plugins {
    id("u2sa.java-conventions")
}

description = "Campaigns on Apache Spark, which is taken from SPARK_HOME when one begins."

dependencies {
    api(project(":u2sa-trials"))
    // To compile against only: at run time Spark's processes have SPARK_HOME/jars, and ours have none of it.
    compileOnly(libs.spark.core) {
        isTransitive = false
    }
    compileOnly(libs.spark.common.utils) {
        isTransitive = false
    }
    compileOnly(libs.spark.common.utils.java) {
        isTransitive = false
    }
    compileOnly(libs.scala.library) {
        isTransitive = false
    }
    testImplementation(testFixtures(project(":u2sa-abstract")))
    testImplementation(libs.awaitility)
}
