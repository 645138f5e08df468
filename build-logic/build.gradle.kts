plugins {
    `java-gradle-plugin`
}

tasks.withType<JavaCompile>().configureEach {
    options.encoding = "UTF-8"
    options.release.set(17)
    options.compilerArgs.addAll(listOf("-Xlint:all,-processing,-classfile", "-Werror"))
}

gradlePlugin {
    plugins {
        create("javaConventions") {
            id = "u2sa.java-conventions"
            implementationClass = "org.u2sa.build.JavaConventionsPlugin"
        }
    }
}
